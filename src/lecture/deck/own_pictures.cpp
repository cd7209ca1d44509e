// SPDX-License-Identifier: MIT
#include "lecture/deck/own_pictures.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

#include <fmt/format.h>
#include <libxml/parser.h>
#include <libxml/tree.h>

#include "base/error.h"
#include "base/name_list.h"
#include "base/one_line.h"
#include "base/system/atomic_file.h"
#include "image/png.h"
#include "video/picture_check.h"

namespace polhode {
namespace {

// what is wrong with the bytes of a picture, as a part of a sentence; "": nothing
using Check = std::string (*)(const std::string& bytes);

constexpr char kDamaged[] = "is damaged";
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

std::size_t number_at(std::string_view bytes, std::size_t at) {
  return std::size_t{256} * byte_at(bytes, at) + byte_at(bytes, at + 1);
}

// Whether a browser reads a frame whose bytes, from its marker on, are these: Huffman codes in
// order or progressive, 8 bits, of some size, in grey, three colours or four.
bool is_usual_frame(std::string_view bytes) {
  constexpr int kFirst = 0xc0, kLast = 0xc2, kBits = 8;
  constexpr std::size_t kHead = 10;
  if (bytes.size() < kHead) return false;
  const int marker = byte_at(bytes, 1), colours = byte_at(bytes, 9);
  return marker >= kFirst && marker <= kLast && byte_at(bytes, 4) == kBits &&
         number_at(bytes, 5) > 0 && number_at(bytes, 7) > 0 &&
         (colours == 1 || colours == 3 || colours == 4);
}

// Whether a scan has only colours of its frame; both from their markers on.
bool has_colours_of(std::string_view scan, std::string_view frame) {
  constexpr std::size_t kCount = 4, kFirst = 5, kInFrame = 10;
  const std::size_t count = scan.size() > kCount ? byte_at(scan, kCount) : 0;
  if (count == 0 || scan.size() < kFirst + 2 * count) return false;
  for (std::size_t i = 0; i < count; ++i) {
    bool is_there = false;
    for (std::size_t k = kInFrame; k < frame.size(); k += 3)
      is_there = is_there || frame[k] == scan[kFirst + 2 * i];
    if (!is_there) return false;
  }
  return true;
}

// Goes from marker to marker, ISO/IEC 10918-1, annex B: most begin a segment that tells its length;
// behind that of a scan come its bytes, among which 0xff stands before 0 and restarts alone.
std::string wrong_with_jpeg(const std::string& bytes) {
  constexpr int kFirstRestart = 0xd0, kLastRestart = 0xd7, kEnd = 0xd9, kScan = 0xda;
  if (!bytes.starts_with("\xff\xd8\xff")) return "is no .jpg file";
  constexpr std::size_t kMostPixels = 100'000'000;  // that are decoded here, as a test
  bool has_scan = false;
  std::size_t pixels = 0;
  std::string_view frame;
  for (std::size_t at = 2; at + 1 < bytes.size();) {
    const int marker = byte_at(bytes, at + 1);
    const bool is_marker = byte_at(bytes, at) == 0xff && marker != 0 && marker != 0xff;
    const bool is_alone = marker >= kFirstRestart && marker <= kLastRestart;
    if (!is_marker || is_alone) {
      at += is_marker ? 2 : 1;
      continue;
    }
    if (marker == kEnd) {
      if (!has_scan) return "has no picture in it";
      return pixels <= kMostPixels && is_damaged(bytes, CodedPicture::jpeg) ? kDamaged : "";
    }
    if (at + 3 >= bytes.size()) break;
    // other markers of that row are tables, and what browsers do not know
    const bool is_frame = (marker & 0xf0) == 0xc0 && marker != 0xc4 && marker != 0xcc;
    if (is_frame && !is_usual_frame(std::string_view(bytes).substr(at)))
      return "is a JPEG of a kind that browsers do not show";
    if (is_frame && pixels > 0) return kDamaged;
    const std::size_t end = at + 2 + number_at(bytes, at + 2);
    if (end > bytes.size()) break;
    const std::string_view segment = std::string_view(bytes).substr(at, end - at);
    if (is_frame) {
      pixels = number_at(bytes, at + 5) * number_at(bytes, at + 7);
      frame = segment;
    }
    if (marker == kScan && pixels == 0) return "is damaged: its picture has no size";
    if (marker == kScan && !has_colours_of(segment, frame)) return kDamaged;
    has_scan = has_scan || marker == kScan;
    at = end;
  }
  return kCutOff;
}

// https://developers.google.com/speed/webp/docs/riff_container: chunks, each with its length behind
// four letters, in one that is called RIFF.
std::string wrong_with_webp(const std::string& bytes) {
  constexpr std::size_t kHead = 8, kName = 4;
  const auto length_at = [&](std::size_t at) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i)
      length += std::size_t{byte_at(bytes, at + kName + i)} << (8 * i);
    return length;
  };
  if (!bytes.starts_with("RIFF") || bytes.find("WEBP") != kHead) return "is no .webp file";
  if (bytes.size() < kHead + length_at(0)) return kCutOff;
  bool has_picture = false, moves = false;
  for (std::size_t at = kHead + kName; at + kHead <= bytes.size();) {
    const std::string_view name = std::string_view(bytes).substr(at, kName);
    const std::size_t end = at + kHead + length_at(at);
    const bool is_picture = name == "VP8 " || name == "VP8L" || name == "ANMF";
    if (is_picture && end > bytes.size()) return kCutOff;
    if (is_picture && end > kHead + length_at(0)) return kDamaged;
    has_picture = has_picture || is_picture;
    moves = moves || name == "ANMF";  // which libav does not know
    at = end + end % 2;
  }
  if (!has_picture) return "has no picture in it";
  return !moves && is_damaged(bytes, CodedPicture::webp) ? kDamaged : "";
}

// the name of a node or an attribute without its prefix
template <class Named>
std::string_view name_of(const Named* named) {
  return reinterpret_cast<const char*>(named->name);
}

// the text of an attribute, of what is in an element, or of an instruction
template <class Node>
std::string text_of(const Node* node) {
  const std::unique_ptr<xmlChar, void (*)(xmlChar*)> text(
      xmlNodeGetContent(reinterpret_cast<const xmlNode*>(node)),
      [](xmlChar* one) { xmlFree(one); });
  return text == nullptr ? "" : reinterpret_cast<const char*>(text.get());
}

bool is_elsewhere(std::string_view link) {
  return !link.empty() && !link.starts_with('#') && !link.starts_with("data:");
}

// what stands behind `mark`, without blanks and quotation marks
std::string_view link_behind(std::string_view text, std::string_view mark) {
  constexpr std::string_view kAround = " \t\r\n\"'";
  text.remove_prefix(std::min(mark.size(), text.size()));
  text.remove_prefix(std::min(text.find_first_not_of(kAround), text.size()));
  return text.substr(0, text.find_first_of(" \t\r\n\"');"));
}

// the text without what stands between these, and without them
std::string without(std::string_view text, std::string_view begin, std::string_view end) {
  std::string out;
  for (;;) {
    const std::size_t from = text.find(begin);
    out += text.substr(0, from);
    const std::size_t to = from == text.npos ? from : text.find(end, from + begin.size());
    if (to == text.npos) return out;
    text.remove_prefix(to + end.size());
  }
}

// The first file that a style takes something from; "": none. Fonts are no loss: others are taken.
std::string file_of_style(std::string_view style) {
  constexpr std::string_view kUrl = "url(", kImport = "@import";
  if (style.find(kUrl) == style.npos && style.find(kImport) == style.npos) return {};
  const std::string read =
      without(without(without(style, "/*", "*/"), "@namespace", ";"), "@font-face", "}");
  for (const std::string_view mark : {kImport, kUrl}) {
    for (std::size_t at = read.find(mark); at != read.npos; at = read.find(mark, at + 1)) {
      const std::string_view link = link_behind(std::string_view(read).substr(at), mark);
      if (is_elsewhere(link) && !link.starts_with(kUrl)) return std::string(link);
    }
  }
  return {};
}

// the first other file that an element itself needs; "": none
std::string file_of_element(const xmlNode* element) {
  const bool may_lead_away = name_of(element) == "a";
  for (const xmlAttr* one = element->properties; one != nullptr; one = one->next) {
    std::string value = text_of(one);
    const bool is_link = name_of(one) == "href" || name_of(one) == "src";
    if (is_link && !may_lead_away && is_elsewhere(value)) return value;
    if (std::string file = file_of_style(value); !is_link && !file.empty()) return file;
  }
  return name_of(element) == "style" ? file_of_style(text_of(element)) : "";
}

std::string needs(const std::string& file) {
  return fmt::format("needs another file, {}, which browsers do not show in it; embed it",
                     cut(file));
}

// What is wrong with an element and what is beside and in it: for the picture of a page browsers
// look neither for other files nor for what a document type defines elsewhere.
std::string wrong_in(const xmlNode* node) {
  for (; node != nullptr; node = node->next) {
    if (node->type == XML_ENTITY_REF_NODE && xmlGetDocEntity(node->doc, node->name) == nullptr)
      return fmt::format("has &{}; in it, which it does not define", name_of(node));
    if (node->type == XML_PI_NODE && name_of(node) == "xml-stylesheet") {
      const std::string words = text_of(node);
      constexpr std::string_view kLink = "href=";
      const std::size_t at = std::min(words.find(kLink), words.size());
      const std::string_view link = link_behind(std::string_view(words).substr(at), kLink);
      if (is_elsewhere(link)) return needs(std::string(link));
    }
    if (node->type != XML_ELEMENT_NODE) continue;
    if (const std::string file = file_of_element(node); !file.empty()) return needs(file);
    if (std::string wrong = wrong_in(node->children); !wrong.empty()) return wrong;
  }
  return {};
}

// Browsers read an SVG that is shown in a page as UTF-8, whatever it says of itself, unless it
// begins with the mark of UTF-16.
std::string wrong_with_svg(const std::string& bytes) {
  constexpr std::size_t kLargest = 10'000'000;  // libxml2 takes no longer texts
  if (bytes.size() > kLargest) return {};
  const bool is_wide = bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff");
  const std::unique_ptr<xmlParserCtxt, decltype(&xmlFreeParserCtxt)> parser(xmlNewParserCtxt(),
                                                                            &xmlFreeParserCtxt);
  const std::unique_ptr<xmlDoc, decltype(&xmlFreeDoc)> tree(
      xmlCtxtReadMemory(parser.get(),
                        bytes.data(),
                        static_cast<int>(bytes.size()),
                        nullptr,
                        is_wide ? nullptr : "UTF-8",
                        XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING),
      &xmlFreeDoc);
  // limits of libxml2, such as elements in 256 others
  if (parser->errNo == XML_ERR_INTERNAL_ERROR) return {};
  const xmlNode* root = tree == nullptr ? nullptr : xmlDocGetRootElement(tree.get());
  const bool is_xml = parser->wellFormed != 0 && parser->nsWellFormed != 0;
  if (root == nullptr || !is_xml || (!is_wide && bytes.find('\0') != std::string::npos)) {
    const xmlError* error = xmlCtxtGetLastError(parser.get());
    if (error == nullptr || error->message == nullptr) return "is no XML, as an SVG is";
    return fmt::format(
        "is no XML, as an SVG is: line {}: {}", error->line, trimmed(error->message, "\n"));
  }
  constexpr std::string_view kSvg = "http://www.w3.org/2000/svg";
  const bool has_space = root->ns != nullptr && root->ns->href != nullptr;
  const std::string_view space = has_space ? reinterpret_cast<const char*>(root->ns->href) : "";
  // drawing programs name it by an entity, which stays as it is here
  const bool is_svg =
      name_of(root) == "svg" &&
      (space == kSvg || (space.starts_with('&') && bytes.find(kSvg) != std::string::npos));
  if (!is_svg) return fmt::format("does not begin with <svg xmlns=\"{}\">", kSvg);
  return wrong_in(tree->children);
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

std::string picture_ending(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return ending;
}

bool is_picture_ending(const std::string& ending) {
  return find_row(ending) != nullptr;
}

bool is_jpeg(const std::string& file) {
  const std::string ending = picture_ending(file);
  return ending == ".jpg" || ending == ".jpeg";
}

bool is_for_pages_only(const std::string& file) {
  const std::string ending = picture_ending(file);
  return ending == ".svg" || ending == ".webp";
}

void require_picture(const std::filesystem::path& file, const std::string& ending) {
  const std::string wrong = find_row(ending)->wrong_with(read_input(file));
  if (!wrong.empty()) throw input_error("'{}' {}", file.filename().string(), wrong);
}

std::string as_jfif(std::string jpeg) {
  constexpr int kJfif = 0xe0, kExif = 0xe1, kAdobe = 0xee, kFirstFrame = 0xc0, kLastFrame = 0xc2;
  constexpr std::size_t kColours = 9, kTransform = 15;
  bool is_rgb = false;
  for (std::size_t at = 2; at + kTransform < jpeg.size(); at += 2 + number_at(jpeg, at + 2)) {
    const int marker = byte_at(jpeg, at + 1);
    if (at == 2 && (marker == kJfif || marker == kExif)) return jpeg;
    if (marker == kAdobe) is_rgb = byte_at(jpeg, at + kTransform) == 0;
    if (marker < kFirstFrame || marker > kLastFrame) continue;
    constexpr std::string_view kSegment("\xff\xe0\0\x10JFIF\0\1\1\0\0\1\0\1\0\0", 18);
    if (byte_at(jpeg, at + kColours) != 3 || !is_rgb) jpeg.insert(2, kSegment);
    break;
  }
  return jpeg;
}

}  // namespace polhode
