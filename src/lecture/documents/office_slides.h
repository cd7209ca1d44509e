// SPDX-License-Identifier: MIT
// Lays a deck out on the slides of PowerPoint. Of a slide with more than words beside one picture
// or table, or two columns, pandoc leaves out what does not fit.
#pragma once

#include <map>
#include <string>

#include "lecture/deck/deck.h"

namespace polhode {

struct OfficeSlides {
  // Blocks of pandoc's tree, with a kPictureNode for each picture. A slide that is divided repeats
  // its title; pictures inside lists, quotations and boxes stand behind these.
  Json blocks = Json::array();
  // The identifier of the title of the slide on which a place is, by the place; only that leads to
  // a slide. Places before the first title have none.
  std::map<std::string, std::string> titles;
};

// The slides of a deck, in its order.
OfficeSlides office_slides(const Deck& deck);

}  // namespace polhode
