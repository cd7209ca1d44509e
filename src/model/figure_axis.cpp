// SPDX-License-Identifier: MIT
#include "model/figure_axis.h"

#include <cmath>

namespace polhode {

Vec3 figure_axis_B(const BodyModel& model) {
  const Vec3 arm = model.body.center - model.pivot_B;
  const double size = std::sqrt(model.moments.maxCoeff() / model.body.mass);
  const bool off_pivot = model.on_pivot && arm.norm() > 1e-9 * size;
  if (model.kind.symmetric()) {
    const Vec3 axis = model.R_BP.col(model.kind.axis);
    return off_pivot && axis.dot(arm) < 0.0 ? Vec3(-axis) : axis;
  }
  if (off_pivot) return arm.normalized();
  return Vec3::UnitZ();
}

}  // namespace polhode
