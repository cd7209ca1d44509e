// SPDX-License-Identifier: MIT
#include "film/film_warnings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <fmt/ranges.h>

#include "base/numbers.h"
#include "base/system/log.h"
#include "film/error_places.h"
#include "film/unused_settings.h"
#include "motion/reliability.h"
#include "text/markup.h"
#include "text/typesetter.h"

namespace polhode {
namespace {

void warn_at(const Scene& scene, const char* key, const Error& warning) {
  spdlog::warn("{}", placed(scene, warning.at({{}, 0, key})).what());
}

// By how much the body turns from t for `step` (s), rad: about axes that stay in the body or in
// space; what it turns to and fro does not count.
double turned_within(const Motion& motion, double t, double step) {
  constexpr double kFine = 0.1;  // rad of what it turns at its speed at the start
  const double parts = std::clamp(std::ceil(motion.at(t).w_B.norm() * step / kFine), 16.0, 400.0);
  const double part = step / parts;
  Vec3 in_body = Vec3::Zero(), in_space = Vec3::Zero();
  for (double i = 0.5; i < parts; ++i) {
    const Sample now = motion.at(t + i * part);
    in_body += part * now.w_B;
    in_space += part * now.w_S;
  }
  return std::max(in_body.norm(), in_space.norm());
}

// a part of a motion, s
struct ShownPart {
  double from = 0.0, to = 0.0;
};

// what a film shows of the motion of one panel; of panels in turn, each begins where that before it
// ends
ShownPart shown_of(const Scene& film, const FrameTimes& frames, std::size_t panel) {
  if (!film.in_turn) return {frames.from, frames.to};
  const double begins = static_cast<double>(panel) * film.motion.duration;
  return {std::max(0.0, frames.from - begins), std::min(film.motion.duration, frames.to - begins)};
}

// the wheels of coaches in films; `scene`: of the motion, which may be one of several
void warn_of_backward_turning(const Scene& scene,
                              const Motion& motion,
                              const FrameTimes& frames,
                              const ShownPart& shown) {
  constexpr double kBlurring = kPi;  // an angle of the shutter beyond which nothing seems to turn
  if (frames.count < 2 || scene.video.shutter >= kBlurring) return;
  const double step = frames.motion_step();
  double most = 0.0;  // from frame to frame, rad
  const auto look_at = [&](double t) {
    const double begins = shown.from + std::floor((t - shown.from) / step) * step;
    if (t < shown.from || up_to(shown.to, begins + step) > shown.to) return;
    // few are so fast
    if (motion.at(t).w_B.norm() * step > std::max(most, kPi))
      most = std::max(most, turned_within(motion, begins, step));
  };
  const int looks = std::min(frames.count, 200);
  for (int i = 0; i < looks; ++i)
    look_at(shown.from + (shown.to - shown.from) * i / looks);
  for (const double t : framing_times(motion))
    look_at(t);
  const double fastest = most / step;
  const std::optional<std::string> words = turns_backwards(fastest, step);
  if (!words) return;
  constexpr double kMargin = 1.02;
  const double slower = kMargin * most / kPi;
  const double enough = std::ceil(slower * frames.rate);
  const std::string faster =
      enough <= kMostFramesPerSecond ? fmt::format("a video.fps of {:.0f} or more, ", enough) : "";
  const Error warning = input_error(
      "{}: use {}a video.time_scale of at most {:.2g}, or video.shutter_deg = 360, which blurs it",
      *words,
      faster,
      0.97 * scene.video.time_scale / slower);
  warn_at(scene, "video.fps", warning);
}

// How fast the contact runs round the centre of mass, rad/s; 0 where it is so near below that
// nobody sees it.
double contact_turning(const Motion& motion, double t) {
  constexpr double kSeen = 0.05;  // of what the body reaches
  const std::optional<Reaction> found = reaction_at(motion, t);
  if (!found) return 0.0;
  const Sample now = motion.at(t);
  const Quat q_SP = now.q_SB * Quat(motion.model().R_BP);
  const Vec3 arm = q_SP * found->point.arm_P;
  if (arm.head<2>().norm() < kSeen * motion.model().table->surface->reach()) return 0.0;
  const Vec3 rate = now.w_S.cross(arm) + q_SP * found->point.arm_rate_P;
  return std::abs(arm.x() * rate.y() - arm.y() * rate.x()) / arm.head<2>().squaredNorm();
}

// a disc that hardly turns may have a contact that runs round ever faster
void warn_of_running_contact(const Scene& scene,
                             const Composer& composer,
                             const FrameTimes& frames) {
  const Motion& motion = composer.scenery().motion;
  if (frames.count < 2 || !motion.model().table || !composer.shows("contact")) return;
  const double frame_s = frames.motion_step();
  double most = 0.0;  // rad from frame to frame
  std::optional<double> since;
  constexpr int kLooks = 2000;
  for (int i = 0; i <= kLooks; ++i) {
    const double t = frames.from + (frames.to - frames.from) * i / kLooks;
    const Timeline& timeline = composer.timeline();
    if (timeline.presence("contact", timeline.film_time(t)) <= 0.0) continue;
    const double turned = contact_turning(motion, t) * frame_s;
    most = std::max(most, turned);
    if (turned > kPi && !since) since = t;
  }
  if (!since) return;
  const Error warning = input_error(
      "from {:.3g} s on the contact runs round by more than 180 degrees from frame to frame, at "
      "last by {:.3g}, so that the eye sees it anywhere: end the film there, hide the contact from "
      "there on by a [[story]] step, or use a video.time_scale of at most {:.3g}",
      *since,
      most * 180.0 / kPi,
      0.97 * scene.video.time_scale * kPi / most);
  warn_at(scene, "video.time_scale", warning);
}

void warn_of_open_loop(const Scene& scene, const FrameTimes& frames) {
  if (!frames.loop || frames.loop->residual <= scene.video.loop_residual) return;
  const Error warning = input_error(
      "the motion returns to its start only to within {:.3g} degrees, attitude and angular "
      "velocity together (after {:.4g} s); a longer motion.duration gives more to choose from",
      frames.loop->residual * 180.0 / kPi,
      frames.loop->duration);
  warn_at(scene, "video.loop", warning);
}

// a loop has whole frames, for which its clock is stretched
void warn_of_stretched_clock(const Scene& scene, const FrameTimes& frames) {
  constexpr double kNoticed = 0.05;
  if (!frames.loop) return;
  const double faster = frames.timeline.time_scale() / scene.video.time_scale;
  if (std::abs(faster - 1.0) <= kNoticed) return;
  const Error warning = input_error(
      "the motion is back after {:.4g} s, which is no whole number of frames, so that it is shown "
      "{:.3g} times as fast as video.time_scale says; use a higher video.fps or a smaller "
      "video.time_scale",
      frames.loop->duration,
      faster);
  warn_at(scene, "video.loop", warning);
}

// a part of a loop does not end where it begins
void warn_of_part_of_loop(const Scene& scene, const FrameTimes& frames) {
  if (!frames.loop || frames.from == frames.to) return;
  if (frames.from == 0.0 && frames.to == frames.loop->duration) return;
  const Error warning = input_error(
      "the film shows {:.4g} to {:.4g} s of a loop of {:.4g} s, so it jumps where it repeats; "
      "leave out --from and --to",
      frames.from,
      frames.to,
      frames.loop->duration);
  warn_at(scene, "video.loop", warning);
}

// where the film repeats, the body may be elsewhere in the picture, or seen by another camera
void warn_of_jump(const Scene& scene, const FrameTimes& frames, const Composer& composer) {
  constexpr double kNoticed = 1.0;  // pixels
  if (!frames.loop) return;
  const Scenery& scenery = composer.scenery();
  const double end = frames.loop->duration;
  const auto camera = [&](double t) {
    return composer.camera_at(composer.timeline().film_time(t));
  };
  const Camera first = camera(0.0), last = camera(end);
  // whether points about the body at these places are the same pixels for both cameras
  const auto are_alike = [&](const Vec3& at_first_S, const Vec3& at_last_S) {
    const double size = scenery.scale.body;
    const Vec3 offsets_S[] = {
        Vec3::Zero(), size * Vec3::UnitX(), size * Vec3::UnitY(), size * Vec3::UnitZ()};
    return std::all_of(std::begin(offsets_S), std::end(offsets_S), [&](const Vec3& off_S) {
      const Vec2 apart = last.project(at_last_S + off_S) - first.project(at_first_S + off_S);
      return apart.norm() <= kNoticed;
    });
  };
  const Vec3 start_S = scenery.motion.at(0.0).reference_S;
  const Vec3 end_S = scenery.motion.at(end).reference_S;
  if (are_alike(start_S, end_S)) return;
  const Error warning =
      are_alike(start_S, start_S)
          ? input_error(
                "the film repeats after {:.4g} s, where the body stands {:.3g} pixels from "
                "its start: it jumps there",
                end,
                (last.project(end_S) - first.project(start_S)).norm())
          : input_error(
                "the film repeats after {:.4g} s, where the camera is not where it was: it "
                "jumps there; leave out camera.orbit_deg_per_s and shots that do not come "
                "back",
                end);
  warn_at(scene, "video.loop", warning);
}

// whether loads that depend on time act after it as they do at the start
bool loads_are_back(const Loads& loads, double time) {
  constexpr double kBack = 0.01;  // rad, and parts
  return std::all_of(loads.listed.begin(), loads.listed.end(), [&](const Load& load) {
    const double turned = std::remainder(load.rate * time, 2.0 * kPi);
    return std::abs(turned) < kBack && std::abs(load.acts.part(time) - load.acts.part(0.0)) < kBack;
  });
}

// what goes on through a film, or comes and goes in it, is not at its end as at its start
void warn_of_what_restarts(const Scene& scene, const FrameTimes& frames, const Composer& composer) {
  if (!frames.loop) return;
  std::vector<std::string> restarting;
  const Scenery& scenery = composer.scenery();
  const Paths& paths = scenery.paths;
  if (composer.shows("trail") || composer.shows("herpolhode") || composer.shows("contact_trail") ||
      !paths.points.empty() || !paths.omega_tip.empty() || !paths.momentum_tip.empty())
    restarting.emplace_back("paths");
  const Motion& motion = scenery.motion;
  if (composer.shows("ghosts") && scene.show.ghost_s.value_or(0.0) < motion.duration())
    restarting.emplace_back("ghosts");
  if (composer.shows("ensemble")) restarting.emplace_back("the ensemble");
  const Vec3 gone = motion.at(frames.loop->duration).reference_S - motion.at(0.0).reference_S;
  constexpr double kGone = 1e-3;  // of the body's reach
  if (composer.shows("fixed_frame") && gone.norm() > kGone * scenery.scale.body)
    restarting.emplace_back("R");
  // its lines pass below a camera that goes along
  if (composer.shows("floor") && scenery.table_goes_along &&
      gone.norm() > kGone * scenery.scale.body)
    restarting.emplace_back("the floor");
  if (!scene.show.plots.empty()) restarting.emplace_back("plots");
  const Timeline& timeline = composer.timeline();
  const double last = timeline.film_duration();
  const auto caption = [&](double film) {
    return timeline.caption(film).value_or(scene.show.caption);
  };
  if (caption(0.0) != caption(last)) restarting.emplace_back("captions");
  const bool changes = std::any_of(elements().begin(), elements().end(), [&](const Element& one) {
    return composer.shows(one.name) &&
           timeline.presence(one.name, 0.0) != timeline.presence(one.name, last);
  });
  if (changes) restarting.emplace_back("what the story shows or hides");
  if (!loads_are_back(motion.model().loads, frames.loop->duration))
    restarting.emplace_back("loads that depend on time");
  if (restarting.empty()) return;
  warn_at(scene,
          "video.loop",
          input_error("where the film repeats, these begin anew, which is seen as a jump: {}",
                      fmt::join(restarting, ", ")));
}

// a step of the story may name what the film does not have
void warn_of_what_never_comes(const Scene& scene, const std::vector<FilmPanel>& panels) {
  for (std::size_t i = 0; i < scene.story.size(); ++i) {
    for (const std::string& name : scene.story[i].show) {
      const bool comes = std::any_of(panels.begin(), panels.end(), [&](const FilmPanel& panel) {
        return panel.composer->shows(name);
      });
      if (comes) continue;
      const auto element = std::find_if(elements().begin(),
                                        elements().end(),
                                        [&](const Element& one) { return one.name == name; });
      const std::string wrong = element->why_not(panels.front().composer->scenery());
      const std::string key = fmt::format("story[{}].show", i);
      warn_at(scene,
              key.c_str(),
              input_error("'{}' will not appear: it {}",
                          name,
                          wrong.empty() ? fmt::format("needs show.{} = true", name) : wrong));
    }
  }
}

// The parts of a film in which its panels follow one another, or all of it.
std::size_t parts_of(const Scene& scene) {
  return scene.in_turn ? scene.panels.size() : 1;
}

// shots and steps in the time of the last frame of all parts, behind which there is none
void warn_of_what_comes_too_late(const Scene& scene, const FrameTimes& frames) {
  const Timeline& timeline = frames.timeline;
  const double last = frames.film_time(frames.count - 1);
  // a part of a film is no reason
  const double missed = timeline.film_duration() - last;
  if (frames.count < 2 || missed > 1.5 / frames.rate) return;
  const std::size_t parts = parts_of(scene);
  const auto end_of = [&](std::size_t part) {
    const double turn = timeline.film_duration() / static_cast<double>(parts);
    return part + 1 < parts ? frames.frame_at(static_cast<double>(part + 1) * turn) : frames.count;
  };
  // film_time: of what begins at a time of the motion
  const auto look_at = [&](const std::string& key, double at, const auto& film_time) {
    for (std::size_t part = 0; part < parts; ++part) {
      const double begins = film_time(static_cast<double>(part) * scene.motion.duration + at);
      if (frames.frame_at(begins) < end_of(part)) return;
    }
    const Error warning = input_error("is never seen: the last frame shows {:.6g} s of the motion",
                                      timeline.motion_time(frames.film_time(end_of(0) - 1)));
    warn_at(scene, key.c_str(), warning);
  };
  for (std::size_t i = 0; i < scene.shots.size(); ++i) {
    look_at(fmt::format("shots[{}].at", i), scene.shots[i].at, [&](double motion) {
      return timeline.film_time(motion);
    });
  }
  for (std::size_t i = 0; i < scene.story.size(); ++i) {
    const StoryStep& step = scene.story[i];
    if (step.hold > 0.0) continue;
    look_at(fmt::format("story[{}].at", i), step.at, [&](double motion) {
      return timeline.first_film_time(motion);
    });
  }
}

// words that others replace before the next frame
void warn_of_captions_between_frames(const Scene& scene, const FrameTimes& frames) {
  if (frames.count < 2) return;
  const std::vector<StoryStep>& steps = frames.timeline.steps();
  const std::vector<double>& starts = frames.timeline.starts();
  // as the scene has them, which may be in any order, and in every part of the film
  const auto written_at = [&](const StoryStep& said) {
    const auto written =
        std::find_if(scene.story.begin(), scene.story.end(), [&](const StoryStep& step) {
          for (std::size_t part = 0; part < parts_of(scene); ++part) {
            const double at = step.at + static_cast<double>(part) * scene.motion.duration;
            if (at == said.at && step.caption == said.caption) return true;
          }
          return false;
        });
    return written - scene.story.begin();
  };
  std::map<std::ptrdiff_t, bool> seen;  // by the index in the story: in any part
  const StoryStep* said = nullptr;
  double since = 0.0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (!steps[i].caption) continue;
    const StoryStep* before = std::exchange(said, &steps[i]);
    const double began = std::exchange(since, starts[i]);
    if (before == nullptr || before->caption->empty()) continue;
    const int frame = frames.frame_at(began);
    // a part ends without words, in the time of its last frame too
    const bool is_cut = began < frames.first || frame >= frames.count ||
                        (scene.in_turn && steps[i].caption->empty());
    const bool is_seen = is_cut || !reached(frames.film_time(frame), since);
    bool& in_any = seen[written_at(*before)];
    in_any = in_any || is_seen;
  }
  for (const auto& [index, is_seen] : seen) {
    if (is_seen) continue;
    warn_at(scene,
            fmt::format("story[{}].caption", index).c_str(),
            input_error("is never seen: other words take its place before the next frame"));
  }
}

// One scale serves bodies of about one size.
void warn_of_sizes(const Scene& scene, const std::vector<FilmPanel>& panels) {
  constexpr double kAlike = 5.0;
  if (scene.panels.size() < 2 || !(scene.same_cameras || scene.same_scales)) return;
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  for (const FilmPanel& panel : panels) {
    const Scenery& scenery = panel.composer->scenery();
    const double size = body_radius(scenery.look, scenery.motion.model());
    least = std::min(least, size);
    most = std::max(most, size);
  }
  if (!(most > kAlike * least)) return;
  spdlog::warn(
      "{}: one body is {:.2g} times as large as another; cameras = \"own\" and scales = \"own\" "
      "show each as large as it can be",
      scene.film_file,
      most / least);
}

// a scale that serves all vectors is the smallest of them
void warn_of_lengths(const std::vector<Solved>& solved) {
  const Scene& first = solved.front().scene;
  if (first.panels.size() < 2 || !first.same_scales) return;
  const auto length = [](const Solved& one) {
    return one.scene.show.vector_length.value_or(1.0);
  };
  double least = length(solved.front());
  for (const Solved& one : solved)
    least = std::min(least, length(one));
  for (const Solved& one : solved) {
    if (!one.scene.show.vector_length || length(one) == least) continue;
    warn_at(one.scene,
            "show.vector_length",
            input_error("changes nothing here: panels with one scale have the smallest of theirs, "
                        "{:g}; scales = \"own\" in the film file gives each its own",
                        least));
  }
}

// the panels that show a scene: its own of several scenes, else all
std::vector<std::shared_ptr<const Composer>> composers_of(const std::vector<FilmPanel>& panels,
                                                          std::size_t scene,
                                                          std::size_t scenes) {
  if (scenes > 1) return {panels[scene].composer};
  std::vector<std::shared_ptr<const Composer>> all;
  all.reserve(panels.size());
  for (const FilmPanel& panel : panels)
    all.push_back(panel.composer);
  return all;
}

// What is set for several panels at one place has a use if it has one in any of them.
void warn_of_unused_settings(const std::vector<Solved>& solved,
                             const std::vector<FilmPanel>& panels) {
  std::vector<std::string> views;
  for (const Solved& one : solved) {
    const std::vector<std::string>& own = one.scene.show.views;
    views.insert(views.end(), own.begin(), own.end());
  }
  std::map<std::string, std::ptrdiff_t> told;  // in how many panels
  for (std::size_t i = 0; i < solved.size(); ++i) {
    const Scene& scene = solved[i].scene;
    const auto composers = composers_of(panels, i, solved.size());
    for (const Error& unused : unused_settings(scene, composers, views)) {
      // the scale of all panels depends on it, whatever its own shows
      const bool scales_all = solved.size() > 1 && solved.front().scene.same_scales;
      if (scales_all && unused.place().key == "show.vector_length") continue;
      const std::string words = placed(scene, unused).what();
      const auto of_this_place =
          std::count_if(solved.begin(), solved.end(), [&](const Solved& other) {
            return placed(other.scene, unused).what() == words;
          });
      if (++told[words] == of_this_place) spdlog::warn("{}", words);
    }
  }
}

// what is to be said of each of the panels: what one of them shows is not missing
std::vector<Error> warnings_of_all(const std::vector<std::shared_ptr<const Composer>>& composers) {
  std::vector<Error> common = composers.front()->warnings();
  for (std::size_t i = 1; i < composers.size() && !common.empty(); ++i) {
    const std::vector<Error> others = composers[i]->warnings();
    std::erase_if(common, [&](const Error& one) {
      return std::none_of(others.begin(), others.end(), [&](const Error& other) {
        return other.place().key == one.place().key;
      });
    });
  }
  return common;
}

}  // namespace

void warn_of_missing_fonts() {
  for (const FontFound& font : examine_fonts()) {
    if (font.found.empty()) throw environment_error("no font is there; install {}", font.package);
    if (font.damaged) {
      throw environment_error(
          "the font {} cannot be read; install {} again", font.found, font.package);
    }
    if (font.there) continue;
    spdlog::warn("the font {} is missing, so {} is used instead; install {}",
                 font.wanted,
                 font.found,
                 font.package);
  }
}

void warn_of_missing_letters(const std::vector<Solved>& solved) {
  const Typesetter typesetter;
  for (std::size_t panel = 0; panel < solved.size(); ++panel) {
    const Scene& scene = solved[panel].scene;
    std::vector<std::pair<std::string, std::string>> texts = {{"show.caption", scene.show.caption}};
    // all panels are in the first scene
    const std::vector<ScenePanel>& panels = solved.front().scene.panels;
    if (panel < panels.size()) texts.emplace_back("caption of its panel", panels[panel].caption);
    if (scene.show.title) texts.emplace_back("title", scene.title);
    for (std::size_t i = 0; i < scene.story.size(); ++i)
      texts.emplace_back(fmt::format("story[{}].caption", i), scene.story[i].caption.value_or(""));
    const VectorNames names = scene.show.names.value_or(VectorNames());
    for (const auto& name : {names.omega,
                             names.momentum,
                             names.torque,
                             names.gravity,
                             names.frame_rotation,
                             names.x,
                             names.y,
                             names.z})
      texts.emplace_back("show.names", name.value_or(""));
    for (const auto& [key, text] : texts) {
      const int missing = typesetter.missing_letters(plain_text(text));
      if (missing == 0) continue;
      const Error warning = input_error(
          "no font here has {} of the letters of '{}', which become boxes; install one that has "
          "them, such as fonts-noto-cjk for Chinese, Japanese and Korean",
          missing,
          text);
      warn_at(scene, key.c_str(), warning);
    }
  }
}

void warn_of_film(const std::vector<Solved>& solved, const FrameTimes& frames, const Film& film) {
  const Scene& scene = solved.front().scene;
  const std::vector<FilmPanel>& panels = film.panels();
  // of a film of several, the title is that of the film
  if (solved.size() == 1 && scene.show.title && scene.title.empty())
    warn_at(scene, "show.title", input_error("shows nothing: the scene has no title"));
  warn_of_sizes(scene, panels);
  warn_of_lengths(solved);
  warn_of_open_loop(scene, frames);
  warn_of_stretched_clock(scene, frames);
  warn_of_part_of_loop(scene, frames);
  warn_of_jump(scene, frames, *panels.front().composer);
  warn_of_what_restarts(scene, frames, *panels.front().composer);
  warn_of_what_never_comes(scene, panels);
  warn_of_what_comes_too_late(scene, frames);
  warn_of_captions_between_frames(scene, frames);
  warn_of_unused_settings(solved, panels);
  for (std::size_t i = 0; i < solved.size(); ++i) {
    const Solved& one = solved[i];
    const auto composers = composers_of(panels, i, solved.size());
    for (const Error& warning : warnings_of_all(composers))
      spdlog::warn("{}", placed(one.scene, warning).what());
    warn_of_backward_turning(one.scene, one.simulation.motion, frames, shown_of(scene, frames, i));
    if (!scene.in_turn) warn_of_running_contact(one.scene, *panels[i].composer, frames);
  }
}

}  // namespace polhode
