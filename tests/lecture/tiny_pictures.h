// SPDX-License-Identifier: MIT
// The bytes of small pictures of other programs.
#pragma once

#include <string>

namespace polhode::test {

// a grey JPEG of 8x8 pixels behind its first marker, and a WebP of 2x2 pixels, by libjpeg and
// libwebp
inline constexpr const char* kJpegTables =
    "ffdb0043001b12141714111b1716171e1c1b2028422b28252528513a3d3042605565645f555d5b6a7899"
    "816a7190735b5d85b586909ea3abadab6780bcc9baa6c799a8aba4";
inline constexpr const char* kJpegFrame = "ffc0000b080008000801011100";
inline constexpr const char* kJpegScan =
    "ffc40014000100000000000000000000000000000004ffc4001410010000000000000000000000000000"
    "0000ffda0008010100003f0023ffd9";
inline constexpr const char* kWebp =
    "524946461e000000574542505650384c110000002f0140000007508f22d7a3ff8188e87f0000";

inline std::string from_hex(const std::string& digits) {
  std::string bytes;
  for (std::size_t i = 0; i < digits.size(); i += 2)
    bytes += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
  return bytes;
}

// that JPEG with what a camera says of how it was held: the tag Orientation of Exif 2.3, 1 to 8
inline std::string tiny_jpeg(int orientation) {
  std::string exif = from_hex(
      "ffe10022457869660000"  // a segment of 34 bytes for Exif
      "49492a0008000000"      // TIFF, the lowest bytes of numbers first
      "010012010300010000000000000000000000");
  exif[28] = static_cast<char>(orientation);
  return "\xff\xd8" + exif + from_hex(kJpegTables) + from_hex(kJpegFrame) + from_hex(kJpegScan);
}

}  // namespace polhode::test
