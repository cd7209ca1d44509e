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

constexpr int kAbsent = -1;
// Prices, in heights of a label that it stands from its wish for one moment. A change of sides
// costs a fixed price and that of its way.
constexpr double kOverMark = 30.0;  // over the head of an arrow
constexpr double kOverText = 60.0;  // over text, another label, or the edge of the frame
constexpr double kOverShaft = 2.0;  // over a vector
constexpr double kChange = 4.0;
constexpr double kWay = 2.0;  // for each height of the label

using Prices = std::array<double, kLabelSides>;
struct Choice {
  double price = 0.0;  // of the best sides up to this moment
  int before = 0;      // the side at the moment before
};

// The weights with which a uniform cubic spline takes its four control points, at the fraction
// `part` (0..1) of the step between the middle two.
std::array<double, 4> spline_weights(double part) {
  const double rest = 1.0 - part;
  return {rest * rest * rest / 6.0,
          (3.0 * part * part * part - 6.0 * part * part + 4.0) / 6.0,
          (3.0 * rest * rest * rest - 6.0 * rest * rest + 4.0) / 6.0,
          part * part * part / 6.0};
}

TextRoom room_on(const LabelWish& wish, int side, double gap) {
  return room_at(center_on(wish, side, gap), wish.width, wish.height);
}

bool any_overlaps(const TextRoom& room, const std::vector<TextRoom>& others) {
  return std::any_of(
      others.begin(), others.end(), [&](const TextRoom& other) { return overlap(room, other); });
}

// the price of each side for one moment
Prices prices_of(const LabelWish& wish,
                 const LabelMoment& moment,
                 const std::vector<TextRoom>& labels,
                 const TextRoom& frame,
                 double gap) {
  Prices prices{};
  const Vec2 wished = center_on(wish, 0, gap);
  for (int side = 0; side < kLabelSides; ++side) {
    const TextRoom room = room_on(wish, side, gap);
    const TextRoom with_gap = grown(room, 0.9 * gap, 0.9 * gap);
    double& price = prices[static_cast<std::size_t>(side)];
    price = (room.center() - wished).norm() / wish.height;
    const bool is_inside = room.left >= frame.left && room.right <= frame.right &&
                           room.top >= frame.top && room.bottom <= frame.bottom;
    if (!is_inside) price += kOverText;
    if (any_overlaps(with_gap, moment.obstacles.text)) price += kOverText;
    if (any_overlaps(with_gap, labels)) price += kOverText;
    if (any_overlaps(grown(room, 0.4 * gap, 0.4 * gap), moment.obstacles.marks)) price += kOverMark;
    for (const TextShaft& shaft : moment.shafts)
      if (is_over(room, shaft)) price += kOverShaft;
  }
  return prices;
}

// the cheapest side at each moment; `prices` are absent where the label is
std::vector<int> cheapest(const std::vector<std::optional<Prices>>& prices,
                          const std::vector<LabelWish>& wishes,
                          double gap) {
  std::vector<std::array<Choice, kLabelSides>> choices(prices.size());
  for (std::size_t k = 0; k < prices.size(); ++k) {
    if (!prices[k]) continue;
    const bool goes_on = k > 0 && prices[k - 1];
    std::array<Vec2, kLabelSides> centers;
    for (int side = 0; side < kLabelSides; ++side)
      centers[static_cast<std::size_t>(side)] = center_on(wishes[k], side, gap);
    for (std::size_t side = 0; side < kLabelSides; ++side) {
      Choice best{goes_on ? std::numeric_limits<double>::infinity() : 0.0, 0};
      for (std::size_t from = 0; goes_on && from < kLabelSides; ++from) {
        double price = choices[k - 1][from].price;
        if (from != side)
          price += kChange + kWay * (centers[from] - centers[side]).norm() / wishes[k].height;
        if (price < best.price) best = {price, static_cast<int>(from)};
      }
      best.price += (*prices[k])[side];
      choices[k][side] = best;
    }
  }
  // back from the end of each time that the label is there
  std::vector<int> sides(prices.size(), kAbsent);
  for (std::size_t k = prices.size(); k-- > 0;) {
    if (!prices[k]) continue;
    if (k + 1 < prices.size() && prices[k + 1]) {
      sides[k] = choices[k + 1][static_cast<std::size_t>(sides[k + 1])].before;
      continue;
    }
    const auto least = std::min_element(
        choices[k].begin(), choices[k].end(), [](const Choice& a, const Choice& b) {
          return a.price < b.price;
        });
    sides[k] = static_cast<int>(least - choices[k].begin());
  }
  return sides;
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

LabelTracks::LabelTracks(const std::vector<LabelMoment>& moments, const TextRoom& frame, double gap)
    : gap_(gap) {
  std::vector<std::string> names;  // in the order in which they come
  for (const LabelMoment& moment : moments) {
    for (const std::string& name : moment.names)
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  std::vector<std::vector<TextRoom>> labels(moments.size());  // those that have their sides
  for (const std::string& name : names) {
    std::vector<std::optional<Prices>> prices(moments.size());
    std::vector<LabelWish> wishes(moments.size());
    for (std::size_t k = 0; k < moments.size(); ++k) {
      const auto found = std::find(moments[k].names.begin(), moments[k].names.end(), name);
      if (found == moments[k].names.end()) continue;
      wishes[k] = moments[k].wishes[static_cast<std::size_t>(found - moments[k].names.begin())];
      prices[k] = prices_of(wishes[k], moments[k], labels[k], frame, gap);
    }
    const Sides sides = cheapest(prices, wishes, gap);
    for (std::size_t k = 0; k < moments.size(); ++k)
      if (sides[k] != kAbsent) labels[k].push_back(room_on(wishes[k], sides[k], gap));
    tracks_[name] = sides;
  }
}

Vec2 LabelTracks::center(const std::string& name, const LabelWish& wish, double at) const {
  Vec2 wished = center_on(wish, 0, gap_);
  const auto found = tracks_.find(name);
  if (found == tracks_.end()) return wished;
  const Sides& sides = found->second;
  const double before = std::floor(at);
  const std::array<double, 4> weights = spline_weights(at - before);
  Vec2 sum = Vec2::Zero();
  double all = 0.0;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const double last = static_cast<double>(sides.size()) - 1.0;
    const double moment = std::clamp(before + static_cast<double>(k) - 1.0, 0.0, last);
    const int side = sides[static_cast<std::size_t>(moment)];
    if (side == kAbsent) continue;
    sum += weights[k] * center_on(wish, side, gap_);
    all += weights[k];
  }
  return all > 0.0 ? Vec2(sum / all) : wished;
}

}  // namespace polhode
