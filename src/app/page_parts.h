// SPDX-License-Identifier: MIT
// The style and the script of the pages, files of src/app/pages/ that are embedded at build.
#pragma once

#include <string>

namespace polhode {

const std::string& page_css();
const std::string& page_js();

}  // namespace polhode
