// SPDX-License-Identifier: MIT
// A diagram of mechanics beside the picture, with the point where the motion is.
#pragma once

#include <vector>

#include "frame/plot_paper.h"
#include "motion/diagram.h"

namespace polhode {

// Immutable.
class DiagramPicture {
 public:
  // `room` (pixels of the frame) is where it stands; `size` is that of its type, pixels, which is
  // smaller where there is too little room. left: where the axes begin, px of the frame, unless
  // their labels need more. The typesetter must outlive the picture. Throws Error as Typesetter
  // does.
  DiagramPicture(Diagram diagram,
                 const PixelBox& room,
                 double size,
                 const Theme& theme,
                 const Typesetter& typesetter,
                 int left = 0);

  // Appends the stamps of the time t, s of motion, in the range of Diagram::now. All but the dot
  // are the same for any time. Throws Error as Diagram::now does.
  void draw(double t, std::vector<Stamp>& stamps) const;

  // Pixels of the frame: where the curves are, and all text.
  const PixelBox& axes() const { return axes_; }
  const std::vector<PlacedText>& texts() const { return paper_.texts(); }
  // The pixel of a point of the diagram; beyond the axes, the nearest one on their border.
  LinePoint pixel(const Vec2& point) const;

 private:
  void add_curves();
  // How much it would hide, by the kinds of the curves that go through it; 0: nothing.
  double hidden_by(const TextRoom& room) const;
  void add_marks(const Typesetter& typesetter);

  Diagram diagram_;
  PlotPaper paper_;
  PixelBox axes_;
  std::vector<Stamp> curves_;  // and marks
};

}  // namespace polhode
