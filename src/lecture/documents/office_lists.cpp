// SPDX-License-Identifier: MIT
#include "lecture/documents/office_lists.h"

#include "lecture/deck/tree.h"

namespace polhode {
namespace {

constexpr long kGreatestStart = 32767;  // ECMA-376 part 1, 20.1.10.81: ST_TextBulletStartAtNum

bool is_ordered(const Json& block) {
  return block["t"] == "OrderedList";
}

bool can_be_counted(const Json& list) {
  const long start = list["c"][0][0];
  return start >= 1 && start <= kGreatestStart;
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

class Numbers {
 public:
  Json of(const Json& blocks, bool in_notes, bool in_columns = false) const {
    Json out = Json::array();
    for (Json block : blocks) {
      if (is_ordered(block) && (in_notes || !can_be_counted(block))) {
        for (Json& one : of(blocks_of_list(block), in_notes))
          out.push_back(std::move(one));
        continue;
      }
      settle_inside(block, in_notes);
      if (!in_columns && !out.empty() && would_be_one(out.back(), block))
        out.push_back(paragraph(string_inlines("\u00a0")));
      out.push_back(std::move(block));
    }
    return out;
  }

 private:
  void settle_inside(Json& block, bool in_notes) const {
    const std::string type = block["t"];
    Json& content = block["c"];
    if (type == "Div") {
      content[1] = of(content[1], in_notes || is_div(block, "notes"), is_div(block, "columns"));
    } else if (type == "BlockQuote") {
      content = of(content, in_notes);
    } else if (type == "BulletList" || type == "OrderedList") {
      for (Json& item : type == "BulletList" ? content : content[1])
        item = of(item, in_notes);
    } else if (type == "DefinitionList") {
      for (Json& item : content)
        for (Json& definition : item[1])
          definition = of(definition, in_notes);
    }
  }
};

}  // namespace

Json with_numbers_of_lists(const Json& blocks) {
  return Numbers().of(blocks, false);
}

}  // namespace polhode
