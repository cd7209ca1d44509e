// SPDX-License-Identifier: MIT
#include "film/film_metadata.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>

namespace polhode {
namespace {

// one line, for the menu of a player
std::string one_line(std::string words) {
  std::replace_if(
      words.begin(), words.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return words;
}

bool says_something(const StoryStep& step) {
  return step.caption && step.caption->find_first_not_of(" \t\r\n") != std::string::npos;
}

// The titles of chapters by the frame in which they begin: the words that are seen then, else that
// the motion pauses.
std::map<int, std::string> titles_of_story(const Timeline& told, const FrameTimes& frames) {
  std::map<int, std::string> titles;
  std::set<int> pausing;
  for (std::size_t i = 0; i < told.steps().size(); ++i) {
    const StoryStep& step = told.steps()[i];
    const int start = frames.frame_at(told.starts()[i]);
    if (step.caption) titles.erase(start);  // new words take the place of the old ones
    if (says_something(step)) titles.emplace(start, one_line(*step.caption));
    if (step.hold > 0.0) pausing.insert(start);
    if (pausing.contains(start)) titles.emplace(start, fmt::format("Pause at {:.4g} s", step.at));
  }
  return titles;
}

std::vector<FilmMetadata::Caption> captions_of(const Timeline& told, const FrameTimes& frames) {
  std::vector<FilmMetadata::Caption> captions;
  for (std::size_t i = 0; i < told.steps().size(); ++i) {
    const StoryStep& step = told.steps()[i];
    if (!step.caption) continue;
    // new words end the old ones
    const int start = std::max(0, frames.frame_at(told.starts()[i]));
    if (!captions.empty()) captions.back().end = start;
    captions.push_back({start, frames.count, *step.caption});
  }
  std::erase_if(captions, [](const FilmMetadata::Caption& caption) {
    return caption.words.empty() || caption.end <= caption.start;
  });
  return captions;
}

std::vector<FilmMetadata::Chapter> chapters_of(const Scene& scene,
                                               const Timeline& told,
                                               const FrameTimes& frames) {
  // of what begins in one frame, panels come first, then the story, then shots
  std::vector<FilmMetadata::Chapter> chapters;
  for (std::size_t i = 0; scene.in_turn && i < scene.panels.size(); ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(scene.panels.size());
    chapters.push_back(
        {frames.frame_at(part * told.film_duration()), one_line(scene.panels[i].caption)});
  }
  for (const auto& [start, title] : titles_of_story(told, frames))
    chapters.push_back({start, title});
  const auto add_shots = [&](std::vector<ShotSpec> shots, double since) {
    std::stable_sort(shots.begin(), shots.end(), [](const ShotSpec& a, const ShotSpec& b) {
      return a.at < b.at;
    });
    std::map<int, std::string> names;  // of those that are seen in a frame: the last ones
    for (const ShotSpec& shot : shots) {
      const double begins = told.film_time(since + shot.at);  // behind a pause
      names[frames.frame_at(begins)] = one_line(shot.name);
    }
    for (const auto& [start, name] : names)
      if (!name.empty()) chapters.push_back({start, name});
  };
  if (scene.in_turn) {
    for (std::size_t i = 0; i < scene.panels.size(); ++i) {
      const Scene& filmed = scene.same_cameras ? scene : scene.panels[i].scene;
      add_shots(filmed.shots, static_cast<double>(i) * scene.motion.duration);
    }
  } else {
    add_shots(scene.shots, 0.0);
  }
  std::stable_sort(chapters.begin(), chapters.end(), [](const auto& a, const auto& b) {
    return a.start < b.start;
  });
  const auto same_start = [](const auto& a, const auto& b) {
    return a.start == b.start;
  };
  chapters.erase(std::unique(chapters.begin(), chapters.end(), same_start), chapters.end());
  std::erase_if(chapters, [&](const auto& chapter) { return chapter.start >= frames.count; });

  // what began before the piece holds at its start
  std::size_t before = 0;
  while (before < chapters.size() && chapters[before].start <= 0) {
    ++before;
  }
  if (before > 0) {
    chapters.erase(chapters.begin(), chapters.begin() + static_cast<std::ptrdiff_t>(before) - 1);
    chapters.front().start = 0;
  } else if (!chapters.empty()) {
    chapters.insert(chapters.begin(), {0, scene.title.empty() ? "Start" : one_line(scene.title)});
  }
  return chapters;
}

}  // namespace

FilmMetadata film_metadata(const Scene& scene,
                           const std::vector<StoryStep>& story,
                           const FrameTimes& frames) {
  const Timeline told = frames.timeline.retold(story_of_film(scene, story));
  FilmMetadata metadata;
  metadata.frames = frames.count;
  metadata.captions = captions_of(told, frames);
  metadata.chapters = chapters_of(scene, told, frames);

  std::set<int> keys;
  for (const Pause& pause : told.pauses()) {
    keys.insert({frames.frame_at(pause.begins), frames.frame_at(pause.ends)});
  }
  for (const FilmMetadata::Chapter& chapter : metadata.chapters) {
    keys.insert(chapter.start);
  }
  std::erase_if(keys, [&](int frame) { return frame <= 0 || frame >= frames.count; });
  metadata.key_frames.assign(keys.begin(), keys.end());
  return metadata;
}

}  // namespace polhode
