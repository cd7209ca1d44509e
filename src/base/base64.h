// SPDX-License-Identifier: MIT
// Base64 encoding for data: URLs (RFC 4648, section 4).
#pragma once

#include <string>
#include <string_view>

namespace polhode {

// The bytes in the standard alphabet, padded with '=', without line breaks.
std::string base64(std::string_view bytes);

}  // namespace polhode
