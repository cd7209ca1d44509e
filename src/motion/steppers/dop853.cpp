// SPDX-License-Identifier: MIT
// Dormand and Prince's method of order 8 (motion/steppers/dormand_prince.h) for a body, or for
// several in the lanes of wide registers.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

#include "motion/convoy.h"
#include "motion/steppers/all.h"
#include "motion/steppers/derivative.h"
#include "motion/steppers/dormand_prince.h"
#include "motion/steppers/lanes.h"

namespace polhode {
namespace {

// One motion among several: where it is, and what becomes of it.
struct DormandPrincePart {
  const HeavyBody<double>* body = nullptr;
  double momentum_scale = 1.0;
  StateVector<kThreeDegrees> v = {};
  double h = 0.0;
  double error = 0.0;          // of a step
  Stretch* stretch = nullptr;  // absent for one step alone
};

// what the lanes have in common
template <class Wide>
struct DormandPrinceLanes {
  HeavyBody<Wide> body;
  Wide momentum_scale;

  [[gnu::always_inline]] explicit DormandPrinceLanes(const DormandPrincePart* const* parts) {
    using Part = DormandPrincePart;
    for (std::size_t i = 0; i < 3; ++i) {
      gather(parts, body.inverse_moments[i], [i](const Part& p) {
        return p.body->inverse_moments[i];
      });
      gather(parts, body.chi[i], [i](const Part& p) { return p.body->chi[i]; });
      gather(parts, body.up[i], [i](const Part& p) { return p.body->up[i]; });
    }
    gather(parts, momentum_scale, [](const Part& p) { return p.momentum_scale; });
  }
  // all lanes have one body, and nobody asks for the error
  [[gnu::always_inline]] explicit DormandPrinceLanes(const HeavyBody<double>& of_all)
      : momentum_scale{} {
    for (std::size_t i = 0; i < 3; ++i) {
      body.inverse_moments[i] = Wide{} + of_all.inverse_moments[i];
      body.chi[i] = Wide{} + of_all.chi[i];
      body.up[i] = Wide{} + of_all.up[i];
    }
  }

  // takes v to `end`
  [[gnu::always_inline]] dormand_prince::Slopes<WideVector<Wide>> step(
      const WideVector<Wide>& v, const Wide& h, WideVector<Wide>& end) const {
    const auto rate = [&](double, const WideVector<Wide>& at) __attribute__((always_inline)) {
      WideVector<Wide> found;
      heavy_rate(body, at.of.data(), found.of.data());
      return found;
    };
    const dormand_prince::Slopes<WideVector<Wide>> slopes = dormand_prince::slopes_of(v, h, rate);
    end = v + h * slopes.step;
    normalize(end);
    return slopes;
  }
  [[gnu::always_inline]] void step(const WideVector<Wide>& v,
                                   const Wide& h,
                                   WideVector<Wide>& end,
                                   Wide& error) const {
    const dormand_prince::Slopes<WideVector<Wide>> slopes = step(v, h, end);
    Wide fifth, third;
    find_size(h * slopes.error5, momentum_scale, fifth);
    find_size(h * slopes.error3, momentum_scale, third);
    error = dormand_prince::error_of(fifth, third);
  }
};

// as many motions as a register has lanes: one step each
template <class Wide>
[[gnu::always_inline]] inline void step_wide(DormandPrincePart* const* parts) {
  using Part = DormandPrincePart;
  const DormandPrinceLanes<Wide> lanes(parts);
  WideVector<Wide> v, end;
  Wide h, error;
  for (std::size_t i = 0; i < 7; ++i)
    gather(parts, v.of[i], [i](const Part& p) { return p.v[static_cast<int>(i)]; });
  gather(parts, h, [](const Part& p) { return p.h; });
  lanes.step(v, h, end, error);
  for (std::size_t i = 0; i < 7; ++i)
    scatter(parts, end.of[i], [i](Part& p) -> double& { return p.v[static_cast<int>(i)]; });
  scatter(parts, error, [](Part& p) -> double& { return p.error; });
}

// The same for stretches, as walk_adaptive() takes them. A lane that has arrived or whose step fell
// to round-off takes steps of no length.
template <class Wide>
[[gnu::always_inline]] inline void stretch_wide(DormandPrincePart* const* parts) {
  using Part = DormandPrincePart;
  const DormandPrinceLanes<Wide> lanes(parts);
  WideVector<Wide> v, trial;
  AdaptivePace<Wide> pace;
  Wide error;
  for (std::size_t i = 0; i < 7; ++i)
    gather(parts, v.of[i], [i](const Part& p) { return p.v[static_cast<int>(i)]; });
  gather(parts, pace.t, [](const Part& p) { return p.stretch->pace.t; });
  gather(parts, pace.h, [](const Part& p) { return p.stretch->pace.h; });
  gather(parts, pace.end, [](const Part& p) { return p.stretch->pace.end; });
  gather(parts, pace.tolerance, [](const Part& p) { return p.stretch->pace.tolerance; });
  auto goes_on = pace.t < pace.end;
  for (int i = 0; i < Stretch::kMost; ++i) {
    const Wide next = pace.next();
    const Wide length = goes_on ? next - pace.t : Wide{};
    lanes.step(v, length, trial, error);
    Wide ratio = pace.ratio(error);
    take_root(ratio);
    take_root(ratio);
    take_root(ratio);
    const auto accepted = goes_on & (error <= pace.tolerance);
    const auto stuck = ~accepted & ~pace.can_shorten(next, ratio);
    goes_on = goes_on & ~stuck;
    pace.h = goes_on ? (accepted ? pace.after(next, ratio) : pace.shortened(next, ratio)) : pace.h;
    pace.t = accepted ? next : pace.t;
    for (std::size_t k = 0; k < 7; ++k)
      v.of[k] = accepted ? trial.of[k] : v.of[k];
    for (std::size_t lane = 0; lane < sizeof(Wide) / sizeof(double); ++lane) {
      if (goes_on[lane] == 0) continue;
      Stretch& stretch = *parts[lane]->stretch;
      ++stretch.tried;
      if (accepted[lane] == 0) continue;
      Stretch::Step& step = stretch.steps[static_cast<std::size_t>(stretch.count++)];
      step.t = pace.t[lane];
      for (std::size_t k = 0; k < 7; ++k)
        step.v[k] = v.of[k][lane];
    }
    goes_on = goes_on & (pace.t < pace.end);
    if (!any(goes_on)) break;
  }
  scatter(parts, pace.t, [](Part& p) -> double& { return p.stretch->pace.t; });
  scatter(parts, pace.h, [](Part& p) -> double& { return p.stretch->pace.h; });
}

template <class Wide>
[[gnu::always_inline]] inline void advance_wide(DormandPrincePart* const* parts, bool stretches) {
  for (std::size_t i = 0; i < kLanes; i += sizeof(Wide) / sizeof(double))
    stretches ? stretch_wide<Wide>(parts + i) : step_wide<Wide>(parts + i);
}

// Steps of one body that have nothing to do with each other, one in each column.
struct Leaps {
  static constexpr std::size_t kMost = 64;
  std::array<std::array<double, kMost>, 7> v = {};
  std::array<double, kMost> h = {};
};
template <class Wide>
[[gnu::always_inline]] inline void leap_wide(const HeavyBody<double>& body,
                                             Leaps& leaps,
                                             std::size_t count) {
  const DormandPrinceLanes<Wide> lanes(body);
  for (std::size_t k = 0; k < count; k += sizeof(Wide) / sizeof(double)) {
    WideVector<Wide> v, end;
    Wide h;
    std::memcpy(&h, &leaps.h[k], sizeof(Wide));
    for (std::size_t i = 0; i < 7; ++i)
      std::memcpy(&v.of[i], &leaps.v[i][k], sizeof(Wide));
    lanes.step(v, h, end);
    for (std::size_t i = 0; i < 7; ++i)
      std::memcpy(&leaps.v[i][k], &end.of[i], sizeof(Wide));
  }
}

// in the widest registers that the processor has; the bits are the same in all
struct WidestRegisters {
  void (*advance)(DormandPrincePart* const* parts, bool stretches);
  void (*leap)(const HeavyBody<double>& body, Leaps& leaps, std::size_t count);
};
void advance_by_twos(DormandPrincePart* const* parts, bool stretches) {
  advance_wide<TwoLanes>(parts, stretches);
}
void leap_by_twos(const HeavyBody<double>& body, Leaps& leaps, std::size_t count) {
  leap_wide<TwoLanes>(body, leaps, count);
}
#if defined(__x86_64__)
[[gnu::target("avx2")]] void advance_by_fours(DormandPrincePart* const* parts, bool stretches) {
  advance_wide<FourLanes>(parts, stretches);
}
[[gnu::target("avx2")]] void leap_by_fours(const HeavyBody<double>& body,
                                           Leaps& leaps,
                                           std::size_t count) {
  leap_wide<FourLanes>(body, leaps, count);
}
[[gnu::target("avx512f")]] void advance_by_eights(DormandPrincePart* const* parts, bool stretches) {
  advance_wide<EightLanes>(parts, stretches);
}
[[gnu::target("avx512f")]] void leap_by_eights(const HeavyBody<double>& body,
                                               Leaps& leaps,
                                               std::size_t count) {
  leap_wide<EightLanes>(body, leaps, count);
}
#endif

WidestRegisters widest() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f")) return {advance_by_eights, leap_by_eights};
  if (__builtin_cpu_supports("avx2")) return {advance_by_fours, leap_by_fours};
#endif
  return {advance_by_twos, leap_by_twos};
}
const WidestRegisters& in_lanes() {
  static const WidestRegisters found = widest();
  return found;
}

void advance(void* const* parts, int count, bool stretches) {
  // a lane that nobody needs does the work of the first once more
  std::array<DormandPrincePart, kLanes> spare;
  std::array<Stretch, kLanes> spare_stretch;
  std::array<DormandPrincePart*, kLanes> lanes = {};
  for (int i = 0; i < kLanes; ++i) {
    if (i < count) {
      lanes[i] = static_cast<DormandPrincePart*>(parts[i]);
      continue;
    }
    lanes[i] = &spare[i];
    spare[i] = *lanes[0];
    if (!stretches) continue;
    spare_stretch[i] = *spare[i].stretch;
    spare[i].stretch = &spare_stretch[i];
  }
  in_lanes().advance(lanes.data(), stretches);
}
void step_parts(void* const* parts, int count) {
  advance(parts, count, false);
}
void stretch_parts(void* const* parts, int count) {
  advance(parts, count, true);
}

template <int N>
class DormandPrince853 final : public Stepper {
 public:
  DormandPrince853(const BodyModel& model, double momentum_scale)
      : model_(model),
        norm_(model, momentum_scale),
        body_(heavy_body(model)),
        has_lanes_(model.loads.turning.empty()) {}

  void step(double t, double h, State& s, Work& work) const override {
    step_with_error(t, h, s, work);
  }

  double step_with_error(double t, double h, State& s, Work& work) const override {
    const Vector v = to_vector<N>(s);
    work.evaluations += dormand_prince::kStages;
    if constexpr (N == kThreeDegrees) {
      DormandPrincePart part{&body_, norm_.momentum_scale(), v, h};
      if (has_lanes_ && step_in_convoy(step_parts, &part)) {
        set_unit_state(part.v, s);
        return part.error;
      }
    }
    double error = 0.0;
    const Vector change = dormand_prince::step_of_order_8(
        t,
        h,
        v,
        [&](double at, const Vector& now) -> Vector { return derivative<N>(model_, at, now); },
        [&](const Vector& e) { return norm_.template of<N>(e, v, h); },
        error);
    set_state<N>(model_, v + change, s);
    return error;
  }

  // in the lanes of registers, which need no other motion
  void leap(const Leap* leaps, int count) const override {
    if constexpr (N == kThreeDegrees) {
      if (has_lanes_) return leap_in_lanes(leaps, count);
    }
    Stepper::leap(leaps, count);
  }

  bool walk_in_convoy(const State& s, Stretch& stretch, Work& work) const override {
    if constexpr (N == kThreeDegrees) {
      DormandPrincePart part{&body_, norm_.momentum_scale(), to_vector<N>(s), 0.0, 0.0, &stretch};
      if (!has_lanes_ || !step_in_convoy(stretch_parts, &part)) return false;
      work.evaluations += static_cast<long>(stretch.tried) * dormand_prince::kStages;
      return true;
    }
    return false;
  }

 private:
  using Vector = StateVector<N>;

  void leap_in_lanes(const Leap* leaps, int count) const {
    Leaps columns;
    for (int done = 0; done < count; done += static_cast<int>(Leaps::kMost)) {
      const std::size_t now = std::min(Leaps::kMost, static_cast<std::size_t>(count - done));
      for (std::size_t k = 0; k < now; ++k) {
        const Leap& one = leaps[static_cast<std::size_t>(done) + k];
        const Vector v = to_vector<N>(*one.s);
        for (std::size_t i = 0; i < 7; ++i)
          columns.v[i][k] = v[static_cast<int>(i)];
        columns.h[k] = one.h;
      }
      in_lanes().leap(body_, columns, now);
      for (std::size_t k = 0; k < now; ++k) {
        std::array<double, 7> v;
        for (std::size_t i = 0; i < 7; ++i)
          v[i] = columns.v[i][k];
        set_unit_state(v, *leaps[static_cast<std::size_t>(done) + k].s);
      }
    }
  }

  BodyModel model_;
  ErrorNorm norm_;
  HeavyBody<double> body_;
  bool has_lanes_;
};

}  // namespace

std::unique_ptr<Stepper> make_dop853(const BodyModel& model, double momentum_scale) {
  return make_on_vector<DormandPrince853>(model, momentum_scale);
}

}  // namespace polhode
