// SPDX-License-Identifier: MIT
// Runge-Kutta methods on the group: within a step the attitude is q0 o r, r moves by exponentials
// of angular velocities, and the angular momentum is carried in the axes that the body had at the
// start of the step. There gravity alone changes it, at right angles to the vertical: L in space of
// a free body, and L.up of a heavy one, are kept.
#include "math/so3.h"
#include "motion/steppers/all.h"
#include "motion/steppers/turn.h"

namespace polhode {
namespace {

// Rates at a turn r: angular velocity in the axes of the body, torque in those of the start.
struct GroupRate {
  Vec3 w;
  Vec3 torque;
};

// What both methods share: the right-hand side at (r, L), and the state at the end.
class GroupMethod : public Stepper {
 public:
  explicit GroupMethod(const BodyModel& model) : model_(model) {}

 protected:
  GroupRate rate(const Vec3& up, const Quat& r, const Vec3& L, Work& work) const {
    ++work.evaluations;
    return {angular_velocity(model_, r.conjugate() * L), up.cross(r * model_.chi_P)};
  }

  Vec3 up(const State& s) const { return up_in_body(model_, s.q); }

  static void finish(Quat r, const Vec3& L, State& s) {
    trim(r);
    s.q = s.q * r;
    trim(s.q);
    s.y = r.conjugate() * L;
  }

 private:
  BodyModel model_;
};

// Munthe-Kaas, Appl. Numer. Math. 29 (1999) 115: the classical method for u in q = q0 exp(u), where
// du/dt = w + u x w / 2 + u x (u x w) / 12 + ...; two terms are enough for order 4, and have no
// pole at |u| = 2 pi.
class MuntheKaas4 final : public GroupMethod {
 public:
  using GroupMethod::GroupMethod;

  void step(double, double h, State& s, Work& work) const override {
    const Vec3 L0 = s.y, up0 = up(s);
    const auto at = [&](const Vec3& u, const Vec3& L) {
      GroupRate k = rate(up0, turn_by(u), L, work);
      const Vec3 bracket = u.cross(k.w);
      k.w += 0.5 * bracket + u.cross(bracket) / 12.0;
      return k;
    };
    const GroupRate k1 = at(Vec3::Zero(), L0);
    const GroupRate k2 = at(0.5 * h * k1.w, L0 + 0.5 * h * k1.torque);
    const GroupRate k3 = at(0.5 * h * k2.w, L0 + 0.5 * h * k2.torque);
    const GroupRate k4 = at(h * k3.w, L0 + h * k3.torque);
    const Vec3 turn = h / 6.0 * (k1.w + 2.0 * (k2.w + k3.w) + k4.w);
    const Vec3 change = h / 6.0 * (k1.torque + 2.0 * (k2.torque + k3.torque) + k4.torque);
    finish(turn_by(turn), L0 + change, s);
  }
};

// Celledoni, Marthinsen and Owren, Future Gener. Comput. Syst. 19 (2003) 341, section 3: order 4
// without commutators, five exponentials.
class CommutatorFree4 final : public GroupMethod {
 public:
  using GroupMethod::GroupMethod;

  void step(double, double h, State& s, Work& work) const override {
    const Vec3 L0 = s.y, up0 = up(s);
    const GroupRate k1 = rate(up0, Quat::Identity(), L0, work);
    const Quat half_way = turn_by(0.5 * h * k1.w);
    const GroupRate k2 = rate(up0, half_way, L0 + 0.5 * h * k1.torque, work);
    const GroupRate k3 = rate(up0, turn_by(0.5 * h * k2.w), L0 + 0.5 * h * k2.torque, work);
    const GroupRate k4 =
        rate(up0, half_way * turn_by(h * (k3.w - 0.5 * k1.w)), L0 + h * k3.torque, work);
    const Vec3 first = h / 12.0 * (3.0 * k1.w + 2.0 * (k2.w + k3.w) - k4.w);
    const Vec3 second = h / 12.0 * (3.0 * k4.w + 2.0 * (k2.w + k3.w) - k1.w);
    const Vec3 change = h / 6.0 * (k1.torque + 2.0 * (k2.torque + k3.torque) + k4.torque);
    finish(turn_by(first) * turn_by(second), L0 + change, s);
  }
};

}  // namespace

std::unique_ptr<Stepper> make_rkmk4(const BodyModel& model, double) {
  return std::make_unique<MuntheKaas4>(model);
}

std::unique_ptr<Stepper> make_cf4(const BodyModel& model, double) {
  return std::make_unique<CommutatorFree4>(model);
}

}  // namespace polhode
