// SPDX-License-Identifier: MIT
// What mechanics does not notice, the program must not notice either: turning everything about the
// vertical, a faster clock, a heavier body with stronger loads, other names of the body's axes.
// Random bodies with every kind of load; whatever solution method the program takes.
#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "math/so3.h"
#include "motion/simulate.h"

namespace polhode {
namespace {

constexpr double kAllowed = 1e-7;  // rad
constexpr int kTimes = 40;

struct Scenario {
  BodySpec body;
  MotionSpec motion;
};

class Dice {
 public:
  explicit Dice(unsigned seed) : numbers_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(numbers_()) / 4294967296.0;
  }
  bool one_in(int count) { return numbers_() % static_cast<unsigned>(count) == 0; }
  int below(int count) { return static_cast<int>(numbers_() % static_cast<unsigned>(count)); }
  Vec3 direction() {
    for (;;) {
      const Vec3 v(between(-1, 1), between(-1, 1), between(-1, 1));
      if (v.norm() > 0.1 && v.norm() < 1.0) return v.normalized();
    }
  }

 private:
  std::mt19937 numbers_;
};

LoadSpec any_load(Dice& dice, bool on_pivot, double torque, double rate, double duration) {
  LoadSpec load;
  const int kind = dice.below(on_pivot ? 5 : 6);
  const auto act = [&] {
    const Vec3 vector = torque * dice.direction();
    (dice.one_in(2) ? load.space : load.body) = vector;
    if (dice.one_in(2)) {
      load.rate = rate * dice.between(0.2, 3.0);
      load.phase = dice.between(0.0, 6.0);
    }
  };
  const auto point = [&] {
    return Vec3(0.3 * dice.direction());
  };
  switch (kind) {
    case 0:
      load.kind = "constant";
      act();
      break;
    case 1:
      load.kind = "damping";
      load.of = dice.one_in(2) ? "momentum" : "spin";
      load.c = 0.2 * (*load.of == "spin" ? torque / rate : rate);
      break;
    case 2:
      load.kind = "couple";
      act();
      load.at = point();
      load.opposite = point();
      break;
    case 3:
      load.kind = "force";
      act();
      load.at = point();
      break;
    case 4:
      load.kind = "spring";
      load.k = torque;
      load.at = point();
      load.to = dice.direction();
      if (dice.one_in(2)) load.length = 0.5;
      break;
    default:
      load.kind = "gravity_gradient";
      load.rate = 0.3 * rate;
      load.phase = dice.between(0.0, 6.0);
  }
  if (dice.one_in(3)) {
    load.from = dice.between(0.0, 0.3) * duration;
    load.until = dice.between(0.5, 1.0) * duration;
    if (dice.one_in(2)) load.ramp = dice.between(0.01, 0.2) * duration;
  }
  return load;
}

Scenario any_scenario(unsigned number) {
  Dice dice(number);
  Scenario one;
  const double a = dice.between(0.5, 2.0), b = dice.one_in(3) ? a : dice.between(0.5, 2.0);
  one.body.moments = Vec3(a, b, dice.between(1.1 * std::abs(a - b) + 0.05, 0.95 * (a + b)));
  one.body.mass = dice.between(0.5, 2.0);
  one.motion.hold = dice.one_in(2) ? "pivot" : "free";
  const bool on_pivot = one.motion.hold == "pivot";
  if (on_pivot) {
    const double off = dice.between(0.05, 0.4);
    one.body.center_of_mass = Vec3(off * (dice.one_in(2) ? Vec3(Vec3::UnitZ()) : dice.direction()));
    one.motion.gravity = Vec3(0.0, 0.0, -9.80665);
  }
  const Quat attitude = exp_rotation(3.0 * dice.direction());
  one.motion.attitude.quaternion =
      Eigen::Vector4d(attitude.w(), attitude.x(), attitude.y(), attitude.z());
  const double rate = dice.between(2.0, 10.0);
  one.motion.spin.body = Vec3(rate * dice.direction());
  one.motion.duration = dice.between(5.0, 15.0) / rate;
  const int loads = dice.below(3);
  for (int i = 0; i < loads; ++i) {
    one.motion.torque.push_back(
        any_load(dice, on_pivot, 0.3 * rate * rate, rate, one.motion.duration));
  }
  return one;
}

Simulation solved(const Scenario& one) {
  return simulate(make_model(one.body, one.motion), one.motion, NumericsSpec{}, kAllowed);
}

// What is done to a scenario, how fast its clock then is, and what its attitude was before.
struct Change {
  std::function<void(Scenario&)> apply;
  double clock = 1.0;
  std::function<Quat(const Quat&)> undo = [](const Quat& q) {
    return q;
  };
};

// Solves random scenarios and their changes: the attitudes agree, or one of the two is doubted.
void expect_unnoticed(const std::function<Change(Dice&)>& change_of) {
  const bool thoroughly = std::getenv("POLHODE_THOROUGHLY") != nullptr;
  const unsigned count = thoroughly ? 2000 : 60;
  unsigned compared = 0;
  for (unsigned number = 0; number < count; ++number) {
    SCOPED_TRACE(number);
    Dice dice(number + 1'000'000);
    const Scenario one = any_scenario(number);
    const Change change = change_of(dice);
    Scenario other = one;
    change.apply(other);
    const Simulation here = solved(one), there = solved(other);
    if (!here.report.reliability.doubts.empty() || !there.report.reliability.doubts.empty())
      continue;
    ++compared;
    double apart = 0.0;
    for (int i = 0; i <= kTimes; ++i) {
      const double part = static_cast<double>(i) / kTimes;
      const Quat q = here.motion.at(part * one.motion.duration).q_SB;
      const Quat changed = there.motion.at(part * other.motion.duration).q_SB;
      apart = std::max(apart, q.angularDistance(change.undo(changed)));
    }
    EXPECT_LT(apart, 2.0 * kAllowed) << here.report.method << ", " << there.report.method;
  }
  EXPECT_GT(10 * compared, 9 * count) << "hardly any is doubted";
}

Quat attitude_of(const Scenario& one) {
  const Eigen::Vector4d& q = *one.motion.attitude.quaternion;
  return {q[0], q[1], q[2], q[3]};
}
void set_attitude(Scenario& one, const Quat& q) {
  one.motion.attitude.quaternion = Eigen::Vector4d(q.w(), q.x(), q.y(), q.z());
}

TEST(Symmetries, NoDirectionOfSpaceButTheVerticalIsSpecial) {
  expect_unnoticed([](Dice& dice) {
    const double angle = dice.between(0.1, 6.0);
    const Quat turn = exp_rotation(angle * Vec3::UnitZ());
    Change change;
    change.apply = [=](Scenario& one) {
      set_attitude(one, turn * attitude_of(one));
      for (LoadSpec& load : one.motion.torque) {
        if (load.space) load.space = turn * *load.space;
        if (load.to) load.to = turn * *load.to;
        if (load.kind == "gravity_gradient") *load.phase += angle;
      }
    };
    change.undo = [=](const Quat& q) {
      return turn.conjugate() * q;
    };
    return change;
  });
}

TEST(Symmetries, NoUnitOfTimeIsSpecial) {
  expect_unnoticed([](Dice& dice) {
    const double faster = std::exp(dice.between(-5.0, 5.0));
    Change change;
    change.apply = [=](Scenario& one) {
      MotionSpec& motion = one.motion;
      *motion.spin.body *= faster;
      if (motion.gravity) *motion.gravity *= faster * faster;
      motion.duration /= faster;
      for (LoadSpec& load : motion.torque) {
        for (std::optional<Vec3>* vector : {&load.space, &load.body}) {
          if (*vector) **vector *= faster * faster;
        }
        if (load.k) *load.k *= faster * faster;
        if (load.c) *load.c *= faster;
        if (load.rate) *load.rate *= faster;
        for (std::optional<double>* time : {&load.from, &load.until, &load.ramp}) {
          if (*time) **time /= faster;
        }
      }
    };
    return change;
  });
}

TEST(Symmetries, NoUnitOfMassIsSpecial) {
  expect_unnoticed([](Dice& dice) {
    const double heavier = std::exp(dice.between(-12.0, 12.0));
    Change change;
    change.apply = [=](Scenario& one) {
      *one.body.mass *= heavier;
      *one.body.moments *= heavier;
      for (LoadSpec& load : one.motion.torque) {
        for (std::optional<Vec3>* vector : {&load.space, &load.body}) {
          if (*vector) **vector *= heavier;
        }
        if (load.k) *load.k *= heavier;
        if (load.c && *load.of == "spin") *load.c *= heavier;
      }
    };
    return change;
  });
}

TEST(Symmetries, NoUnitOfLengthIsSpecial) {
  expect_unnoticed([](Dice& dice) {
    const double larger = std::exp(dice.between(-7.0, 7.0));
    Change change;
    change.apply = [=](Scenario& one) {
      *one.body.moments *= larger * larger;
      if (one.body.center_of_mass) *one.body.center_of_mass *= larger;
      if (one.motion.gravity) *one.motion.gravity *= larger;
      for (LoadSpec& load : one.motion.torque) {
        // a torque goes with the square, a force as the length
        const double factor = load.kind == "constant" ? larger * larger : larger;
        for (std::optional<Vec3>* vector : {&load.space, &load.body}) {
          if (*vector) **vector *= factor;
        }
        for (std::optional<Vec3>* point : {&load.at, &load.opposite, &load.to}) {
          if (*point) **point *= larger;
        }
        if (load.length) *load.length *= larger;
        if (load.c && *load.of == "spin") *load.c *= larger * larger;
      }
    };
    return change;
  });
}

TEST(Symmetries, NoAxisOfTheBodyIsSpecial) {
  expect_unnoticed([](Dice& dice) {
    // x, y, z become y, z, x, or z, x, y
    const bool forwards = dice.one_in(2);
    const Quat renamed(0.5, forwards ? 0.5 : -0.5, forwards ? 0.5 : -0.5, forwards ? 0.5 : -0.5);
    Change change;
    change.apply = [=](Scenario& one) {
      *one.body.moments = (renamed * *one.body.moments).cwiseAbs();
      if (one.body.center_of_mass) *one.body.center_of_mass = renamed * *one.body.center_of_mass;
      *one.motion.spin.body = renamed * *one.motion.spin.body;
      set_attitude(one, attitude_of(one) * renamed.conjugate());
      for (LoadSpec& load : one.motion.torque) {
        for (std::optional<Vec3>* vector : {&load.body, &load.at, &load.opposite}) {
          if (*vector) *vector = renamed * **vector;
        }
      }
    };
    change.undo = [=](const Quat& q) {
      return q * renamed;
    };
    return change;
  });
}

}  // namespace
}  // namespace polhode
