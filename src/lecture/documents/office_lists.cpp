// SPDX-License-Identifier: MIT
#include "lecture/documents/office_lists.h"

#include <algorithm>
#include <utility>

#include "lecture/deck/tree.h"

namespace polhode {
namespace {

// ECMA-376 part 1, 20.1.10.81 (ST_TextBulletStartAtNum) and 20.1.10.82 (ST_TextIndentLevelType)
constexpr long kGreatestStart = 32767;
constexpr int kLevels = 9;

bool is_ordered(const Json& node) {
  return node["t"] == "OrderedList";
}

// Whether PowerPoint counts the items: each has words, which bear the number.
bool can_be_counted(const Json& list) {
  const long start = list["c"][0][0];
  const Json& items = items_of(list);
  return start >= 1 && start <= kGreatestStart &&
         std::all_of(items.begin(), items.end(), begins_with_words);
}

// Where a list begins or ends what is seen of a block: how it is numbered. Null: no such list.
Json numbering_at(const Json& block, bool end) {
  const std::string type = block["t"];
  if (is_ordered(block)) return block["c"][0];
  if (type != "Div" && type != "BlockQuote") return nullptr;
  const Json& inside = type == "Div" ? block["c"][1] : block["c"];
  if (inside.empty()) return nullptr;
  return numbering_at(end ? inside.back() : inside.front(), end);
}

bool would_be_one(const Json& above, const Json& below) {
  const Json numbering = numbering_at(above, true);
  return !numbering.is_null() && numbering == numbering_at(below, false);
}

// Walks through a tree; lists and boxes stand in lists of blocks alone.
class ListNumbers {
 public:
  void settle(Json& tree) {
    if (tree.is_array()) {
      settle_list(tree);
    } else if (tree.is_object() && tree.contains("c")) {
      settle_inside(tree);
    }
  }

 private:
  static bool is_list(const Json& child) {
    return child.is_object() && (child["t"] == "OrderedList" || child["t"] == "BulletList");
  }

  bool becomes_words(const Json& list) const {
    return levels_ >= kLevels || (is_ordered(list) && (in_notes_ || !can_be_counted(list)));
  }

  void settle_list(Json& list) {
    const bool are_columns = std::exchange(in_columns_, false);
    Json out = Json::array();
    for (Json& child : list) {
      if (is_list(child) && becomes_words(child)) {
        Json blocks = blocks_of_list(child);
        settle(blocks);
        out.insert(out.end(), blocks.begin(), blocks.end());
        continue;
      }
      settle(child);
      const bool follows = !are_columns && !out.empty() && out.back().is_object() &&
                           child.is_object() && would_be_one(out.back(), child);
      if (follows) out.push_back(paragraph(string_inlines("\u00a0")));
      out.push_back(std::move(child));
    }
    list = std::move(out);
  }

  void settle_inside(Json& node) {
    const bool was_in_notes = std::exchange(in_notes_, in_notes_ || is_div(node, "notes"));
    levels_ += is_list(node) ? 1 : 0;
    if (node["t"] == "Div") {
      in_columns_ = is_div(node, "columns");
      settle(node["c"][1]);
    } else {
      settle(node["c"]);
    }
    levels_ -= is_list(node) ? 1 : 0;
    in_notes_ = was_in_notes;
  }

  bool in_notes_ = false, in_columns_ = false;  // is that what is settled, or settled next
  int levels_ = 0;                              // of lists around it
};

}  // namespace

void settle_numbers_of_lists(Json& blocks) {
  ListNumbers().settle(blocks);
}

}  // namespace polhode
