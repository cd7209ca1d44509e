// SPDX-License-Identifier: MIT
#include "lecture/deck/sandbox.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "base/color.h"
#include "base/error.h"
#include "scene/scene_file.h"

namespace polhode {
namespace {

bool is_control(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte < 0x20 || byte == 0x7F;
}

bool is_inside(const std::filesystem::path& file, const std::filesystem::path& folder) {
  const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  static_cast<void>(rest);
  return end == folder.end();
}

}  // namespace

bool may_leave(const std::filesystem::path& name) {
  return name.is_absolute() || std::find(name.begin(), name.end(), "..") != name.end();
}

std::filesystem::path trusted_file(const DeckRoot& root,
                                   const std::filesystem::path& from,
                                   const std::string& name) {
  if (name.empty() || std::any_of(name.begin(), name.end(), is_control))
    throw input_error("a file name is empty or has control characters");
  const std::filesystem::path asked = name;
  if (!root.allow_outside && may_leave(asked)) {
    const auto within = (from.lexically_relative(root.folder) / asked).lexically_normal();
    const bool leaves = asked.is_absolute() || *within.begin() == "..";
    throw input_error("'{}' {}, or give --allow-outside",
                      name,
                      leaves ? "leaves the deck's folder; put the file inside it"
                             : "has '..'; put the file into the folder that names it, or below");
  }
  std::filesystem::path file = from / asked;
  std::error_code failed;
  const std::filesystem::path real = std::filesystem::canonical(file, failed);
  if (failed) throw input_error("'{}' does not exist", name);
  const std::filesystem::path home = std::filesystem::canonical(
      root.folder.empty() ? std::filesystem::path(".") : root.folder, failed);
  if (failed || (!root.allow_outside && !is_inside(real, home))) {
    throw input_error(
        "'{}' is a link out of the deck's folder; copy the file there, or give --allow-outside",
        name);
  }
  if (!std::filesystem::is_regular_file(real, failed)) {
    throw input_error("'{}' is not a regular file", name);
  }
  return file;
}

std::filesystem::path trusted_scene(const DeckRoot& root, const std::string& name) {
  std::filesystem::path scene = trusted_file(root, root.folder, name);
  for (const std::string& mesh : named_files(scene)) {
    try {
      trusted_file(root, scene.parent_path(), mesh);
    } catch (const Error& error) {
      throw input_error("{}: {}", name, error.message());
    }
  }
  return scene;
}

void check_link(const std::string& target) {
  constexpr std::array<std::string_view, 4> kAllowed = {"https://", "http://", "mailto:", "#"};
  const bool plain = std::none_of(target.begin(), target.end(), is_control);
  for (const std::string_view start : kAllowed) {
    if (plain && target.starts_with(start)) return;
  }
  throw input_error("the link '{}' must be https:, http:, mailto: or #place", target);
}

void check_formula(const std::string& tex) {
  // pandoc refuses what it does not know; these it might know, and a TeX program surely does
  constexpr std::array<std::string_view, 36> kRefused = {"input",
                                                         "include",
                                                         "openin",
                                                         "openout",
                                                         "read",
                                                         "write",
                                                         "immediate",
                                                         "special",
                                                         "catcode",
                                                         "csname",
                                                         "def",
                                                         "edef",
                                                         "gdef",
                                                         "xdef",
                                                         "let",
                                                         "newcommand",
                                                         "renewcommand",
                                                         "usepackage",
                                                         "directlua",
                                                         "loop",
                                                         "expandafter",
                                                         "afterassignment",
                                                         "everymath",
                                                         "jobname",
                                                         "scantokens",
                                                         "verbatiminput",
                                                         "lstinputlisting",
                                                         "includegraphics",
                                                         "href",
                                                         "url",
                                                         "providecommand",
                                                         "newenvironment",
                                                         "renewenvironment",
                                                         "DeclareMathOperator",
                                                         "newwrite",
                                                         "begingroup"};
  if (tex.find("^^") != std::string::npos || std::any_of(tex.begin(), tex.end(), [](char c) {
        return c != '\n' && c != '\r' && c != '\t' && is_control(c);
      })) {
    throw input_error("'^^' and control characters are not allowed in a formula");
  }
  for (std::size_t at = tex.find('\\'); at != std::string::npos; at = tex.find('\\', at)) {
    std::size_t end = ++at;
    while (end < tex.size() && std::isalpha(static_cast<unsigned char>(tex[end])) != 0) {
      ++end;
    }
    const std::string_view word = std::string_view(tex).substr(at, end - at);
    if (std::find(kRefused.begin(), kRefused.end(), word) != kRefused.end())
      throw input_error("\\{} is not allowed in a formula", word);
    at = std::max(end, at + (end == at ? 1 : 0));
    if (at >= tex.size()) break;
  }
}

std::string percent_decoded(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escape = text[i] == '%' && i + 2 < text.size() && hex_digit(text[i + 1]) >= 0 &&
                        hex_digit(text[i + 2]) >= 0;
    if (!escape) {
      out += text[i];
      continue;
    }
    out += static_cast<char>(16 * hex_digit(text[i + 1]) + hex_digit(text[i + 2]));
    i += 2;
  }
  return out;
}

std::string percent_encoded(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80 &&
        (std::isalnum(byte) != 0 || std::string_view("-_./").find(c) != std::string_view::npos)) {
      out += c;
    } else {
      out += fmt::format("%{:02X}", byte);
    }
  }
  return out;
}

}  // namespace polhode
