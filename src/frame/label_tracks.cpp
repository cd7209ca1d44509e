// SPDX-License-Identifier: MIT
#include "frame/label_tracks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "base/units.h"

namespace polhode {
namespace {

// Prices, in heights of a label that it stands from its wish for one moment.
constexpr double kOverMark = 1000.0;  // over the head of an arrow
constexpr double kOverText = 2000.0;  // over text, another label, or the edge of the frame
constexpr double kOverShaft = 60.0;   // over its own vector
constexpr double kOverOther = 120.0;  // over another one
constexpr double kBehindMark = 40.0;  // with another head of an arrow between it and its tip
constexpr double kBehind = 20.0;      // with another vector there
constexpr double kNearer = 12.0;      // nearer to another vector than to its own
constexpr double kClearly = 0.5;      // heights from which on these two count in full
constexpr double kOverCurve = 2.0;    // over a rim or an arc
constexpr double kOverBody = 20.0;    // of what stands around an ellipse: over the body,
constexpr double kOverRim = 12.0;     // over the ellipse,
constexpr double kUpright = 4.0;      // above or below it and not beside it
constexpr double kPushed = 0.5;       // off a side, where that is taken
constexpr double kChange = 320.0;     // of its place
constexpr double kWay = 4.0;          // for each height of the label that it goes about its tip
// From moment to moment a label glides about its tip by at most so many of its heights; farther it
// changes its place.
constexpr double kGlide = 0.6;

// the sides, and for each the nearest place that is free
constexpr std::size_t kPlaces = 2 * std::size_t{kLabelSides};

// All names in the order in which they take their places. First those of vectors, the shortest
// first, because the ends of long ones are clear of the others; then what names no vector.
std::vector<std::string> in_order(const std::vector<LabelMoment>& moments) {
  struct Mean {
    double sum = 0.0;
    int count = 0;
  };
  std::map<std::string, Mean> lengths;
  for (const LabelMoment& moment : moments) {
    for (std::size_t i = 0; i < moment.names.size(); ++i) {
      Mean& length = lengths[moment.names[i]];
      length.sum += (moment.shafts[i].tip - moment.shafts[i].from).norm();
      ++length.count;
    }
  }
  std::vector<std::pair<double, std::string>> order;
  for (const auto& [name, length] : lengths) {
    const double last = std::numeric_limits<double>::infinity();
    order.emplace_back(length.sum > 0.0 ? length.sum / length.count : last, name);
  }
  std::sort(order.begin(), order.end());
  std::vector<std::string> names;
  names.reserve(order.size());
  for (auto& [length, name] : order)
    names.push_back(std::move(name));
  return names;
}

std::optional<std::size_t> index_of(const std::string& name, const LabelMoment& moment) {
  const auto found = std::find(moment.names.begin(), moment.names.end(), name);
  if (found == moment.names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - moment.names.begin());
}

bool any_overlaps(const TextRoom& room, const std::vector<TextRoom>& others) {
  return std::any_of(
      others.begin(), others.end(), [&](const TextRoom& other) { return overlap(room, other); });
}

// Whether a vector passes between two points.
bool parts(const TextShaft& shaft, const Vec2& a, const Vec2& b) {
  const auto side = [](const Vec2& from, const Vec2& to, const Vec2& point) {
    return (to - from).x() * (point - from).y() - (to - from).y() * (point - from).x();
  };
  return side(shaft.from, shaft.tip, a) * side(shaft.from, shaft.tip, b) < 0.0 &&
         side(a, b, shaft.from) * side(a, b, shaft.tip) < 0.0;
}

Vec2 nearest_on(const TextShaft& shaft, const Vec2& point) {
  const Vec2 along = shaft.tip - shaft.from;
  const double part = along.dot(point - shaft.from) / std::max(along.squaredNorm(), 1e-12);
  return shaft.from + std::clamp(part, 0.0, 1.0) * along;
}

// From a rectangle to a vector, pixels, at its point nearest to the middle of the rectangle.
double distance(const TextRoom& room, const TextShaft& shaft) {
  return distance(room, nearest_on(shaft, room.center()));
}

int side_of(std::size_t place) {
  return static_cast<int>(place % kLabelSides);
}

// the direction of a side of an ellipse
Vec2 direction_of(int side) {
  const double angle = 2.0 * kPi * (side % kLabelDirections) / kLabelDirections;
  return {std::cos(angle), std::sin(angle)};
}

// the ellipse around which a label may stand, as a polygon
std::vector<Vec2> rim_of(const LabelWish& wish) {
  constexpr int kCorners = 32;
  std::vector<Vec2> rim;
  if (!wish.is_around()) return rim;
  for (int k = 0; k < kCorners; ++k) {
    const double angle = 2.0 * kPi * k / kCorners;
    rim.emplace_back(wish.at + std::cos(angle) * wish.half_a + std::sin(angle) * wish.half_b);
  }
  return rim;
}

// A place that a label might take at one moment, and the cheapest way there.
struct Choice {
  Vec2 offset = Vec2::Zero();                            // from anchor_on() its side
  double own = std::numeric_limits<double>::infinity();  // its price
  double sum = 0.0;                                      // with that of the cheapest way there
  std::size_t before = 0;  // the place on that way at the moment before
};
using Choices = std::array<Choice, kPlaces>;

// The places that may be taken at a moment, the cheapest way there first.
std::vector<std::size_t> by_sum(const Choices& choices) {
  std::vector<std::size_t> places;
  for (std::size_t place = 0; place < kPlaces; ++place) {
    if (std::isfinite(choices[place].sum)) places.push_back(place);
  }
  std::stable_sort(places.begin(), places.end(), [&](std::size_t a, std::size_t b) {
    return choices[a].sum < choices[b].sum;
  });
  return places;
}

// the places of the label `index` at one moment with their own prices
Choices choices_at(std::size_t index,
                   const LabelMoment& moment,
                   const std::vector<TextRoom>& labels,
                   const TextRoom& frame,
                   double gap) {
  Choices choices;
  const LabelWish& wish = moment.wishes[index];
  const Vec2 wished = center_on(wish, 0, gap);
  const std::vector<Vec2> rim = rim_of(wish);
  const auto is_taken = [&](const TextRoom& room) {
    const TextRoom with_gap = grown(room, 0.9 * gap, 0.9 * gap);
    const double between = 0.9 * gap_between_names(wish, gap);
    const bool is_inside = room.left >= frame.left && room.right <= frame.right &&
                           room.top >= frame.top && room.bottom <= frame.bottom;
    return !is_inside || any_overlaps(with_gap, moment.obstacles.text) ||
           any_overlaps(grown(room, between, 0.9 * gap), labels);
  };
  const auto is_over_mark = [&](const TextRoom& room) {
    return any_overlaps(grown(room, 0.4 * gap, 0.4 * gap), moment.obstacles.marks);
  };
  const auto add = [&](std::size_t place, const Vec2& center) {
    const TextRoom room = room_at(center, wish.width, wish.height);
    const int side = side_of(place);
    const Vec2 anchor = anchor_on(wish, side);
    // the point from which it should not be parted
    const Vec2 named = wish.is_around() ? anchor : wish.at;
    double sum = (center - wished).norm() / wish.height;
    if (wish.is_around()) {
      sum = (center - anchor).norm() / wish.height + kUpright * std::abs(direction_of(side).y());
      if (overlap(room, moment.body)) sum += kOverBody;
      if (overlap(room, rim)) sum += kOverRim;
    }
    const bool taken = is_taken(room), over_mark = is_over_mark(room);
    if (taken) sum += kOverText;
    if (over_mark) sum += kOverMark;
    // where vectors all but coincide, no side is better than the other
    const double clearly = kClearly * wish.height;
    const double own =
        wish.is_around() ? distance(room, anchor) : distance(room, moment.shafts[index]);
    double nearer = 0.0;
    for (std::size_t i = 0; i < moment.shafts.size(); ++i) {
      const TextShaft& shaft = moment.shafts[i];
      if (is_over(room, shaft)) sum += i == index ? kOverShaft : kOverOther;
      if (i == index) continue;
      if (parts(shaft, named, center)) {
        const double across = (nearest_on(shaft, named) - named).norm();
        sum += kBehind * std::min(1.0, across / clearly);
      }
      nearer = std::max(nearer, own - distance(room, shaft));
    }
    sum += kNearer * std::min(1.0, nearer / clearly);
    const std::vector<TextRoom>& marks = moment.obstacles.marks;
    const bool behind_mark = std::any_of(marks.begin(), marks.end(), [&](const TextRoom& mark) {
      return distance(mark, named) > 0.0 && is_over(mark, {center, named});
    });
    if (behind_mark) sum += kBehindMark;
    const bool over_curve =
        std::any_of(moment.curves.begin(), moment.curves.end(), [&](const TextShaft& piece) {
          return is_over(room, piece);
        });
    if (over_curve) sum += kOverCurve;
    choices[place].offset = center - anchor;
    choices[place].own = sum;
    return !taken && !over_mark;
  };
  std::optional<LabelRoom> free;  // most labels do without
  for (std::size_t side = 0; side < kLabelSides; ++side) {
    const Vec2 center = center_on(wish, static_cast<int>(side), gap);
    if (add(side, center)) continue;
    const std::size_t pushed = kLabelSides + side;
    if (!free) free.emplace(wish, moment.obstacles, labels, frame, gap);
    add(pushed, free->settled_at(center));
    choices[pushed].own += kPushed;
  }
  return choices;
}

}  // namespace

Vec2 anchor_on(const LabelWish& wish, int side) {
  if (!wish.is_around()) return wish.tip();
  const Vec2 d = direction_of(side);
  const double a = d.dot(wish.half_a), b = d.dot(wish.half_b);
  return wish.at + (a * wish.half_a + b * wish.half_b) / std::max(std::hypot(a, b), 1e-12);
}

Vec2 center_on(const LabelWish& wish, int side, double gap) {
  Vec2 away = wish.away;
  Vec2 from = wish.at;
  double far = gap;
  if (wish.is_around()) {
    away = direction_of(side);
    from = anchor_on(wish, side);
    const int round = side / kLabelDirections;  // how often all directions were tried nearer
    far += wish.height * (0.25 + 0.5 * round);
  } else if (side > 2 * kLabelDirections) {
    const double turn = side % 2 == 0 ? 1.0 : -1.0;
    from -= 0.7 * wish.height * wish.away;
    away = turn * Vec2(-wish.away.y(), wish.away.x());
    far += 0.3 * wish.height;
  } else if (side > 0) {
    const double angle = 2.0 * kPi * ((side - 1) % kLabelDirections) / kLabelDirections;
    away = Vec2(std::cos(angle), std::sin(angle));
    if (side > kLabelDirections) far += 0.5 * wish.height;
  }
  const double reach = 0.5 * (std::abs(away.x()) * wish.width + std::abs(away.y()) * wish.height);
  return from + (reach + far) * away;
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
    return Stay{true, side_of(place), choices[k][place].offset, false};
  };
  // How far the label goes to the moment k: about its tip; around an ellipse, which may turn away
  // under it, at most as far as on the picture.
  const auto way_between = [&](std::size_t k, const Stay& before, const Stay& here) {
    const Vec2 center = here.center(*wishes[k]);
    const double way = (before.center(*wishes[k]) - center).norm();
    if (!wishes[k]->is_around()) return way;
    return std::min(way, (before.center(*wishes[k - 1]) - center).norm());
  };
  for (std::size_t k = 0; k < count; ++k) {
    const std::optional<std::size_t> index = index_of(name, moments[k]);
    if (!index) continue;
    wishes[k] = &moments[k].wishes[*index];
    choices[k] = choices_at(*index, moments[k], labels[k], frame, gap_);
    const bool was_there = k > 0 && wishes[k - 1] != nullptr;
    const double height = wishes[k]->height;
    const std::vector<std::size_t> before =
        was_there ? by_sum(choices[k - 1]) : std::vector<std::size_t>{};
    for (std::size_t place = 0; place < kPlaces; ++place) {
      Choice& here = choices[k][place];
      here.sum = here.own;
      if (!was_there || !std::isfinite(here.own)) continue;
      double least = std::numeric_limits<double>::infinity();
      for (const std::size_t from : before) {
        const Choice& there = choices[k - 1][from];
        if (there.sum >= least) break;  // the ways to all others are dearer
        const double way = way_between(k, stay(k - 1, from), stay(k, place));
        const double price =
            there.sum + kWay * way / height + (way > kGlide * height ? kChange : 0.0);
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
          way_between(k + 1, stays[k], stays[k + 1]) > kGlide * wishes[k]->height;
    }
  }
  return stays;
}

LabelTracks::LabelTracks(const std::vector<LabelMoment>& moments, const TextRoom& frame, double gap)
    : gap_(gap) {
  const std::vector<std::string> names = in_order(moments);
  std::vector<std::vector<TextRoom>> labels(moments.size());  // those that have their places
  for (const std::string& name : names) {
    const std::vector<Stay> stays = cheapest(moments, name, labels, frame);
    for (std::size_t k = 0; k < moments.size(); ++k) {
      const std::optional<std::size_t> index = index_of(name, moments[k]);
      if (!index) continue;
      const LabelWish& wish = moments[k].wishes[*index];
      labels[k].push_back(room_at(stays[k].center(wish), wish.width, wish.height));
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
  if (!before.is_there && !after.is_there) return {center_on(wish, 0, gap_)};
  LabelPlace place;
  if (!before.is_there || !after.is_there) {
    place.center = (before.is_there ? before : after).center(wish);
  } else if (before.changes_after) {
    // half-way between the moments
    place.center = (part < 0.5 ? before : after).center(wish);
  } else {
    place.center = (1.0 - part) * before.center(wish) + part * after.center(wish);
  }
  for (long j = k - 3; j <= k + 3; ++j) {
    if (j < 0 || j > last || !stay(j).changes_after) continue;
    const double away = std::abs(at - (static_cast<double>(j) + 0.5));
    place.opacity = std::min(place.opacity, away / kMomentsOfFade);
  }
  return place;
}

}  // namespace polhode
