// SPDX-License-Identifier: MIT
// Mutates scenes: a third of the time as bytes, as libFuzzer does, else line by line with keys and
// values that the schema of the scene allows, or nearly allows.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/json.h"
#include "scene/schema.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace polhode {
namespace {

const Json& schema() {
  static const Json all = scene_schema();
  return all;
}

class SceneMutator {
 public:
  explicit SceneMutator(unsigned seed) : random_(seed) {}

  std::string mutated(const std::string& text) {
    if (one_in(50)) return table_lines(schema());
    std::vector<std::string> lines = lines_of(text);
    for (std::size_t changes = 1 + below(3); changes > 0; --changes)
      change(lines);
    return fmt::format("{}\n", fmt::join(lines, "\n"));
  }

 private:
  // 0 to n - 1; n is positive
  std::size_t below(std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_);
  }
  bool one_in(std::size_t n) { return below(n) == 0; }
  template <class List>
  const auto& any_of(const List& list) {
    return *std::next(list.begin(), static_cast<std::ptrdiff_t>(below(list.size())));
  }

  static std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t from = 0; from < text.size();) {
      const std::size_t end = std::min(text.find('\n', from), text.size());
      lines.push_back(text.substr(from, end - from));
      from = end + 1;
    }
    return lines;
  }

  void change(std::vector<std::string>& lines) {
    const std::size_t place = below(lines.size() + 1);
    const bool inside = place < lines.size();
    switch (below(7)) {
      case 0:
        if (inside) lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(place));
        break;
      case 1:
        if (inside) lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(place), any_of(lines));
        break;
      case 2:
      case 3:
        if (inside) replace_value(lines[place]);
        break;
      case 4:
        if (one_in(4))
          lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(place), film_line());
        break;
      // a dotted key belongs to the table that is open: at the beginning it is that of the scene
      default:
        lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(one_in(4) ? place : 0),
                     random_line());
    }
  }

  // another value for the key of this line, if a table of the schema has one of this name
  void replace_value(std::string& line) {
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos) return;
    const std::size_t begin = line.find_first_not_of(" \t"),
                      end = line.find_last_not_of(" \t", equals - 1);
    if (equals == 0 || end == std::string::npos || begin > end) return;
    std::string name = line.substr(begin, end + 1 - begin);
    if (const std::size_t dot = name.rfind('.'); dot != std::string::npos) name.erase(0, dot + 1);
    std::vector<const Json*> found;
    collect(schema(), name, found);
    if (!found.empty()) line = line.substr(0, equals + 1) + " " + value(*any_of(found), 0);
  }

  static void collect(const Json& table, const std::string& name, std::vector<const Json*>& found) {
    if (!table.is_object()) return;
    if (table.contains("items")) collect(table["items"], name, found);
    if (!table.contains("properties")) return;
    for (const auto& [key, inside] : table["properties"].items()) {
      if (key == name) found.push_back(&inside);
      collect(inside, name, found);
    }
  }

  // "body.solid.radius_cm = 3": a walk down the tables
  std::string random_line() {
    std::string path;
    const Json* node = &schema();
    while (node->contains("properties") && (path.empty() || !one_in(4))) {
      const auto& properties = (*node)["properties"];
      const auto step = std::next(properties.items().begin(),
                                  static_cast<std::ptrdiff_t>(below(properties.size())));
      path += (path.empty() ? "" : ".") + step.key();
      node = &properties[step.key()];
    }
    return path + " = " + value(*node, 0);
  }

  // a line of a film file: its keys are not in the schema of scenes
  std::string film_line() {
    static constexpr std::array<const char*, 8> kScenes = {"heavy_top.toml",
                                                           "free_symmetric_top.toml",
                                                           "tippe_top.toml",
                                                           "ball_on_a_turntable.toml",
                                                           "spin_in_steps.toml",
                                                           "gyrocompass.toml",
                                                           "none.toml",
                                                           "../README.md"};
    static constexpr std::array<const char*, 8> kKeys = {"motion.duration",
                                                         "motion.spin.rates[2]",
                                                         "motion.friction",
                                                         "motion.attitude.zxz_deg[1]",
                                                         "show.trail",
                                                         "numerics.method",
                                                         "body.solid",
                                                         "video.fps"};
    const std::string scene = fmt::format("scene = \"{}\"\n", any_of(kScenes));
    const std::string list = fmt::format("[{}, {}]", number(Json()), number(Json()));
    switch (below(5)) {
      case 0:
        return "[[panel]]\n" + scene;
      case 1:
        return fmt::format("[sweep]\n{}key = \"{}\"\nvalues = {}\n", scene, any_of(kKeys), list);
      case 2:
        return one_in(2) ? "arrange = \"in_turn\"" : "arrange = \"side_by_side\"";
      case 3:
        return fmt::format("set = {{ \"{}\" = {} }}", any_of(kKeys), number(Json()));
      default:
        return fmt::format(
            R"({} = "{}")", one_in(2) ? "cameras" : "scales", one_in(2) ? "own" : "same");
    }
  }

  // a whole scene
  std::string table_lines(const Json& table) {
    std::string text;
    for (const auto& [key, inside] : table["properties"].items()) {
      if (is_required(table, key) || one_in(2))
        text += fmt::format("{} = {}\n", key, value(inside, 0));
    }
    return text;
  }

  static bool is_required(const Json& table, const std::string& key) {
    if (!table.contains("required")) return false;
    const Json& names = table["required"];
    return std::find(names.begin(), names.end(), key) != names.end();
  }

  std::string value(const Json& node, int depth) {
    if (one_in(40)) return stray_value();
    if (node.contains("anyOf")) return value(any_of(node["anyOf"]), depth);
    if (node.contains("enum")) return any_of(node["enum"]).dump();
    const std::string type = node.value("type", "");
    if (type == "boolean") return one_in(2) ? "true" : "false";
    if (type == "number" || type == "integer") return number(node);
    if (type == "array") return list(node, depth);
    if (type == "object") return table(node, depth);
    return text();
  }

  std::string table(const Json& node, int depth) {
    std::string inside;
    const auto& properties = node["properties"];
    // few keys: most of them exclude each other
    const std::size_t sparse = std::max<std::size_t>(1, properties.size() / 3);
    for (const auto& [key, child] : properties.items()) {
      if (!is_required(node, key) && (depth > 4 || !one_in(sparse))) continue;
      inside += fmt::format("{}{} = {}", inside.empty() ? "" : ", ", key, value(child, depth + 1));
    }
    return "{ " + inside + " }";
  }

  std::string list(const Json& node, int depth) {
    const std::size_t least = node.value("minItems", std::size_t{1}),
                      most = std::min(node.value("maxItems", least + 3), least + 6);
    std::string inside;
    const std::size_t count = one_in(30) ? below(12) : least + below(most - least + 1);
    for (std::size_t i = 0; i < count; ++i)
      inside += (i == 0 ? "" : ", ") + value(node["items"], depth + 1);
    return "[" + inside + "]";
  }

  std::string number(const Json& node) {
    static constexpr std::array<const char*, 20> kNumbers = {
        "0",    "1",     "-1",   "2",    "3.0",   "0.5",  "1e-3", "1e3", "1e-300", "1e300",
        "-0.0", "1e-12", "1e12", "1e30", "1e-30", "1e15", "0.1",  "10",  "nan",    "inf"};
    if (one_in(6) && node.contains("minimum")) return node["minimum"].dump();
    if (one_in(6) && node.contains("maximum")) return node["maximum"].dump();
    if (one_in(2)) return any_of(kNumbers);
    // all magnitudes, mostly those of a classroom
    const double power = one_in(5) ? std::uniform_real_distribution<>(-40, 40)(random_)
                                   : std::uniform_real_distribution<>(-2, 2)(random_);
    return fmt::format("{}{:.17g}", one_in(3) ? "-" : "", std::pow(10.0, power));
  }

  std::string text() {
    static constexpr std::array<const char*, 12> kTexts = {R"("")",
                                                           R"("#a0b1c2")",
                                                           R"("0.1px")",
                                                           R"("1e-9")",
                                                           R"("30000/1001")",
                                                           R"("64x36")",
                                                           R"("wing_nut.obj")",
                                                           R"("../README.md")",
                                                           R"("<b>&amp;ω")",
                                                           R"("a\nb\u0000")",
                                                           R"("16384x16")",
                                                           R"("1")"};
    return any_of(kTexts);
  }

  std::string stray_value() {
    static constexpr std::array<const char*, 7> kStray = {
        "{}", "[]", "1979-05-27", "[[1]]", "\"x\"", "9223372036854775807", "[{}]"};
    return any_of(kStray);
  }

  std::mt19937 random_;
};

}  // namespace
}  // namespace polhode

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data,
                                               std::size_t size,
                                               std::size_t most,
                                               unsigned seed) {
  if (seed % 3 == 0) return LLVMFuzzerMutate(data, size, most);
  const std::string text(data, data + size);
  const std::string changed = polhode::SceneMutator(seed).mutated(text);
  if (changed.size() > most) return LLVMFuzzerMutate(data, size, most);
  std::memcpy(data, changed.data(), changed.size());
  return changed.size();
}
