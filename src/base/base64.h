// SPDX-License-Identifier: MIT
// Bytes as text that fits into a data: address (RFC 4648, section 4).
#pragma once

#include <string>
#include <string_view>

namespace polhode {

std::string base64(std::string_view bytes);

}  // namespace polhode
