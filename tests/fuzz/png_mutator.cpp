// SPDX-License-Identifier: MIT
// Mutates PNG pictures as bytes, then mends the checks of their chunks, at which libpng would stop.
#include <cstddef>
#include <cstdint>
#include <zlib.h>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

// PNG specification, section 5: after eight bytes come chunks of length, type, data and CRC
void mend_checks(std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kHead = 8, kFour = 4;
  for (std::size_t at = kHead; at + 3 * kFour <= size;) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < kFour; ++i)
      length = length << 8U | data[at + i];
    if (length > size - at - 3 * kFour) return;
    const std::size_t end = at + 2 * kFour + length;
    const auto check = crc32(0, data + at + kFour, static_cast<uInt>(kFour + length));
    for (std::size_t i = 0; i < kFour; ++i)
      data[end + i] = static_cast<std::uint8_t>(check >> (8U * (3 - i)));
    at = end + kFour;
  }
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data,
                                               std::size_t size,
                                               std::size_t most,
                                               unsigned seed) {
  const std::size_t mutated = LLVMFuzzerMutate(data, size, most);
  if (seed % 8 != 0) mend_checks(data, mutated);
  return mutated;
}
