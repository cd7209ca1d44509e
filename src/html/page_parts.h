// SPDX-License-Identifier: MIT
// The styles and scripts of HTML pages: the files of src/html/pages/, embedded at build time.
#pragma once

#include <string>

namespace polhode {

// All texts exist until the program ends and may be read by any thread.

// For the pages of the commands `diff` and `golden`.
const std::string& report_css();
const std::string& report_js();

// For the command `lecture`: the page, the slides with reveal.js, the printed handout.
const std::string& deck_css();  // what the three have in common, after the style of each
const std::string& lecture_css();
const std::string& lecture_js();
const std::string& turn_css();  // for viewers in page and slides
const std::string& turn_js();
const std::string& turn_core_js();  // before it: motions that pages compute
const std::string& slides_css();
const std::string& slides_js();
const std::string& handout_css();
const std::string& handout_js();

}  // namespace polhode
