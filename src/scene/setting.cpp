// SPDX-License-Identifier: MIT
#include "scene/setting.h"

#include "base/error.h"
#include "base/name_list.h"
#include "base/one_line.h"
#include "scene/toml_text.h"

namespace polhode {

Setting parse_setting(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos) {
    throw input_error("'{}' is no KEY=VALUE; write motion.spin.body[2]=40 or the like",
                      cut(text, 60));
  }
  const auto part = [&](std::size_t from, std::size_t length) {
    return std::string(trimmed(std::string_view(text).substr(from, length), " \t"));
  };
  Setting setting{part(0, equals), part(equals + 1, std::string::npos)};
  if (setting.value.empty()) {
    throw input_error(
        "{} has no value after its '='; an empty text is {}='\"\"'", setting.key, setting.key);
  }
  return setting;
}

std::string option_of(const Setting& setting) {
  return "--set " + setting.key;
}

}  // namespace polhode
