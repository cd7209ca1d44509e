// SPDX-License-Identifier: MIT
#include "lecture/inlines.h"

#include <string>

#include "lecture/deck.h"

namespace polhode {
namespace {

class Collector {
 public:
  explicit Collector(const Json& between) : between_(between) {}

  void add_blocks(const Json& blocks) {
    for (const Json& block : blocks)
      add(block);
  }
  Json all = Json::array();

 private:
  void add_line(const Json& inlines) {
    if (inlines.empty()) return;
    if (!all.empty()) all.push_back(between_);
    all.insert(all.end(), inlines.begin(), inlines.end());
  }

  void add(const Json& block) {
    const std::string type = block["t"];
    if (type == "Para" || type == "Plain") {
      add_line(block["c"]);
    } else if (type == "Header") {
      add_line(block["c"][2]);
    } else if (type == "LineBlock") {
      for (const Json& line : block["c"])
        add_line(line);
    } else if (type == "CodeBlock") {
      add_code(block["c"][1]);
    } else if (type == "BlockQuote") {
      add_blocks(block["c"]);
    } else if (type == "Div") {
      add_blocks(block["c"][1]);
    } else if (type == "BulletList" || type == "OrderedList") {
      add_list(block);
    } else if (type == "DefinitionList") {
      for (const Json& item : block["c"]) {
        add_line(item[0]);
        for (const Json& definition : item[1])
          add_blocks(definition);
      }
    } else if (type == "Table") {
      add_table(block["c"]);
    }
  }

  void add_code(const std::string& code) {
    const Json none = Json::array({"", Json::array(), Json::array()});
    for (std::size_t from = 0; from <= code.size();) {
      const std::size_t end = std::min(code.find('\n', from), code.size());
      const std::string line = code.substr(from, end - from);
      add_line(Json::array({{{"t", "Code"}, {"c", {none, line}}}}));
      from = end + 1;
    }
  }

  void add_list(const Json& list) {
    const bool ordered = list["t"] == "OrderedList";
    int number = ordered ? list["c"][0][0].get<int>() : 0;
    for (const Json& item : ordered ? list["c"][1] : list["c"]) {
      Json line = string_inlines(ordered ? fmt::format("{}.", number++) : "•");
      line.push_back({{"t", "Space"}});
      const Json words = inlines_of(item, between_);
      line.insert(line.end(), words.begin(), words.end());
      add_line(line);
    }
  }

  // attributes, caption, columns, head, bodies, foot
  void add_table(const Json& table) {
    add_blocks(table[1][1]);
    add_rows(table[3][1]);
    for (const Json& body : table[4]) {
      add_rows(body[2]);
      add_rows(body[3]);
    }
    add_rows(table[5][1]);
  }

  void add_rows(const Json& rows) {
    for (const Json& row : rows) {
      Json line = Json::array();
      for (const Json& cell : row[1]) {
        if (!line.empty()) {
          const Json bar = string_inlines(" | ");
          line.insert(line.end(), bar.begin(), bar.end());
        }
        const Json words = inlines_of(cell[4], between_);
        line.insert(line.end(), words.begin(), words.end());
      }
      add_line(line);
    }
  }

  const Json& between_;
};

}  // namespace

Json inlines_of(const Json& blocks, const Json& between) {
  Collector collector(between);
  collector.add_blocks(blocks);
  return std::move(collector.all);
}

}  // namespace polhode
