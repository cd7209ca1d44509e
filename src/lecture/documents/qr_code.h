// SPDX-License-Identifier: MIT
// Addresses as QR codes for paper (with libqrencode, which only this unit includes).
#pragma once

#include <string>

namespace polhode {

// The QR code of a text (ISO/IEC 18004, error correction M, with the quiet zone of four modules),
// as an SVG element, black on white; a module is one unit of its viewBox. Throws Error (input),
// without a place, for a text that is empty or too long for any code.
std::string qr_code_svg(const std::string& text);

}  // namespace polhode
