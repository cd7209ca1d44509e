// SPDX-License-Identifier: MIT
#include "scene/golden_file.h"

#include <algorithm>
#include <set>

#include "base/error.h"
#include "base/one_line.h"
#include "base/system/atomic_file.h"
#include "scene/reader.h"
#include "scene/scene_tree.h"
#include "scene/toml_text.h"

namespace polhode {
namespace {

template <class Spec>
Spec load(const std::filesystem::path& file) {
  const std::string name = file.string();
  const toml::table tree =
      parse_toml(read_file(file, kLargestScene), name, "it needs the keys of golden pictures");
  Spec spec;
  Reader reader(tree, {name, 0, {}}, keys_of<Spec>());
  reader.read_tables({tree, {name, 0, {}}, suffixes_of(Unit::none).front()}, spec);
  return spec;
}

// text as a basic string of TOML
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      out += c;
    }
  }
  return out + "\"";
}

// a number that TOML and the reader take back as it was
std::string number(double value) {
  return fmt::format("{}", value);
}

}  // namespace

bool is_plain_name(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
           c == '-';
  });
}

GoldenFile load_golden_file(const std::filesystem::path& file) {
  GoldenFile golden = load<GoldenFile>(file);
  std::set<std::string> names;
  const toml::table tree = read_tree(file);
  for (std::size_t i = 0; i < golden.cases.size(); ++i) {
    const GoldenCase& one = golden.cases[i];
    const toml::node* name = tree["case"][i]["name"].node();
    const Place place{file.string(),
                      name != nullptr ? static_cast<int>(name->source().begin.line) : 0,
                      fmt::format("case[{}].name", i)};
    if (!is_plain_name(one.name)) {
      throw input_error("must be letters, digits, _ and -, found '{}'", cut(one.name)).at(place);
    }
    if (!names.insert(one.name).second) {
      throw input_error("there are two cases '{}'", one.name).at(place);
    }
  }
  return golden;
}

GoldenSidecar load_golden_sidecar(const std::filesystem::path& file) {
  return load<GoldenSidecar>(file);
}

std::string sidecar_text(const GoldenSidecar& s) {
  std::string text =
      "# Written by `polhode golden update`: what drew the picture beside it, and how to compare "
      "with it.\n";
  text += fmt::format("format = {}\n", s.format);
  for (const auto& [key, value] : {std::pair{"cause", &s.cause},
                                   {"polhode", &s.polhode},
                                   {"backend", &s.backend},
                                   {"renderer", &s.renderer},
                                   {"opengl", &s.opengl},
                                   {"llvm", &s.llvm},
                                   {"cpu_vendor", &s.cpu_vendor}}) {
    if (!value->empty()) text += fmt::format("{} = {}\n", key, quoted(*value));
  }
  text += fmt::format("samples = {}\n\n[verdict]\n", s.samples);
  const Thresholds& t = s.verdict.thresholds;
  text += fmt::format("max = {}\nfraction = {}\nlimit = {}\n", t.max, number(t.fraction), t.limit);
  if (t.ssim) text += fmt::format("ssim = {}\n", number(*t.ssim));
  if (t.flip) text += fmt::format("flip = {}\n", number(*t.flip));
  text += fmt::format("reason = {}\n", quoted(s.verdict.reason));
  return text;
}

}  // namespace polhode
