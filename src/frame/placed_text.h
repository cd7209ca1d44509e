// SPDX-License-Identifier: MIT
// Where the text of a picture stands, and in what style.
#pragma once

#include <optional>
#include <string>

#include "frame/labels.h"
#include "text/typesetter.h"

namespace polhode {

// What a text is for.
enum class TextRole { title, caption, clock, note, plot, label };

// A text of a picture. Positions are in pixels of the frame.
struct PlacedText {
  TextRole role = TextRole::label;
  std::string markup;
  TextStyle style;
  TextRoom room;                       // of its ink
  double opacity = 1.0;                // 0..1
  std::optional<Vec2> tip = {};        // visible end of the arrow whose name it is
  std::optional<Vec2> whole_tip = {};  // of that arrow, where others or the frame may hide it
  std::optional<Leader> leader = {};   // the line from a name to that tip
};

}  // namespace polhode
