// SPDX-License-Identifier: MIT
#include "motion/contact/contact_trajectory.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/system/interrupt.h"
#include "motion/contact/contact_change.h"
#include "motion/contact/contact_crossing.h"
#include "motion/walk.h"

namespace polhode {
namespace {

constexpr std::size_t kMostKeptSteps = 200'000;
constexpr long kStepsBetweenCalls = 4096;
constexpr int kMostAtOneTime = 200;
constexpr int kMostLowBounces = 2 * kMostContactEvents;
// Radau's steps begin where they are longer than so many explicit ones, and grow by no more than
// this, so that the solution of one is near that of the next
constexpr double kWorthRadau = 3.0;
constexpr double kGrowthOfRadau = 1.5;
// where their equations could not be solved, or something happens within the step
constexpr double kShorterRadau = 0.4;

// The grid of times, and at some of them what is known there: after events always, else of every
// second, fourth ... step, so that memory is bounded.
class ContactTrajectory final : public Trajectory {
 public:
  ContactTrajectory(const BodyModel& model, const TableScales& scales) : stepper(model, scales) {}

  State at(double t) const override { return state_of(stepper.model(), now(t).second.moving); }
  std::optional<ContactState> contact_at(double t) const override {
    const auto [touch, here] = now(t);
    return ContactState{touch, here.work};
  }

  std::vector<double> busy_times(std::size_t count) const override {
    std::vector<double> grid, speeds;
    for (const Kept& one : kept) {
      grid.push_back(times[one.index]);
      speeds.push_back(angular_velocity(stepper.model(), one.state.moving.y).norm());
    }
    return busy_times_of(grid, speeds, count);
  }

  // what is kept at the grid time with that index
  struct Kept {
    std::size_t index;
    Touch touch;
    OnTable state;
    bool after_event;
  };

  void keep(const Touch& touch, const OnTable& state, bool after_event) {
    kept.push_back({times.size() - 1, touch, state, after_event});
    if (kept.size() < kMostKeptSteps) return;
    bool odd = false;
    std::erase_if(kept, [&](const Kept& one) {
      odd = !odd;
      return one.index > 0 && !one.after_event && odd;
    });
  }

  ContactStepper stepper;
  std::vector<double> times;
  std::vector<bool> implicit;  // how the step from the time with that index is taken
  std::vector<Kept> kept;

 private:
  std::pair<Touch, OnTable> now(double t) const {
    const auto above = std::upper_bound(times.begin(), times.end(), t);
    const auto index =
        static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, above - times.begin() - 1));
    auto from = std::upper_bound(
        kept.begin(), kept.end(), index, [](std::size_t i, const Kept& k) { return i < k.index; });
    --from;
    // walk the grid as it was walked before, then take the partial step
    OnTable state = from->state;
    Touch touch = from->touch;
    for (std::size_t i = from->index; i < index; ++i) {
      state = stepper.step(touch, times[i], times[i + 1] - times[i], state, implicit[i]).end;
      touch = refreshed(stepper.model(), touch, state.moving);
    }
    const double rest = t - times[index];
    if (rest != 0.0) {
      const bool as_whole = index < implicit.size() && implicit[index];
      state = stepper.part(touch, times[index], rest, state, as_whole);
    }
    return {touch, state};
  }
};

// The walk from event to event.
class Walk {
 public:
  Walk(const StepperInfo& method,
       std::shared_ptr<ContactTrajectory> path,
       const State& start,
       double duration,
       double tolerance,
       const Effort& effort)
      : method_(method),
        path_(std::move(path)),
        duration_(duration),
        tolerance_(tolerance),
        effort_(effort),
        most_steps_(std::min(effort.most_steps, kMostSteps / 8)) {
    const BodyModel& model = path_->stepper.model();
    now_.moving = moving_of(model, start);
    touch_ = first_touch(path_->stepper, 0.0, now_);
    path_->times.push_back(0.0);
    path_->keep(touch_, now_, true);
    look();
  }

  IntegrationRecord run() {
    const TableScales& scales = path_->stepper.scales();
    const double rate =
        scales.rate + angular_velocity(path_->stepper.model(), now_.moving.y).norm();
    double h = std::min(duration_, 0.5 * std::pow(tolerance_, 1.0 / method_.order) / rate);
    // A body at rest makes no error, however much the loads on it change within a step, and may be
    // moved by them for an instant only.
    constexpr double kPhase = 0.5;  // rad of the fastest load
    const double longest = kPhase / path_->stepper.model().loads.fastest();
    if (duration_ / longest > static_cast<double>(most_steps_))
      throw too_many_steps(method_, duration_, duration_ / longest, most_steps_);
    bool grows = true;
    bool stiff = false;  // the step is, or that before was, Radau's
    while (t_ < duration_) {
      h = std::min(h, longest);
      const double turning = path_->stepper.turning_rate(touch_, now_.moving);
      const double most = ContactStepper::kExplicit / turning;
      stiff = h > (stiff ? 1.0 : kWorthRadau) * most;
      if (!stiff) h = std::min(h, most);
      const double next = t_ + h < duration_ ? t_ + h : duration_;
      const ContactStepper::Result trial = tried(next, stiff);
      record_.evaluations += 12;
      if (stiff && trial.order == 8) {
        // Newton's method did not converge
        h = shorter(next, kShorterRadau, trial);
        grows = false;
        continue;
      }
      const double ratio = std::pow(tolerance_ / std::max(trial.error, 1e-300), 1.0 / trial.order);
      if (!(trial.error <= tolerance_)) {
        h = shorter(next, std::clamp(0.9 * ratio, 0.1, 0.9), trial);
        grows = false;
        continue;
      }
      const Margins margins = path_->stepper.margins(touch_, next, trial.end);
      seen_.push_back({next, margins});
      const TakenStep step{touch_, t_, next - t_, now_, stiff};
      const std::optional<double> dip = dip_within(path_->stepper, step, seen_);
      if (dip || least_of(margins) < -kNoiseOfMargins) {
        if (stiff) {
          // solutions of its parts are too far from each other for a zero to be located in it
          ++record_.rejected;
          h = std::max(most, kShorterRadau * (next - t_));
          grows = false;
          continue;
        }
        pass_event(crossing_in(path_->stepper, step, dip.value_or(step.h)));
        h = std::min(h, std::max(duration_ - t_, 1e-300));
        continue;
      }
      // after a rejected step the next one is no longer than that which was taken
      const double most_growth = !grows ? 1.0 : stiff ? kGrowthOfRadau : 5.0;
      const double proposed = (next - t_) * std::clamp(0.9 * ratio, 0.2, most_growth);
      grows = true;
      h = next == duration_ ? std::max(h, proposed) : proposed;
      now_ = trial.end;
      touch_ = refreshed(path_->stepper.model(), touch_, now_.moving);
      arrive(next, false, stiff);
    }
    record_.drift = drift_.value().worst();
    return record_;
  }

 private:
  // A step; its error is infinite where friction has no solution at a stage that is too far off, or
  // numbers overflow there.
  ContactStepper::Result tried(double next, bool implicit) {
    constexpr double kNear = 1e-6;
    ContactStepper::Result none{now_};
    none.error = std::numeric_limits<double>::infinity();
    seen_.clear();
    try {
      const ContactStepper::Result trial =
          path_->stepper.step(touch_, t_, next - t_, now_, implicit, &seen_);
      return std::isnan(trial.error) ? none : trial;
    } catch (const Error& error) {
      if (error.fault() != Fault::check_failed) throw;
      // the stages of Radau's method are looked for also where the motion does not come to
      if (!implicit && next - t_ < kNear / path_->stepper.scales().rate) throw;
    }
    return none;
  }

  double shorter(double next, double factor, const ContactStepper::Result& trial) {
    ++record_.rejected;
    const double h = (next - t_) * factor;
    if (!std::isfinite(h) || t_ + h == t_ || t_ + h >= next) {
      refuse_nan(state_of(path_->stepper.model(), trial.end.moving), method_, next);
      refuse_tolerance(method_, tolerance_, t_);
    }
    return h;
  }

  void pass_event(const Crossing& crossing) {
    if (crossing.h > 0.0) now_ = path_->stepper.step(touch_, t_, crossing.h, now_).end;
    at_one_time_ = crossing.h > 1e-13 * std::max(t_, 1e-6) ? 0 : at_one_time_ + 1;
    double t = t_ + crossing.h;
    // what goes on without time where a face is as good as down ends there
    const bool ends = at_one_time_ > kMostAtOneTime && is_almost_flat();
    const ContactEvent event = ends ? ContactEvent::lies_flat : crossing.event;
    ContactChange change = change_at(path_->stepper, event, touch_, t, now_);
    if (ends) at_one_time_ = 0;
    const bool changed = event == ContactEvent::landing || change.touch.phase != touch_.phase ||
                         change.touch.sticks != touch_.sticks ||
                         change.touch.keeps_from_rolling != touch_.keeps_from_rolling ||
                         change.touch.keeps_from_boring != touch_.keeps_from_boring;
    touch_ = change.touch;
    record_.left_out_rad = std::max(record_.left_out_rad, change.left_out_rad);
    if (changed && record_.events.size() < kEventsReported)
      record_.events.push_back({t, name_of(event), words_for(event)});
    // one after another, too low to be found by their heights
    for (int low = 1; change.flies_for > 0.0 && t + change.flies_for < duration_; ++low) {
      if (low > kMostLowBounces) refuse_more(event, t, low);
      arrive(t, true);
      now_ = path_->stepper.step(touch_, t, change.flies_for, now_).end;
      t += change.flies_for;
      change = change_at(path_->stepper, ContactEvent::landing, touch_, t, now_);
      touch_ = change.touch;
    }
    if (change.bounces_end && record_.events.size() < kEventsReported)
      record_.events.push_back({t, "bounces_end", "the last of the bounces without end"});
    if (++events_ > kMostContactEvents || at_one_time_ > kMostAtOneTime)
      refuse_more(event, t, events_);
    arrive(t, true);
  }

  bool is_almost_flat() const {
    constexpr double kAlmost = 1e-3;  // rad
    const ContactSurface& surface = *path_->stepper.model().table->surface;
    if (touch_.phase != Touch::Phase::touching || surface.as_sphere() != nullptr) return false;
    return surface.tilt_of_face(down_in_body(now_.moving.q), touch_.piece) < kAlmost;
  }

  [[noreturn]] void refuse_more(ContactEvent event, double t, int events) const {
    const Friction& law = path_->stepper.model().table->friction;
    const bool comes_down = event == ContactEvent::landing || event == ContactEvent::lift_off;
    if (comes_down && law.kind == Friction::Kind::rolling && law.restitution == 0.0)
      throw held_without_pressure(t);
    throw Error(Fault::check_failed,
                fmt::format("at {:.6g} s {} again and again ({} events); end the motion before, "
                            "or change friction or restitution",
                            t,
                            words_for(event),
                            events),
                {{}, 0, "motion.friction"});
  }

  void arrive(double t, bool after_event, bool implicit = false) {
    if (after_event && t == t_) {
      // nothing can have been kept for this time but the state before
      while (!path_->kept.empty() && path_->kept.back().index + 1 == path_->times.size())
        path_->kept.pop_back();
    } else {
      path_->times.push_back(t);
      path_->implicit.push_back(implicit);
    }
    t_ = t;
    path_->keep(touch_, now_, after_event);
    look();
    if (after_event) stop_if_interrupted();  // a fall with friction takes as long as many steps
    if (++record_.steps % kStepsBetweenCalls == 0) {
      stop_if_interrupted();
      if (effort_.watch) effort_.watch(t / duration_);
    }
    if (record_.steps > most_steps_) {
      throw too_many_steps(
          method_, duration_, static_cast<double>(record_.steps) * duration_ / t, most_steps_);
    }
  }

  void look() {
    const BodyModel& model = path_->stepper.model();
    const State s = state_of(model, now_.moving);
    if (!drift_) drift_.emplace(model, s);
    drift_->look_at(s, ContactState{touch_, now_.work});
  }

  const StepperInfo& method_;
  std::shared_ptr<ContactTrajectory> path_;
  double duration_, tolerance_;
  const Effort& effort_;
  long most_steps_;
  std::optional<DriftWatch> drift_;
  Touch touch_;
  OnTable now_;
  MarginsSeen seen_;  // within the step that was tried last
  double t_ = 0.0;
  int events_ = 0, at_one_time_ = 0;
  IntegrationRecord record_;
};

}  // namespace

Integration integrate_on_table(const StepperInfo& method,
                               const BodyModel& model,
                               const State& start,
                               double duration,
                               double tolerance,
                               const Effort& effort) {
  auto path = std::make_shared<ContactTrajectory>(
      model, table_scales(model, moving_of(model, start), tolerance));
  Walk walk(method, path, start, duration, tolerance, effort);
  const IntegrationRecord record = walk.run();
  return {path, record};
}

}  // namespace polhode
