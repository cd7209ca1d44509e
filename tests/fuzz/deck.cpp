// SPDX-License-Identifier: MIT
// Decks, from the JSON tree that pandoc makes of them. The bytes of the tree also stand for the
// text of the deck, in which lines are looked up.
#include "lecture/deck/deck.h"

#include "base/error.h"
#include "fuzz/harness.h"
#include "lecture/deck/pandoc.h"
#include "lecture/deck/quotes.h"

namespace polhode {
namespace {

// a part of what `inspect` says, with every kind of value
const Json& inspection() {
  static const Json facts = {
      {"title", "Free top"},
      {"mass_kg", 1.5},
      {"principal_moments_kg_m2", {1.0, 2.0, 3.0}},
      {"principal_axes", {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}},
      {"evaluations_of_ode", nullptr},
      {"derived", {{"flip_time_s", 1e-300}, {"energy_J", -1e300}, {"is_stable", true}}}};
  return facts;
}

}  // namespace

void run_harness(const std::string& bytes) {
  // this node is Polhode's own; no deck makes pandoc write it
  if (bytes.find(kPictureNode) != std::string::npos) return;
  Deck deck = deck_of_tree(parse_tree(bytes), bytes, "deck.md", {"/nonexistent", false});
  quoted_scenes(deck);
  fill_quotes(deck, bytes, [](const std::string&) -> const Json& { return inspection(); });
  for (const DeckPicture& picture : deck.pictures)
    plain_text(picture.caption);
  const Json blocks = with_pictures(
      deck.blocks,
      [](const DeckPicture& picture) { return Json::array({paragraph(picture.caption)}); },
      deck);
  deck.tree(blocks).dump();
}

}  // namespace polhode
