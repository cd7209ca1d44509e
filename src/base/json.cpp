// SPDX-License-Identifier: MIT
#include "base/json.h"

#include <cstddef>
#include <set>
#include <vector>

namespace polhode {

Json parse_foreign_json(const std::string& text) {
  constexpr std::size_t kDeepest = 100, kMostKeys = 10'000;
  std::vector<std::set<std::string>> keys;  // so far, of each level around
  bool is_sound = true;
  const auto keep = [&](int, Json::parse_event_t event, const Json& value) {
    using Event = Json::parse_event_t;
    if (event == Event::object_start || event == Event::array_start) keys.emplace_back();
    if (event == Event::object_end || event == Event::array_end) keys.pop_back();
    if (event == Event::key) {
      is_sound = is_sound && keys.back().insert(value).second && keys.back().size() <= kMostKeys;
    }
    is_sound = is_sound && keys.size() <= kDeepest;
    return is_sound;
  };
  Json value = Json::parse(text, keep, false);
  if (!is_sound || value.is_discarded()) return nullptr;
  return value;
}

}  // namespace polhode
