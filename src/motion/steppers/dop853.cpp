// SPDX-License-Identifier: MIT
// Dormand and Prince's method of order 8 (motion/steppers/dormand_prince.h) for a body, or for
// several in the lanes of wide registers.
#include <array>

#include "motion/convoy.h"
#include "motion/steppers/all.h"
#include "motion/steppers/derivative.h"
#include "motion/steppers/dormand_prince.h"
#include "motion/steppers/lanes.h"

namespace polhode {
namespace {

// One motion among several: where it is, and what becomes of it.
struct DormandPrincePart {
  const HeavyBody<double>* body;
  double momentum_scale;
  StateVector<kThreeDegrees> v;
  double h;
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

  // takes v to `end`
  [[gnu::always_inline]] void step(const WideVector<Wide>& v,
                                   const Wide& h,
                                   WideVector<Wide>& end,
                                   Wide& error) const {
    const auto rate = [&](double, const WideVector<Wide>& at) __attribute__((always_inline)) {
      WideVector<Wide> found;
      heavy_rate(body, at.of.data(), found.of.data());
      return found;
    };
    const dormand_prince::Slopes<WideVector<Wide>> slopes = dormand_prince::slopes_of(v, h, rate);
    end = v + h * slopes.step;
    normalize(end);
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

// in the widest registers that the processor has; the bits are the same in all
void advance_by_twos(DormandPrincePart* const* parts, bool stretches) {
  advance_wide<TwoLanes>(parts, stretches);
}
#if defined(__x86_64__)
[[gnu::target("avx2")]] void advance_by_fours(DormandPrincePart* const* parts, bool stretches) {
  advance_wide<FourLanes>(parts, stretches);
}
[[gnu::target("avx512f")]] void advance_by_eights(DormandPrincePart* const* parts, bool stretches) {
  advance_wide<EightLanes>(parts, stretches);
}
#endif

auto widest() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f")) return advance_by_eights;
  if (__builtin_cpu_supports("avx2")) return advance_by_fours;
#endif
  return advance_by_twos;
}

void advance(void* const* parts, int count, bool stretches) {
  static const auto in_lanes = widest();
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
  in_lanes(lanes.data(), stretches);
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
        [&](const Vector& e) { return norm_.template of<N>(e); },
        error);
    set_state<N>(model_, v + change, s);
    return error;
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
