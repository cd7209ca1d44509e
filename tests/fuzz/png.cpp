// SPDX-License-Identifier: MIT
// PNG pictures of at most a megapixel.
#include "image/png.h"

#include "fuzz/harness.h"

namespace polhode {
namespace {

// the whole number of four bytes at that place, big-endian (PNG specification, section 7.1)
std::size_t number_at(const std::string& bytes, std::size_t place) {
  std::size_t number = 0;
  for (std::size_t i = place; i < place + 4; ++i)
    number = number << 8U | static_cast<unsigned char>(bytes[i]);
  return number;
}

}  // namespace

void run_harness(const std::string& bytes) {
  // width and height are in the first chunk; a picture of a gigabyte is allowed, but not here
  constexpr std::size_t kWidthAt = 16, kHeightAt = 20, kMost = 1U << 20U;
  if (bytes.size() >= kHeightAt + 4 &&
      number_at(bytes, kWidthAt) * number_at(bytes, kHeightAt) > kMost) {
    return;
  }
  const Image image = decode_png(bytes, "a.png");
  const Image again = decode_png(encode_png(image, true), "again.png");
  promise(
      image.width == again.width && image.height == again.height && image.pixels == again.pixels,
      "a picture that is written and read is the same");
}

}  // namespace polhode
