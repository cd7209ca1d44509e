// SPDX-License-Identifier: MIT
// The styles and scripts of HTML pages: the files of src/html/pages/, embedded at build time.
#pragma once

#include <string>

namespace polhode {

// For the pages of `diff` and `golden`.
const std::string& report_css();
const std::string& report_js();

// For lectures: the page, the slides with reveal.js, the printed handout.
const std::string& lecture_css();
const std::string& lecture_js();
const std::string& slides_css();
const std::string& slides_js();
const std::string& handout_css();

}  // namespace polhode
