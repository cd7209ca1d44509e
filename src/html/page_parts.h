// SPDX-License-Identifier: MIT
// The styles and the scripts of the pages, files of src/html/pages/ that are embedded at build.
#pragma once

#include <string>

namespace polhode {

// Of reports of differences.
const std::string& report_css();
const std::string& report_js();

// Of lectures: the page, the slides around reveal.js, what is printed.
const std::string& lecture_css();
const std::string& lecture_js();
const std::string& slides_css();
const std::string& slides_js();
const std::string& handout_css();

}  // namespace polhode
