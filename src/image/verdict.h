// SPDX-License-Identifier: MIT
// Decides whether two pictures count as the same: by three thresholds on differences, and by SSIM
// and FLIP if asked.
#pragma once

#include <optional>
#include <string>

#include "base/fields.h"
#include "image/compare.h"
#include "image/flip.h"

namespace polhode {

// The thresholds. The defaults allow what differs between processors and versions of Mesa: low bits
// of square roots and interpolation (up to 3 levels), and samples at edges, each a quarter of the
// edge's contrast with four samples per pixel.
struct Thresholds {
  int max = 3;                      // levels (0..255) by which any value may differ
  double fraction = 0.0005;         // share (0..1) of pixels that may differ by more ...
  int limit = 70;                   // ... but no value by more levels than this; below max, it
                                    // has no effect
  std::optional<double> ssim = {};  // least SSIM; absent: not measured
  std::optional<double> flip = {};  // greatest mean FLIP at kPixelsPerDegree; absent: not measured
};

template <class Visitor>
void fields(Visitor& v, Thresholds& s) {
  v.field("max",
          s.max,
          Doc{"levels of 255 by which any value may differ", Unit::none, Range{0.0, 255.0}});
  v.field("fraction",
          s.fraction,
          Doc{"share of pixels that may differ by more than max", Unit::none, Range{0.0, 1.0}});
  v.field(
      "limit",
      s.limit,
      Doc{"levels of 255 by which those pixels may differ at most", Unit::none, Range{0.0, 255.0}});
  v.field("ssim", s.ssim, Doc{"least SSIM; absent: not measured", Unit::none, Range{-1.0, 1.0}});
  v.field(
      "flip", s.flip, Doc{"greatest mean FLIP; absent: not measured", Unit::none, Range{0.0, 1.0}});
}

// The largest difference that passes: `limit`, or `max` if that is more.
int largest_allowed(const Thresholds& thresholds);

// Throws Error (input), naming the option (--max, --fraction, --limit, --ssim, --flip), for a
// number out of range: levels 0 to 255, shares and FLIP 0 to 1, SSIM -1 to 1.
void check_thresholds(const Thresholds& thresholds);

// Metrics to measure even if no threshold needs them.
struct Measures {
  bool ssim = false;
  bool flip = false;
};

// The result of a comparison.
struct Verdict {
  Difference values;                 // fraction_over counts pixels over thresholds.max
  std::optional<double> ssim = {};   // if it was measured
  std::optional<FlipMap> flip = {};  // if it was measured
  std::string reason;                // why the pictures are different; empty if they are the same

  bool same() const { return reason.empty(); }
};

// Compares `b` with the reference `a`. SSIM and FLIP (at kPixelsPerDegree) are measured if `also`
// or a threshold asks for them. `jobs` is the number of threads, 0 for one per processor. Throws
// Error (input), without a place, if the sizes differ, and (interrupted) while it measures FLIP.
Verdict judge(
    const Image& a, const Image& b, const Thresholds& thresholds, Measures also = {}, int jobs = 0);

// A number to rank verdicts by, to find the worst frame or the best reference: at most 1 if the
// pictures are the same, the larger the further they exceed the thresholds. The verdict must
// contain the metrics for which there are thresholds.
double badness(const Verdict& verdict, const Thresholds& thresholds);

// A share (0..1) as text with at most three significant digits: 0.0123 as "1.23%".
std::string percent(double share);

}  // namespace polhode
