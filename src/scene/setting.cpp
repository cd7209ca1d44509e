// SPDX-License-Identifier: MIT
#include "scene/setting.h"

#include "base/error.h"
#include "scene/toml_text.h"

namespace polhode {

Setting parse_setting(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos) {
    throw input_error("'{}' is no KEY=VALUE; write motion.spin.body[2]=40 or the like",
                      cut(text, 60));
  }
  const auto trimmed = [](const std::string& part) {
    const std::size_t first = part.find_first_not_of(" \t");
    return first == std::string::npos
               ? std::string()
               : part.substr(first, part.find_last_not_of(" \t") + 1 - first);
  };
  return {trimmed(text.substr(0, equals)), trimmed(text.substr(equals + 1))};
}

std::string option_of(const Setting& setting) {
  return "--set " + setting.key;
}

}  // namespace polhode
