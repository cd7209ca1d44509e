// SPDX-License-Identifier: MIT
#include "lecture/deck/own_pictures.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

#include <libxml/parser.h>
#include <libxml/tree.h>

#include "base/error.h"
#include "base/system/atomic_file.h"
#include "image/png.h"

namespace polhode {
namespace {

// what is wrong with the bytes of a picture, as a part of a sentence; "": nothing
using Check = std::string (*)(const std::string& bytes);

constexpr char kCutOff[] = "is cut off: it ends before its picture does";

std::uint8_t byte_at(std::string_view bytes, std::size_t at) {
  return static_cast<std::uint8_t>(bytes[at]);
}

std::string wrong_with_png(const std::string& bytes) {
  try {
    decode_png(bytes, "");
  } catch (const Error& error) {
    return error.message();
  }
  return {};
}

// Goes from marker to marker, ISO/IEC 10918-1, annex B: most begin a segment that tells its length;
// behind that of a scan come its bytes, among which 0xff stands before 0 and restarts alone.
std::string wrong_with_jpeg(const std::string& bytes) {
  constexpr int kFirstRestart = 0xd0, kStart = 0xd8, kEnd = 0xd9, kScan = 0xda;
  if (!bytes.starts_with("\xff\xd8\xff")) return "is no .jpg file";
  bool has_scan = false;
  for (std::size_t at = 2; at + 1 < bytes.size();) {
    const int marker = byte_at(bytes, at + 1);
    const bool is_marker = byte_at(bytes, at) == 0xff && marker != 0 && marker != 0xff;
    const bool is_alone = marker >= kFirstRestart && marker <= kStart;
    if (!is_marker || is_alone) {
      at += is_marker ? 2 : 1;
      continue;
    }
    if (marker == kEnd) return has_scan ? "" : "has no picture in it";
    if (at + 3 >= bytes.size()) break;
    has_scan = has_scan || marker == kScan;
    at += 2 + std::size_t{256} * byte_at(bytes, at + 2) + byte_at(bytes, at + 3);
  }
  return kCutOff;
}

// https://developers.google.com/speed/webp/docs/riff_container: its length behind "RIFF", without
// these eight bytes
std::string wrong_with_webp(const std::string& bytes) {
  constexpr std::size_t kHead = 20;  // with that of the first chunk
  if (!bytes.starts_with("RIFF") || bytes.find("WEBP") != 8) return "is no .webp file";
  std::size_t length = 8;
  for (std::size_t i = 0; i < 4; ++i)
    length += std::size_t{byte_at(bytes, 4 + i)} << (8 * i);
  return bytes.size() < kHead || bytes.size() < length ? kCutOff : "";
}

std::string wrong_with_svg(const std::string& bytes) {
  if (bytes.find("<svg") == std::string::npos && bytes.find(":svg") == std::string::npos)
    return "is no .svg file";
  constexpr std::size_t kLargest = 10'000'000;  // libxml2 takes no longer texts
  if (bytes.size() > kLargest) return {};
  const std::unique_ptr<xmlDoc, decltype(&xmlFreeDoc)> tree(
      xmlReadMemory(bytes.data(),
                    static_cast<int>(bytes.size()),
                    nullptr,
                    nullptr,
                    XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING),
      &xmlFreeDoc);
  const xmlNode* root = tree == nullptr ? nullptr : xmlDocGetRootElement(tree.get());
  if (root == nullptr) return "is no XML, as an SVG is";
  // drawing programs name it by an entity
  const bool is_svg =
      std::string_view(reinterpret_cast<const char*>(root->name)).ends_with("svg") &&
      bytes.find("http://www.w3.org/2000/svg") != std::string::npos;
  return is_svg ? "" : "does not begin with <svg xmlns=\"http://www.w3.org/2000/svg\">";
}

struct Row {
  std::string_view ending;
  Check wrong_with;
};
constexpr Row kRows[] = {{".png", wrong_with_png},
                         {".jpg", wrong_with_jpeg},
                         {".jpeg", wrong_with_jpeg},
                         {".svg", wrong_with_svg},
                         {".webp", wrong_with_webp}};

const Row* find_row(const std::string& ending) {
  for (const Row& row : kRows)
    if (row.ending == ending) return &row;
  return nullptr;
}

}  // namespace

bool is_picture_ending(const std::string& ending) {
  return find_row(ending) != nullptr;
}

void require_picture(const std::filesystem::path& file, const std::string& ending) {
  const std::string wrong = find_row(ending)->wrong_with(read_input(file));
  if (!wrong.empty()) throw input_error("'{}' {}", file.filename().string(), wrong);
}

}  // namespace polhode
