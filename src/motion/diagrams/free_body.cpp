// SPDX-License-Identifier: MIT
// A free body keeps |L| and its energy. Seen from it, the tip of L goes round a polhode: a curve of
// equal energy on the sphere of |L|.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/units.h"
#include "motion/diagram.h"

namespace polhode {
namespace {

constexpr int kMapPieces = 400;  // of a curve

// "Ω₂" for the axis 1
std::string with_number(const char* letter, int axis) {
  static const std::array<const char*, 3> numbers = {"₁", "₂", "₃"};
  return letter + std::string(numbers[static_cast<std::size_t>(axis)]);
}

// Principal axes by what they are to the motion: `round` is the axis of the least or the greatest
// moment around which L goes, `other` the other one of these. A symmetric top has its axis of
// symmetry as `other`; there, `middle` is any across it.
struct FreeBody {
  int round = 0, middle = 1, other = 2;
  double side = 1.0;     // of the axis `round` on which L is, 1 or -1
  double L = 0.0;        // its length
  double energy2 = 0.0;  // twice the energy, J
  Vec3 inverse;          // of the moments

  bool is_symmetric() const {
    return std::abs(inverse[round] - inverse[middle]) <= 1e-9 * inverse.maxCoeff();
  }
};

FreeBody free_body(const Motion& motion) {
  const BodyModel& model = motion.model();
  const Vec3 y = motion.state_at(0.0).y;
  FreeBody body;
  body.L = y.norm();
  body.inverse = model.inverse_moments;
  body.energy2 = y.cwiseAbs2().dot(body.inverse);
  if (model.kind.symmetric()) {
    body.other = model.kind.axis;
    body.round = (body.other + 1) % 3;
    body.middle = (body.other + 2) % 3;
  } else {
    std::array<int, 3> order = {0, 1, 2};
    std::sort(order.begin(), order.end(), [&](int a, int b) {
      return model.moments[a] < model.moments[b];
    });
    body.middle = order[1];
    const bool about_greatest = y.squaredNorm() >= body.energy2 * model.moments[order[1]];
    body.round = about_greatest ? order[2] : order[0];
    body.other = about_greatest ? order[0] : order[2];
  }
  body.side = y[body.round] < 0.0 ? -1.0 : 1.0;
  return body;
}

Vec3 momentum_P(const Motion& motion, double t) {
  return motion.state_at(t).y;
}

// The curves of the map on which 2 E / L^2 is `level`: longitude in degrees, sine of the latitude.
// With x = longitude, z = sine: level = (1 - z^2)(cos^2 x/I_round + sin^2 x/I_middle) +
// z^2/I_other.
std::vector<std::vector<Vec2>> polhodes(const FreeBody& body, double level) {
  const double round = body.inverse[body.round];
  const double middle = body.inverse[body.middle];
  const double other = body.inverse[body.other];
  const auto height = [&](double x) {
    const double s = std::sin(x);
    const double equator = round + (middle - round) * s * s;
    return std::sqrt(std::clamp((level - equator) / (other - equator), 0.0, 1.0));
  };
  std::vector<std::vector<Vec2>> curves;
  const bool loops = !body.is_symmetric() && (level - middle) * (round - middle) > 0.0;
  if (!loops) {
    for (const double side : {1.0, -1.0}) {
      curves.emplace_back();
      for (int i = 0; i <= kMapPieces; ++i) {
        const double x = kPi * (2.0 * i / kMapPieces - 1.0);
        curves.back().emplace_back(x / kDegree, side * height(x));
      }
    }
    return curves;
  }
  const double most =
      std::asin(std::sqrt(std::clamp((level - round) / (middle - round), 0.0, 1.0)));
  // from the turn `from` on, about the longitude `center`
  const auto add = [&](double center, double from, double turns) {
    curves.emplace_back();
    for (int i = 0; i <= kMapPieces; ++i) {
      const double turn = from + 2.0 * kPi * turns * i / kMapPieces;
      const double x = most * std::sin(turn);
      curves.back().emplace_back(center + x / kDegree,
                                 std::cos(turn) < 0.0 ? -height(x) : height(x));
    }
  };
  add(0.0, 0.0, 1.0);
  // the loop on the far side is cut in two
  add(-180.0, 0.0, 0.5);
  add(180.0, kPi, 0.5);
  return curves;
}

}  // namespace

std::string why_not_polhodes(const Motion& motion) {
  const BodyModel& model = motion.model();
  const bool free = model.chi_P.squaredNorm() == 0.0 && !model.loads.turn_body() && !model.table;
  const bool turns = motion.state_at(0.0).y.norm() > 0.0;
  if (free && turns && !model.kind.rotator && model.kind.shape != TopKind::Shape::spherical)
    return {};
  return "needs a turning body on which no torque acts, neither a sphere nor a thin rod";
}

std::string why_not_middle(const Motion& motion) {
  const bool asymmetric = motion.model().kind.shape == TopKind::Shape::asymmetric;
  if (why_not_polhodes(motion).empty() && asymmetric) return {};
  return "needs a turning asymmetric body on which no torque acts";
}

// Euler's equation of the middle axis, squared: (dL2/dt)^2 = L1^2 L3^2 (1/I1 - 1/I3)^2, where L1^2
// and L3^2 follow from L2 by energy and momentum; so (dw2/dt)^2 / 2 + V(w2) = 0.
Diagram middle_potential(const Motion& motion) {
  using Kind = DiagramCurve::Kind;
  const FreeBody body = free_body(motion);
  const double a = body.inverse[body.round], m = body.inverse[body.middle];
  const double c = body.inverse[body.other];
  const double L2 = body.L * body.L;
  // of L_middle^2, where L_round and L_other vanish
  const double first = std::max(0.0, (body.energy2 - L2 * c) / (m - c));
  const double second = std::max(0.0, (body.energy2 - L2 * a) / (m - a));
  const auto potential = [=](double w) {
    const double x2 = w * w / (m * m);
    // (a - c)^2 L_round^2 L_other^2
    const double product = -(m - c) * (m - a) * (first - x2) * (second - x2);
    return -0.5 * m * m * product;
  };
  const double inner = m * std::sqrt(std::min(first, second));
  const double outer = m * std::sqrt(std::max(first, second));
  const double reach = inner > 0.0 ? std::min(1.12 * outer, 1.7 * inner) : 0.6 * outer;
  Diagram diagram;
  diagram.title = "effective potential of " + with_number("Ω", body.middle);
  diagram.across = {with_number("Ω", body.middle), "rad/s", -reach, reach};
  if (!(reach > 0.0)) diagram.across.low = -1.0, diagram.across.high = 1.0;
  DiagramCurve curve{Kind::potential, {}};
  double low = 0.0, high = 0.0;
  for (int i = 0; i <= kMapPieces; ++i) {
    const double w =
        diagram.across.low + (diagram.across.high - diagram.across.low) * i / kMapPieces;
    curve.points.emplace_back(w, potential(w));
    low = std::min(low, curve.points.back().y());
    high = std::max(high, curve.points.back().y());
  }
  const double beside = std::max(0.08 * (high - low), 1e-300);
  diagram.up = {"", "rad²/s⁴", low - beside, high + beside};
  diagram.curves.push_back({Kind::energy, {{diagram.across.low, 0.0}, {diagram.across.high, 0.0}}});
  diagram.curves.push_back(std::move(curve));
  for (const double side : {-1.0, 1.0})
    if (inner > 0.0) diagram.marks.push_back({"", Vec2(side * inner, 0.0)});
  diagram.now = [=](double t) -> Vec2 {
    const double w = m * momentum_P(motion, t)[body.middle];
    return {w, potential(w)};
  };
  return diagram;
}

// Equal areas of the map are equal areas of the sphere (Lambert's cylinder), and longitude and
// height are conjugate variables.
Diagram polhode_map(const Motion& motion) {
  using Kind = DiagramCurve::Kind;
  const FreeBody body = free_body(motion);
  const double round = body.inverse[body.round], middle = body.inverse[body.middle];
  const double other = body.inverse[body.other];
  Diagram diagram;
  diagram.title = "polhodes";
  const auto add = [&](double level, Kind kind) {
    for (std::vector<Vec2>& points : polhodes(body, level))
      diagram.curves.push_back({kind, std::move(points)});
  };
  for (const double part : {0.12, 0.35, 0.62, 0.85})
    add(middle + part * (other - middle), Kind::other);
  if (!body.is_symmetric()) {
    for (const double part : {0.2, 0.5, 0.8})
      add(round + part * (middle - round), Kind::other);
    add(middle, Kind::separatrix);
    const std::string far = with_number("−ê", body.round), near = with_number("ê", body.round);
    diagram.marks.push_back({body.side > 0.0 ? near : far, Vec2::Zero()});
    diagram.marks.push_back({body.side > 0.0 ? far : near, Vec2(180.0, 0.0)});
    diagram.marks.push_back({"", Vec2(-180.0, 0.0)});
    diagram.marks.push_back({with_number("ê", body.middle), Vec2(90.0, 0.0), false});
    diagram.marks.push_back({with_number("−ê", body.middle), Vec2(-90.0, 0.0), false});
  }
  // of the two halves, or loops, the one on which L is
  const double level = body.L > 0.0 ? body.energy2 / (body.L * body.L) : 0.0;
  const auto place = [=](const Vec3& y) -> Vec2 {
    return {std::atan2(y[body.middle], body.side * y[body.round]) / kDegree,
            y.norm() > 0.0 ? y[body.other] / y.norm() : 0.0};
  };
  std::vector<std::vector<Vec2>> own = polhodes(body, level);
  const bool below = own.size() == 2 && place(momentum_P(motion, 0.0)).y() < 0.0;
  diagram.curves.push_back({Kind::motion, std::move(own[below ? 1 : 0])});
  diagram.across = {"longitude of L in the body", "°", -180.0, 180.0};
  diagram.up = {with_number("L", body.other) + "/L", "", -1.0, 1.0};
  diagram.now = [=](double t) -> Vec2 {
    return place(momentum_P(motion, t));
  };
  return diagram;
}

}  // namespace polhode
