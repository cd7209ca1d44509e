// SPDX-License-Identifier: MIT
// A folder of golden pictures with one small case, "top".
#pragma once

#include <string>

#include "app/compare/golden_cases.h"
#include "image/png.h"
#include "support/run.h"

namespace polhode::test {

class GoldenFolder {
 public:
  explicit GoldenFolder(const std::string& more_of_the_case = "") {
    write_text(folder_ / "top.toml", kSmallScene);
    write_cases("name = \"top\"\nscene = \"top.toml\"\nstill = 0.5\nsize = \"64x48\"\n" +
                more_of_the_case);
  }
  void write_cases(const std::string& first) const {
    write_text(folder_ / "cases.toml",
               "format = 1\n[verdict]\nmax = 3\nfraction = 0.01\nlimit = 70\nreason = \"ours\"\n"
               "[[case]]\n" +
                   first);
  }
  std::string operator/(const std::string& name) const { return folder_ / name; }
  std::string name() const { return folder_.path().string(); }
  LoadedCase only_case() const { return load_cases(folder_.path(), "").at(0); }

  // the case as it is drawn now
  DrawnCase drawn() const {
    const ScratchFolder scratch;
    return draw_case(folder_.path(), only_case().spec, "auto", scratch);
  }
  // makes a reference of the picture; with a sidecar where one is given
  void accept(const std::string& file, const Image& image) const {
    write_png(folder_ / file, image, false);
  }
  void accept(const std::string& file, const Image& image, const GoldenSidecar& sidecar) const {
    accept(file, image);
    write_text(folder_ / (file + ".toml"), sidecar_text(sidecar));
  }

 private:
  TemporaryFolder folder_;
};

// the picture with its red levels changed by so much, kept within 0..255
inline Image reddened(Image image, int levels) {
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      std::uint8_t& red = image.at(x, y)[0];
      red = static_cast<std::uint8_t>(red > 127 ? red - levels : red + levels);
    }
  }
  return image;
}

}  // namespace polhode::test
