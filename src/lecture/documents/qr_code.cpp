// SPDX-License-Identifier: MIT
#include "lecture/documents/qr_code.h"

#include <memory>
#include <qrencode.h>

#include <fmt/format.h>

#include "base/error.h"

namespace polhode {

std::string qr_code_svg(const std::string& text) {
  constexpr int kQuiet = 4;  // modules around the code
  const std::unique_ptr<QRcode, decltype(&QRcode_free)> code(
      QRcode_encodeString8bit(text.c_str(), 0, QR_ECLEVEL_M), &QRcode_free);
  if (code == nullptr) {
    throw input_error("{} bytes cannot be a QR code; give a shorter address", text.size());
  }
  const int side = code->width + 2 * kQuiet;
  std::string path;
  for (int y = 0; y < code->width; ++y) {
    for (int x = 0; x < code->width; ++x) {
      // the lowest bit is the colour
      if ((code->data[y * code->width + x] & 1) != 0)
        path += fmt::format("M{} {}h1v1h-1z", x + kQuiet, y + kQuiet);
    }
  }
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {0}\" role=\"img\" "
      "aria-label=\"QR code\" shape-rendering=\"crispEdges\"><path fill=\"#fff\" "
      "d=\"M0 0h{0}v{0}h-{0}z\"/><path d=\"{1}\"/></svg>",
      side,
      path);
}

}  // namespace polhode
