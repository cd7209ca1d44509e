// SPDX-License-Identifier: MIT
#include "lecture/lecture_job.h"

namespace polhode {

const std::vector<LectureOutput>& lecture_outputs() {
  static const std::vector<LectureOutput> table = {
      {"html", "index.html", "one page with films, formulas, charts"},
      {"slides", "slides.html", "slides by reveal.js; films stop where the story pauses"},
      {"pptx", "slides.pptx", "PowerPoint, with posters that link to the films"},
      {"beamer", "slides.tex", "LaTeX Beamer source, with stills"},
      {"handout", "handout.pdf", "stills, formulas and numbers on paper"},
      {"data", "data/manifest.json", "motions as tables, scenes, a manifest"},
  };
  return table;
}

}  // namespace polhode
