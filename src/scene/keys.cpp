// SPDX-License-Identifier: MIT
#include "scene/keys.h"

#include <algorithm>

#include "base/check.h"

namespace polhode {
namespace {

bool contains(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

// "" is the root, "body" a table of its own, deeper ones are named by their path
std::string title_of(const std::string& path) {
  if (path.empty()) return "the top of the file";
  return path.find('.') == std::string::npos ? "[" + path + "]" : path;
}

void gather(const std::string& spelling,
            const KeyList& list,
            const std::string& path,
            std::vector<std::string>& found) {
  if (contains(list.all_spellings(), spelling)) found.push_back(title_of(path));
  for (const Key& key : list.keys) {
    if (!key.inside) continue;
    std::string inside = path;
    if (!path.empty()) inside += '.';
    inside += key.many ? key.name + "[]" : key.name;
    gather(spelling, *key.inside, inside, found);
  }
}

}  // namespace

std::vector<Spelling> spellings_of(const std::string& name, const Doc& doc) {
  std::vector<Spelling> spellings;
  for (const UnitSuffix& unit : suffixes_of(doc.unit))
    spellings.push_back({name + unit.suffix, unit});
  return spellings;
}

const Key& KeyList::find(const std::string& name) const {
  const auto key = std::find_if(
      keys.begin(), keys.end(), [&](const Key& candidate) { return candidate.name == name; });
  CHECK(key != keys.end());
  return *key;
}

std::vector<std::string> KeyList::all_spellings() const {
  std::vector<std::string> all;
  for (const Key& key : keys) {
    for (const Spelling& spelling : spellings_of(key.name, key.doc))
      all.push_back(spelling.text);
  }
  return all;
}

std::vector<std::string> tables_with(const std::string& spelling, const KeyList& root) {
  std::vector<std::string> found;
  gather(spelling, root, "", found);
  return found;
}

}  // namespace polhode
