// SPDX-License-Identifier: MIT
#include "lecture/deck/picture_classes.h"

namespace polhode {
namespace {

using Settings = std::vector<PictureSetting>;

Settings joined(Settings first, const Settings& then) {
  first.insert(first.end(), then.begin(), then.end());
  return first;
}

}  // namespace

const std::vector<PictureClass>& picture_classes() {
  static const PictureSetting from = {"from", "time at which it begins, s of the motion (0)"};
  static const PictureSetting to = {
      "to", "time at which it ends, s of the motion (the end of the motion)"};
  static const PictureSetting at = {"at",
                                    "time of the poster, s of the motion (film: the last of its "
                                    "stills, else a third of the way; still: 0)"};
  static const PictureSetting size = {"size",
                                      "WxH, pixels (that of the command line, else of the scene)"};
  static const PictureSetting fps = {
      "fps", "frames per second (that of the command line, else of the scene)"};
  static const PictureSetting theme = {
      "theme", "colours, as video.theme (those of the command line, else of the scene)"};
  static const PictureSetting method = {"method",
                                        "numerical method, as numerics.method (that of the scene)"};
  static const PictureSetting step = {"step", "step of the method, s (that of the scene)"};
  static const PictureSetting alt = {
      "alt", "description of the picture for people who cannot see it (the caption)"};
  static const PictureSetting stills = {
      "stills",
      "times of the pictures in the handout, s of the motion, separated by spaces (the pauses of "
      "the story, else the poster)"};
  static const PictureSetting methods = {
      "methods", "names of the methods to compare, separated by commas (all)"};
  static const Settings of_loop = {at, stills, size, fps, theme, method, step, alt};
  static const Settings of_film = joined({from, to}, of_loop);
  static const std::vector<PictureClass> table = {
      {PictureKind::film, "film", "a film", of_film},
      {PictureKind::loop, "loop", "a film that closes and repeats", of_loop},
      {PictureKind::turn,
       "turn",
       "a film that becomes a model to turn by hand, in page and slides",
       joined(
           {{"clock", "a name: viewers with the same one play together (each by itself)"},
            {"vary",
             "numbers of the scene that get a slider: KEY FROM TO WORDS, separated by ; (none)"}},
           of_film)},
      {PictureKind::still, "still", "one picture", {at, size, theme, method, step, alt}},
      {PictureKind::compare,
       "compare",
       "films side by side on one clock",
       {{"with", "the other scenes, separated by spaces"},
        from,
        to,
        at,
        stills,
        size,
        fps,
        theme,
        alt}},
      {PictureKind::chart,
       "chart",
       "speed against accuracy of the methods",
       {methods,
        {"accuracy", "the accuracy that the chart marks (default: what the scene needs)"},
        alt}},
      {PictureKind::stability,
       "stability",
       "where methods fail",
       {methods,
        {"x", "key on the horizontal axis (numerics.step)"},
        {"y", "key on the vertical axis (spin)"},
        {"x-range", "range of that key, A:B"},
        {"y-range", "range of that key, A:B"},
        {"cells", "number of cells across and upwards, NxM"},
        {"turns", "how far the body turns in each run, in full turns"},
        alt}},
      {PictureKind::inspect,
       "inspect",
       "a table of the numbers",
       {{"keys",
         "keys of inspect, separated by spaces (kind, mass, moments and all derived values)"}}},
  };
  return table;
}

}  // namespace polhode
