// SPDX-License-Identifier: MIT
// The classical Runge-Kutta method on zxz Euler angles: a chart, kept to show where a chart fails.
#include <cmath>

#include "base/units.h"
#include "math/so3.h"
#include "motion/steppers/all.h"
#include "motion/steppers/no_solution.h"

namespace polhode {
namespace {

// (phi, theta, psi, y1, y2, y3)
using Vec6 = Eigen::Matrix<double, 6, 1>;

class RungeKutta4Angles final : public Stepper {
 public:
  explicit RungeKutta4Angles(const BodyModel& model) : model_(model) {}

  void step(double t, double h, State& s, Work& work) const override {
    Vec6 v;
    v << zxz_angles(s.q), s.y;
    double fastest = 0.0;
    const Vec6 k1 = derivative(v, fastest);
    const Vec6 k2 = derivative(v + 0.5 * h * k1, fastest);
    const Vec6 k3 = derivative(v + 0.5 * h * k2, fastest);
    const Vec6 k4 = derivative(v + h * k3, fastest);
    // written so that a NaN fails
    if (!(std::abs(h) * fastest <= kPi)) {
      throw no_solution("rk4_euler_angles",
                        t,
                        h,
                        model_,
                        s.y,
                        "but at the tilts 0 and 180 degrees the angles phi and psi have no rates, "
                        "and close to them phi turns by more than pi in the step");
    }
    const Vec6 end = v + h / 6.0 * (k1 + 2.0 * (k2 + k3) + k4);
    s.q = normalized(from_zxz_angles(end.head<3>()));
    s.y = end.tail<3>();
    work.evaluations += 4;
  }

 private:
  BodyModel model_;

  // Landau and Lifshitz, Mechanics, eq. 35.1, solved for the rates; fastest keeps the largest
  // |dphi/dt|
  Vec6 derivative(const Vec6& v, double& fastest) const {
    const Vec3 y = v.tail<3>();
    const Vec3 w = angular_velocity(model_, y);
    const double sin_psi = std::sin(v[2]), cos_psi = std::cos(v[2]);
    const double across = w[0] * sin_psi + w[1] * cos_psi;
    const double phi = across == 0.0 ? 0.0 : across / std::sin(v[1]);
    if (!(std::abs(phi) <= fastest)) fastest = std::abs(phi);
    Vec6 rate;
    rate << phi, w[0] * cos_psi - w[1] * sin_psi, w[2] - phi * std::cos(v[1]),
        momentum_rate(model_, y, up_in_body(model_, from_zxz_angles(v.head<3>())));
    return rate;
  }
};

}  // namespace

std::unique_ptr<Stepper> make_rk4_euler_angles(const BodyModel& model, double) {
  return std::make_unique<RungeKutta4Angles>(model);
}

}  // namespace polhode
