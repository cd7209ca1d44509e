// SPDX-License-Identifier: MIT
#include "model/fall_on_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "math/bracketed_zero.h"
#include "model/mobility.h"

namespace polhode {
namespace {

using Mat2 = Eigen::Matrix2d;
using Array2 = Eigen::Array2d;

// A number between 0 and 1 at which `passed` becomes true, which it is at 1.
template <class Passed>
double first_part(const Passed& passed) {
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (passed(middle) ? high : low) = middle;
  }
  return high;
}

// A fall while its normal impulse grows.
class Fall {
  static constexpr double kWithoutEnd = std::numeric_limits<double>::infinity();
  static constexpr double kSmallest = std::numeric_limits<double>::min();

 public:
  Fall(const Mat3& mobility, const Friction& law, double restitution, const Vec3& before)
      : K_(mobility), law_(law), restitution_(restitution), speed_(-before.z()), v_(before) {}

  Vec3 after() {
    switch (law_.kind) {
      case Friction::Kind::none:
        end_with(K_.col(2));
        break;
      case Friction::Kind::rolling:
        stop_slip();
        if (v_.z() < 0.0) end_with(K_ * held());
        break;
      case Friction::Kind::viscous:
        end_damped();
        break;
      case Friction::Kind::coulomb:
        if (slide()) end_after_slip();
        break;
    }
    return v_;
  }

 private:
  // The velocity per normal impulse stays the same until that has grown by `most`, N s; whether the
  // fall ends before.
  bool end_with(const Vec3& gain, double most = kWithoutEnd) {
    if (!(gain.z() > 0.0) && most == kWithoutEnd) return true;  // nothing would end it
    if (!rising_) {
      const double lowest = gain.z() > 0.0 ? -v_.z() / gain.z() : kWithoutEnd;
      const double part = std::min(lowest, most);
      taken_ -= part * (v_.z() + 0.5 * part * gain.z());
      v_ += part * gain;
      if (lowest > most) return false;
      most -= lowest;
      v_.z() = 0.0;
      rise();
    }
    const double squared = v_.z() * v_.z() + 2.0 * gain.z() * left_;
    const double all = squared > 0.0 ? 2.0 * left_ / (v_.z() + std::sqrt(squared))
                                     : v_.z() / std::max(-gain.z(), kSmallest);
    const double part = std::min(all, most);
    left_ -= part * (v_.z() + 0.5 * part * gain.z());
    v_ += part * gain;
    return all <= most;
  }

  void rise() {
    rising_ = true;
    left_ = restitution_ * restitution_ * taken_;
  }

  void stop_slip() {
    const Eigen::Vector2d level =
        K_.topLeftCorner<2, 2>().inverse() * Eigen::Vector2d(-v_.head<2>());
    v_ += K_ * Vec3(level.x(), level.y(), 0.0);
    v_.head<2>().setZero();
  }

  // the force per newton of normal force that keeps slip from beginning
  Vec3 held() const {
    const Eigen::Vector2d level =
        K_.topLeftCorner<2, 2>().inverse() * Eigen::Vector2d(-K_.topRightCorner<2, 1>());
    return {level.x(), level.y(), 1.0};
  }

  void end_after_slip() {
    v_.head<2>().setZero();
    const Vec3 force = held();
    if (force.head<2>().norm() <= law_.mu) {
      end_with(K_ * force);
      return;
    }
    // it begins in a direction that it keeps
    const auto gain_along = [&](const Vec3& way) {
      return Vec3(K_ * (Vec3::UnitZ() - law_.mu * way));
    };
    const double friction = 0.5 * law_.mu * (K_(0, 0) + K_(1, 1));
    const Vec3 start = -horizontal(force).normalized();
    end_with(gain_along(creep_direction(start, friction, gain_along)));
  }

  // Velocity and work of the normal force while the body slides, in steps of normal impulse over
  // slip, in which the velocity stays smooth until the slip ends.
  struct Sliding {
    Vec3 v;
    double work;
  };
  Sliding slope(const Vec3& v) const {
    const Vec3 slip = horizontal(v);
    return {slip.norm() * K_.col(2) - law_.mu * (K_ * slip), slip.norm() * v.z()};
  }
  Sliding slid(double h) const {
    const Sliding a = slope(v_), b = slope(v_ + 0.5 * h * a.v), c = slope(v_ + 0.5 * h * b.v),
                  d = slope(v_ + h * c.v);
    return {v_ + h / 6.0 * (a.v + 2.0 * b.v + 2.0 * c.v + d.v),
            h / 6.0 * (a.work + 2.0 * b.work + 2.0 * c.work + d.work)};
  }
  void take(const Sliding& step) {
    v_ = step.v;
    if (rising_) {
      left_ -= step.work;
    } else {
      taken_ -= step.work;
    }
  }

  // The velocity per normal impulse, where the slip keeps its direction.
  std::optional<Vec3> steady_gain() const {
    constexpr double kTurns = 1e-11;  // rad, until the slip has changed by its size
    const Vec3 way = horizontal(v_).normalized();
    const Vec3 gain = K_ * (Vec3::UnitZ() - law_.mu * way);
    const double along = gain.dot(way);
    const bool ends = along < 0.0 || gain.z() > 0.0;
    const double turns = (horizontal(gain) - along * way).norm();
    return ends && turns <= kTurns * K_.norm() ? std::optional(gain) : std::nullopt;
  }

  // whether the slip has ended, rather than the fall
  bool slide() {
    constexpr int kMost = 1'000'000;
    constexpr double kFine = 0.01;      // of what changes the slip, in a step
    constexpr double kPart = 0.25;      // of the speed of the fall
    constexpr double kStopped = 1e-11;  // of the speed of the fall
    const double rate = K_.norm() * (1.0 + law_.mu);
    for (int i = 0; i < kMost; ++i) {
      const double slip = horizontal(v_).norm();
      if (slip <= kStopped * speed_) return true;
      if (const std::optional<Vec3> gain = steady_gain(); gain) {
        const double loses = -gain->dot(horizontal(v_)) / slip;
        return !end_with(*gain, loses > 0.0 ? slip / loses : kWithoutEnd);
      }
      const double h = std::min(kFine / rate, kPart * speed_ / (rate * slip));
      // zero where the fall or the rise ends
      const auto left_after = [&](const Sliding& step) {
        if (!rising_) return -step.v.z();
        return step.v.z() < 0.0 ? -left_ : left_ - step.work;
      };
      const Sliding step = slid(h);
      const Bracket whole{0.0, h, rising_ ? left_ : -v_.z(), left_after(step)};
      if (whole.at_high > 0.0) {
        take(step);
        continue;
      }
      take(slid(narrowed(whole, 0.0, [&](double part) { return left_after(slid(part)); }).high));
      if (rising_) return false;
      rise();
      if (restitution_ == 0.0) return false;
    }
    return true;
  }

  // viscous friction: linear equations, in closed form along the principal directions of the level
  // part of K
  void end_damped() {
    const Eigen::SelfAdjointEigenSolver<Mat2> principal(K_.topLeftCorner<2, 2>());
    const Mat2& Q = principal.eigenvectors();
    const Array2 rate = law_.c * principal.eigenvalues().array();
    const Array2 slip = Q.transpose() * v_.head<2>();
    const Array2 across = Q.transpose() * K_.topRightCorner<2, 1>();
    const Vec3 before = v_;
    // integrals of exp(-rate p): once, twice, three times
    const auto integrals = [&](double p) {
      std::array<Array2, 3> found;
      for (int i = 0; i < 2; ++i) {
        const double x = rate[i] * p;
        const bool small = x < 1e-2;
        found[0][i] = rate[i] > 0.0 ? -std::expm1(-x) / rate[i] : p;
        found[1][i] = small ? p * p * (1.0 / 2 - x * (1.0 / 6 - x * (1.0 / 24 - x / 120)))
                            : (p - found[0][i]) / rate[i];
        found[2][i] = small ? p * p * p * (1.0 / 6 - x * (1.0 / 24 - x * (1.0 / 120 - x / 720)))
                            : (0.5 * p * p - found[1][i]) / rate[i];
      }
      return found;
    };
    const auto at = [&](double p) {
      const auto [once, twice, thrice] = integrals(p);
      const Array2 now = slip * (-rate * p).exp() + across * once;
      const double z =
          before.z() + K_(2, 2) * p - law_.c * (across * (slip * once + across * twice)).sum();
      const double work = before.z() * p + 0.5 * K_(2, 2) * p * p -
                          law_.c * (across * (slip * twice + across * thrice)).sum();
      Vec3 v;
      v << Q * now.matrix(), z;
      return Sliding{v, work};
    };
    const auto first_from = [&](double from, const auto& passed) {
      double step = speed_ / K_(2, 2) / 64.0;
      while (!passed(from + step) && std::isfinite(step))
        step *= 1.25;
      return from + step * first_part([&](double part) { return passed(from + step * part); });
    };
    const double lowest = first_from(0.0, [&](double p) { return at(p).v.z() >= 0.0; });
    taken_ = -at(lowest).work;
    rise();
    v_ = at(lowest).v;
    if (restitution_ == 0.0) return;
    v_ = at(first_from(lowest, [&](double p) { return at(p).work + taken_ >= left_; })).v;
  }

  const Mat3& K_;
  const Friction& law_;
  double restitution_, speed_;
  Vec3 v_;              // of the point that touches, m/s
  double taken_ = 0.0;  // work that the normal force has taken, J
  double left_ = 0.0;   // that it still has to give back
  bool rising_ = false;
};

}  // namespace

Vec3 impulse_of_fall(const Mat3& mobility,
                     const Friction& law,
                     double restitution,
                     const Vec3& before) {
  if (!(before.z() < 0.0)) return Vec3::Zero();
  const Vec3 after = Fall(mobility, law, restitution, before).after();
  return mobility.partialPivLu().solve(Vec3(after - before));
}

void fall_on_table(const BodyModel& model, const Touch& touch, double restitution, Moving& now) {
  const Posed pose = posed(model, touch, now);
  const Vec3& arm_P = pose.point.arm_P;
  const Mat3 K = pose.R_SP * mobility(model, arm_P) * pose.R_SP.transpose();
  const Vec3 impulse =
      impulse_of_fall(K, model.table->friction, restitution, slip_of(model, touch, now));
  now.velocity_S += impulse / model.body.mass;
  now.y += arm_P.cross(pose.R_SP.transpose() * impulse);
}

}  // namespace polhode
