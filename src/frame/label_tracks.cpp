// SPDX-License-Identifier: MIT
#include "frame/label_tracks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/units.h"

namespace polhode {
namespace {

// Prices, in heights of a label that it stands from its wish for one moment.
constexpr double kOverMark = 200.0;  // over the head of an arrow
constexpr double kOverText = 400.0;  // over text, another label, or the edge of the frame
constexpr double kOverShaft = 8.0;   // over a vector
constexpr double kOverCurve = 2.0;   // over a rim or an arc
constexpr double kPushed = 0.5;      // off a side, where that is taken
constexpr double kChange = 40.0;     // of its place
constexpr double kWay = 4.0;         // for each height of the label that it goes about its tip
// From moment to moment a label glides about its tip by at most so many of its heights; farther it
// changes its place.
constexpr double kGlide = 0.6;

// the sides, and for each the nearest place that is free
constexpr std::size_t kPlaces = 2 * std::size_t{kLabelSides};

bool any_overlaps(const TextRoom& room, const std::vector<TextRoom>& others) {
  return std::any_of(
      others.begin(), others.end(), [&](const TextRoom& other) { return overlap(room, other); });
}

// A place that a label might take at one moment, and the cheapest way there.
struct Choice {
  Vec2 offset = Vec2::Zero();
  double own = std::numeric_limits<double>::infinity();  // its price
  double sum = 0.0;                                      // with that of the cheapest way there
  std::size_t before = 0;  // the place on that way at the moment before
};
using Choices = std::array<Choice, kPlaces>;

// the places of one moment with their own prices
Choices choices_at(const LabelWish& wish,
                   const LabelMoment& moment,
                   const std::vector<TextRoom>& labels,
                   const TextRoom& frame,
                   double gap) {
  Choices choices;
  const Vec2 wished = center_on(wish, 0, gap);
  const auto is_taken = [&](const TextRoom& room) {
    const TextRoom with_gap = grown(room, 0.9 * gap, 0.9 * gap);
    const bool is_inside = room.left >= frame.left && room.right <= frame.right &&
                           room.top >= frame.top && room.bottom <= frame.bottom;
    return !is_inside || any_overlaps(with_gap, moment.obstacles.text) ||
           any_overlaps(with_gap, labels);
  };
  const auto is_over_mark = [&](const TextRoom& room) {
    return any_overlaps(grown(room, 0.4 * gap, 0.4 * gap), moment.obstacles.marks);
  };
  const auto add = [&](std::size_t place, const Vec2& center) {
    const TextRoom room = room_at(center, wish.width, wish.height);
    double sum = (center - wished).norm() / wish.height;
    const bool taken = is_taken(room), over_mark = is_over_mark(room);
    if (taken) sum += kOverText;
    if (over_mark) sum += kOverMark;
    for (const TextShaft& shaft : moment.shafts)
      if (is_over(room, shaft)) sum += kOverShaft;
    const bool over_curve =
        std::any_of(moment.curves.begin(), moment.curves.end(), [&](const TextShaft& piece) {
          return is_over(room, piece);
        });
    if (over_curve) sum += kOverCurve;
    choices[place].offset = center - wish.at;
    choices[place].own = sum;
    return !taken && !over_mark;
  };
  for (std::size_t side = 0; side < kLabelSides; ++side) {
    const Vec2 center = center_on(wish, static_cast<int>(side), gap);
    if (add(side, center)) continue;
    const std::size_t pushed = kLabelSides + side;
    add(pushed, settled_at(wish, center, moment.obstacles, labels, frame, gap));
    choices[pushed].own += kPushed;
  }
  return choices;
}

}  // namespace

Vec2 center_on(const LabelWish& wish, int side, double gap) {
  constexpr int kDirections = 8;
  Vec2 away = wish.away;
  double far = gap;
  if (side > 0) {
    const double angle = 2.0 * kPi * ((side - 1) % kDirections) / kDirections;
    away = Vec2(std::cos(angle), std::sin(angle));
    if (side > kDirections) far += 0.5 * wish.height;
  }
  const double reach = 0.5 * (std::abs(away.x()) * wish.width + std::abs(away.y()) * wish.height);
  return wish.at + (reach + far) * away;
}

std::vector<LabelTracks::Stay> LabelTracks::cheapest(
    const std::vector<LabelMoment>& moments,
    const std::string& name,
    const std::vector<std::vector<TextRoom>>& labels,
    const TextRoom& frame) const {
  const std::size_t count = moments.size();
  std::vector<Choices> choices(count);
  std::vector<const LabelWish*> wishes(count, nullptr);
  const auto stay = [&](std::size_t k, std::size_t place) {
    return Stay{static_cast<int>(place), choices[k][place].offset, false};
  };
  for (std::size_t k = 0; k < count; ++k) {
    const auto found = std::find(moments[k].names.begin(), moments[k].names.end(), name);
    if (found == moments[k].names.end()) continue;
    wishes[k] = &moments[k].wishes[static_cast<std::size_t>(found - moments[k].names.begin())];
    choices[k] = choices_at(*wishes[k], moments[k], labels[k], frame, gap_);
    const bool was_there = k > 0 && wishes[k - 1] != nullptr;
    const double height = wishes[k]->height;
    for (std::size_t place = 0; place < kPlaces; ++place) {
      Choice& here = choices[k][place];
      here.sum = here.own;
      if (!was_there) continue;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t from = 0; from < kPlaces; ++from) {
        const Choice& there = choices[k - 1][from];
        if (!std::isfinite(there.sum)) continue;
        double price = there.sum + kWay * (there.offset - here.offset).norm() / height;
        if ((there.offset - here.offset).norm() > kGlide * height) price += kChange;
        if (price >= least) continue;
        least = price;
        here.before = from;
      }
      here.sum += least;
    }
  }
  // back from the end of each time that the label is there
  std::vector<Stay> stays(count);
  std::size_t place = 0;
  for (std::size_t k = count; k-- > 0;) {
    if (wishes[k] == nullptr) continue;
    if (k + 1 < count && wishes[k + 1] != nullptr) {
      place = choices[k + 1][place].before;
    } else {
      const auto least = std::min_element(
          choices[k].begin(), choices[k].end(), [](const Choice& a, const Choice& b) {
            return a.sum < b.sum;
          });
      place = static_cast<std::size_t>(least - choices[k].begin());
    }
    stays[k] = stay(k, place);
    if (k + 1 < count && wishes[k + 1] != nullptr) {
      stays[k].changes_after =
          (stays[k].offset - stays[k + 1].offset).norm() > kGlide * wishes[k]->height;
    }
  }
  return stays;
}

LabelTracks::LabelTracks(const std::vector<LabelMoment>& moments, const TextRoom& frame, double gap)
    : gap_(gap) {
  std::vector<std::string> names;  // in the order in which they come
  for (const LabelMoment& moment : moments) {
    for (const std::string& name : moment.names)
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  std::vector<std::vector<TextRoom>> labels(moments.size());  // those that have their places
  for (const std::string& name : names) {
    const std::vector<Stay> stays = cheapest(moments, name, labels, frame);
    for (std::size_t k = 0; k < moments.size(); ++k) {
      if (stays[k].side < 0) continue;
      const auto found = std::find(moments[k].names.begin(), moments[k].names.end(), name);
      const LabelWish& wish =
          moments[k].wishes[static_cast<std::size_t>(found - moments[k].names.begin())];
      labels[k].push_back(room_at(wish.at + stays[k].offset, wish.width, wish.height));
    }
    tracks_[name] = stays;
  }
}

LabelPlace LabelTracks::place(const std::string& name, const LabelWish& wish, double at) const {
  const auto found = tracks_.find(name);
  if (found == tracks_.end()) return {center_on(wish, 0, gap_)};
  const std::vector<Stay>& stays = found->second;
  const auto last = static_cast<long>(stays.size()) - 1;
  const auto stay = [&](long k) -> const Stay& {
    return stays[static_cast<std::size_t>(std::clamp(k, 0L, last))];
  };
  const auto k = static_cast<long>(std::floor(std::clamp(at, 0.0, static_cast<double>(last))));
  const double part = std::clamp(at - static_cast<double>(k), 0.0, 1.0);
  const Stay &before = stay(k), &after = stay(k + 1);
  if (before.side < 0 && after.side < 0) return {center_on(wish, 0, gap_)};
  const auto offset = [&](const Stay& one) -> Vec2 {
    return one.side < kLabelSides ? Vec2(center_on(wish, one.side, gap_) - wish.at) : one.offset;
  };
  LabelPlace place;
  if (before.side < 0 || after.side < 0) {
    place.center = wish.at + offset(before.side < 0 ? after : before);
  } else if (before.changes_after) {
    // half-way between the moments
    place.center = wish.at + offset(part < 0.5 ? before : after);
  } else {
    place.center = wish.at + (1.0 - part) * offset(before) + part * offset(after);
  }
  for (long j = k - 3; j <= k + 3; ++j) {
    if (j < 0 || j > last || !stay(j).changes_after) continue;
    const double away = std::abs(at - (static_cast<double>(j) + 0.5));
    place.opacity = std::min(place.opacity, away / kMomentsOfFade);
  }
  return place;
}

}  // namespace polhode
