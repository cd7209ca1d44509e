// SPDX-License-Identifier: MIT
#include "base/json.h"

namespace polhode {

Json parse_foreign_json(const std::string& text) {
  constexpr int kDeepest = 100;
  bool is_deep = false;
  const auto keep = [&](int depth, Json::parse_event_t, const Json&) {
    is_deep = is_deep || depth > kDeepest;
    return !is_deep;
  };
  Json value = Json::parse(text, keep, false);
  if (is_deep || value.is_discarded()) return nullptr;
  return value;
}

}  // namespace polhode
