// SPDX-License-Identifier: MIT
#include "lecture/documents/notices.h"

#include <algorithm>
#include <sstream>

#include "base/version.h"

namespace polhode {
namespace {

bool has(const std::vector<std::string>& outputs, const char* name) {
  return std::find(outputs.begin(), outputs.end(), name) != outputs.end();
}

const char* const kMit =
    R"(Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all
copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
SOFTWARE.
)";

std::string heading(const std::string& words) {
  return fmt::format("\n{}\n{:-<{}}\n\n", words, "", words.size());
}

}  // namespace

bool has_pages(const std::vector<std::string>& outputs) {
  return has(outputs, "html") || has(outputs, "slides") || has(outputs, "handout");
}

std::string notices(const std::vector<std::string>& outputs,
                    const std::optional<Reveal>& reveal,
                    bool formula_font,
                    const std::optional<Three>& three,
                    bool computes) {
  std::string text = "Beside the lecture itself, its pages contain:\n";
  text += heading(fmt::format("Polhode {}: styles and scripts of the pages", program_version()));
  text += "Copyright (c) 2026 the Polhode authors\n\n" + std::string(kMit);
  if (has(outputs, "slides") && reveal) {
    text += heading(fmt::format("reveal.js {}, inside slides.html", reveal->version));
    text += reveal->licence.empty() ? "Copyright (C) Hakim El Hattab, http://hakim.se, and "
                                      "reveal.js contributors\n\n" +
                                          std::string(kMit)
                                    : reveal->licence;
  }
  if (three && (has(outputs, "html") || has(outputs, "slides"))) {
    text += heading(fmt::format("three.js {}, inside index.html and slides.html", three->version));
    text += three->licence.empty()
                ? "Copyright (C) 2010-2024 three.js authors\n\n" + std::string(kMit)
                : three->licence;
  }
  if (computes && (has(outputs, "html") || has(outputs, "slides"))) {
    text += heading("What computes motions inside index.html and slides.html") +
            "Polhode itself (as above), compiled to WebAssembly, with headers of Eigen (Mozilla "
            "Public License 2.0, https://eigen.tuxfamily.org), GLM, fmt, toml++, JSON for Modern "
            "C++ and tinygltf (MIT licence, as above), xxHash (BSD licence with 2 clauses, "
            "Copyright (C) 2012-2021 Yann Collet), and the runtime of Emscripten: musl (MIT "
            "licence, Copyright (C) 2005-2020 Rich Felker, et al.), libc++ and compiler-rt (Apache "
            "License 2.0 with LLVM exceptions)\n";
  }
  if (formula_font) {
    text += heading("Latin Modern Math, the font of formulas") +
            "Copyright 2012-2014 B. Jackowski, P. Strzelczyk and P. Pianowski on behalf of TeX "
            "users groups.\nGUST Font License: "
            "http://tug.org/fonts/licenses/GUST-FONT-LICENSE.txt\n";
  }
  return text;
}

std::string with_earlier_notices(std::string text, const std::string& before) {
  // the lines that begin a notice are underlined
  std::istringstream lines(before);
  std::string title, notice;
  const auto add = [&] {
    if (!title.empty() && text.find("\n" + title + "\n--") == std::string::npos) text += notice;
  };
  std::string last;
  for (std::string line; std::getline(lines, line); last = line) {
    if (line.size() > 2 && line.find_first_not_of('-') == std::string::npos && !last.empty()) {
      if (!title.empty()) notice.resize(notice.size() - last.size() - 2);
      add();
      title = last;
      notice = "\n" + title + "\n";
    }
    if (!title.empty()) notice += line + "\n";
  }
  add();
  return text;
}

}  // namespace polhode
