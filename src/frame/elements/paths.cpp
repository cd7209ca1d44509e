// SPDX-License-Identifier: MIT
// Paths of points in space, and curves of a whole film.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "frame/elements.h"
#include "frame/elements/parts.h"
#include "math/so3.h"

namespace polhode {
namespace {

constexpr int kFamily = 9;  // polhodes between two axes

// as much of a trail as the scene lets it be long
void add_tail(const Scenery& scenery,
              const Sample& sample,
              const Trail& trail,
              const glm::vec3& color,
              Glyphs& glyphs) {
  const double begins = trail_begins(scenery, sample.t);
  add_path(trail, begins, sample.t, color, glyphs);
  // what is not drawn yet needs no place: a camera that goes along comes nearer
  add_path_reach(trail, begins, sample.t, glyphs);
}

}  // namespace

double trail_begins(const Scenery& scenery, double t) {
  return std::max(0.0, t - scenery.options.trail_s.value_or(scenery.motion.duration()));
}

void add_path(const Trail& trail, double from, double to, const glm::vec3& color, Glyphs& glyphs) {
  if (trail.empty()) return;
  glyphs.paths.push_back({&trail, from, to, Placement::Identity(), plain(color, 0.1f)});
  const Path& path = trail.path();
  const auto first = std::lower_bound(path.parameters.begin(), path.parameters.end(), from);
  constexpr std::size_t kPieces = 40;
  const auto last = std::upper_bound(first, path.parameters.end(), to);
  add_line(
      [&](std::size_t i) {
        return path.points[static_cast<std::size_t>(first - path.parameters.begin()) + i];
      },
      static_cast<std::size_t>(last - first),
      kPieces,
      glyphs);
}

void add_path_reach(const Trail& trail, double from, double to, Glyphs& glyphs) {
  if (!glyphs.for_framing) return;
  const Path& path = trail.path();
  const auto first = std::lower_bound(path.parameters.begin(), path.parameters.end(), from);
  for (auto i = static_cast<std::size_t>(first - path.parameters.begin());
       i < path.points.size() && path.parameters[i] <= to;
       i += 8)
    glyphs.reach.push_back(path.points[i]);
}

// the path of the axis, and the axis from the body to where it writes: else the path would hover
void add_trail(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const Vec3 tip_B = kTrailRadius * scenery.scale.body * figure_axis_B(scenery.motion.model());
  glyphs.rods.push_back({sample.reference_S,
                         sample.reference_S + sample.q_SB * tip_B,
                         kRimRadius * scenery.scale.body,
                         plain(scenery.theme.body_axes, 0.1f)});
  add_tail(scenery, sample, scenery.paths.axis, scenery.theme.trail, glyphs);
}

void add_point_trails(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  for (const Trail& trail : scenery.paths.points)
    add_tail(scenery, sample, trail, scenery.theme.trail, glyphs);
}

void add_tip_trails(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  add_tail(scenery, sample, scenery.paths.omega_tip, scenery.theme.omega, glyphs);
  add_tail(scenery, sample, scenery.paths.momentum_tip, scenery.theme.momentum, glyphs);
}

// the sphere on which the body's axis writes
void add_trail_sphere(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const Placement place =
      ball_placement(sample.reference_S, 0.997 * kTrailRadius * scenery.scale.body);
  glyphs.shells.push_back({scenery.sphere, place, shell(scenery.theme.space_axes, 0.12f)});
  add_ball_reach(place, glyphs);
}

namespace {

// how many straight pieces, of a tenth of a turn at most, a path through the whole motion has
double pieces_of_trail(const Motion& motion) {
  return std::max(64.0, fastest_turn(motion) * motion.duration() / 0.6);
}

// angular velocities of the same energy, other momenta: along the great circle through the axes of
// the smallest and the largest moment, whose polhodes cover both sides of the separatrix, but not
// those that lie on it, if it is drawn by itself
std::vector<Vec3> family_of(const BodyModel& model, const Vec3& w_P, bool draws_separatrix) {
  constexpr double kOnSeparatrix = 0.02;  // of the moments' spread
  const double energy2 = twice_the_energy(model, w_P);
  int least = 0, most = 0;
  model.moments.minCoeff(&least);
  model.moments.maxCoeff(&most);
  const double spread = model.moments[most] - model.moments[least];
  const double middle = model.moments.sum() - model.moments[least] - model.moments[most];
  std::vector<Vec3> family;
  for (int k = 0; k < 4 * kFamily; ++k) {
    const double angle = 2.0 * kPi * (k + 0.5) / (4 * kFamily);
    Vec3 w = Vec3::Zero();
    w[least] = std::sqrt(energy2 / model.moments[least]) * std::cos(angle);
    w[most] = std::sqrt(energy2 / model.moments[most]) * std::sin(angle);
    // L^2 / 2T is the middle moment on the separatrix
    const double off = model.moments.cwiseProduct(w).squaredNorm() / energy2 - middle;
    if (!draws_separatrix || std::abs(off) > kOnSeparatrix * spread) family.push_back(w);
  }
  return family;
}

// the number of segments around a tube: pieces of a circle that look round grow as the root of its
// radius
int sides_of(const Scenery& scenery, double radius) {
  return std::max(8, static_cast<int>(std::ceil(scenery.segments * std::sqrt(radius))));
}

// when something begins and ends, s of motion
using Stretch = std::pair<double, double>;

// How finely a path through the whole motion is sampled.
struct Fineness {
  int pieces = 0;               // as for sampled()
  std::size_t most_points = 0;  // of each path: all together have no more than three of them may
  bool coarse = false;          // pieces go over whole turns
};

Fineness fineness_of(const Motion& motion, std::size_t paths) {
  const std::size_t most = 3 * kMostPointsOfPath / std::max<std::size_t>(3, paths);
  const double wanted = pieces_of_trail(motion), given = static_cast<double>(most) / 2.0;
  return {static_cast<int>(std::min(wanted, given)), most, wanted > given};
}

// The path of a point during a stretch of the film. radius: in units of the body's radius.
Trail trail_during(const Scenery& scenery,
                   const Stretch& stretch,
                   const Fineness& fine,
                   double radius,
                   const std::function<Vec3(const Sample& now)>& point) {
  const Motion& motion = scenery.motion;
  const auto& [from, to] = stretch;
  // a quarter of a pixel where the body is as high as the frame
  const double tolerance = scenery.scale.body * (1.0 - std::cos(kPi / scenery.segments));
  const int pieces = static_cast<int>(std::ceil(fine.pieces * (to - from) / motion.duration()));
  Path path = sampled(
      [&](double t) { return point(motion.at(t)); }, from, to, pieces, tolerance, fine.most_points);
  // equal steps over whole turns may all meet the same place
  path.coarse = path.coarse || fine.coarse;
  return Trail(
      std::move(path), radius * scenery.scale.body, scenery.scale.body, sides_of(scenery, radius));
}

// when a body is on its table, or so near that nobody sees it fly
std::vector<Stretch> touching(const Scenery& scenery, int looks) {
  constexpr double kTouches = 0.01;  // in units of the body's radius
  const Motion& motion = scenery.motion;
  const auto touches = [&](double t) {
    const Sample now = motion.at(t);
    const Vec3 lowest = motion.model().R_BP * lowest_point(motion, now);
    return now.center_S.z() + (now.q_SB * lowest).z() <= kTouches * scenery.scale.body;
  };
  const auto edge = [&](double on, double off) {
    for (int i = 0; i < 20; ++i) {
      const double middle = 0.5 * (on + off);
      (touches(middle) ? on : off) = middle;
    }
    return on;
  };
  std::vector<Stretch> stretches;
  bool touched = false;
  double before = 0.0;
  for (int i = 0; i <= looks; ++i) {
    const double t = motion.duration() * i / looks;
    const bool now = touches(t);
    if (now && !touched) stretches.emplace_back(i > 0 ? edge(t, before) : t, t);
    if (now) stretches.back().second = t;
    if (!now && touched) stretches.back().second = edge(before, t);
    touched = now;
    before = t;
  }
  return stretches;
}

// Whether it can only touch with edges and tips.
bool touches_with_edges(const ContactSurface& surface) {
  const std::vector<SurfacePiece>& pieces = surface.pieces();
  return std::all_of(pieces.begin(), pieces.end(), [](const SurfacePiece& piece) {
    return piece.semi_axes.isZero(0.0) && piece.ball == 0.0 && !piece.outline;
  });
}

// paths of the contact on the table and on the body, with gaps where it flies
void make_contact_trails(const Scenery& scenery, const Fineness& fine, Paths& paths) {
  const BodyModel& model = scenery.motion.model();
  const auto on_body = [&](const Sample& now) {
    return Vec3(model.body.center + model.R_BP * lowest_point(scenery.motion, now));
  };
  // a camera that stands sees it from afar, where the body goes far
  constexpr double kFar = 0.0035;
  const double whole = scenery.table_goes_along ? 0.0 : scenery.table_reach;
  const double thick = std::max(kRimRadius, kFar * whole / scenery.scale.body);
  // along an edge of the body the path would only be that edge once more
  const bool shows_on_body = !touches_with_edges(*model.table->surface);
  for (const Stretch& stretch : touching(scenery, fine.pieces)) {
    if (stretch.second <= stretch.first) continue;
    paths.contact.push_back(trail_during(scenery, stretch, fine, thick, [&](const Sample& now) {
      const Vec3 at = point_position(model, now, on_body(now));
      // it lies on the table: where a tube is half below, its edges have teeth
      return Vec3(at.x(), at.y(), thick * scenery.scale.body);
    }));
    if (shows_on_body)
      paths.contact_on_body.push_back(trail_during(scenery, stretch, fine, kRimRadius, on_body));
  }
}

// paths of points in space, which grow with the motion
void make_trails(const Scenery& scenery, Paths& paths) {
  const Motion& motion = scenery.motion;
  const auto contact_trail = scenery.options.asked.find("contact_trail");
  const bool shows_contact =
      motion.model().table &&
      (contact_trail == scenery.options.asked.end() || contact_trail->second.value_or(true));
  const std::vector<std::string> tips =
      scenery.options.trail_tips.value_or(std::vector<std::string>());
  const bool shows_axis = asks_for(scenery, "trail");
  const bool shows_herpolhode = asks_for(scenery, "herpolhode");
  const std::size_t count = (shows_axis ? 1 : 0) + (shows_contact ? 2 : 0) + tips.size() +
                            scenery.options.trail_points.size() + (shows_herpolhode ? 1 : 0);
  const Fineness fine = fineness_of(motion, count);
  const auto trail = [&](double radius, const auto& point) {
    return trail_during(scenery, {0.0, motion.duration()}, fine, radius, point);
  };
  if (shows_axis) {
    const Vec3 tip_B = kTrailRadius * scenery.scale.body * figure_axis_B(scenery.motion.model());
    paths.axis = trail(kRimRadius,
                       [&](const Sample& now) { return Vec3(now.reference_S + now.q_SB * tip_B); });
  }
  if (shows_contact) make_contact_trails(scenery, fine, paths);
  for (const Vec3& point_B : scenery.options.trail_points) {
    paths.points.push_back(trail(kRimRadius, [&](const Sample& now) {
      return point_position(motion.model(), now, point_B);
    }));
  }
  for (const std::string& tip : tips) {
    if (tip == "omega") {
      paths.omega_tip =
          trail(kRimRadius, [&](const Sample& now) { return omega_tip(scenery, now); });
    }
    if (tip == "momentum") {
      paths.momentum_tip =
          trail(kRimRadius, [&](const Sample& now) { return momentum_tip(scenery, now); });
    }
  }
  if (!shows_herpolhode) return;
  for (const double t : framing_times(motion)) {
    const Sample now = motion.at(t);
    if (now.L_S.norm() == 0.0) continue;
    const double off = now.w_S.cross(now.L_S.normalized()).norm();
    paths.herpolhode_radius = std::max(paths.herpolhode_radius, scenery.scale.omega * off);
  }
  paths.herpolhode =
      trail(kCurveRadius, [&](const Sample& now) { return omega_tip(scenery, now); });
}

// Where on the separatrix its name stands: off the polhode of the motion, and where the ellipsoid
// turns away from the usual side of a camera that goes with the body, so that it stands beside it.
Vec3 place_of_name(const BodyModel& model,
                   const std::vector<std::vector<Vec3>>& separatrix,
                   const std::vector<Vec3>& polhode) {
  constexpr double kFacing = 0.45;  // the cosine there
  constexpr double kOff = 0.35;     // rad; farther off is no better
  constexpr std::size_t kStep = 8;
  const Vec3 towards = model.R_BP.transpose() * kDefaultDirection.normalized();
  Vec3 best = separatrix.front().front();
  double most = -std::numeric_limits<double>::infinity();
  for (const std::vector<Vec3>& ellipse : separatrix) {
    for (std::size_t i = 0; i < ellipse.size(); i += kStep) {
      double off = kOff;
      for (std::size_t k = 0; k < polhode.size(); k += kStep)
        off = std::min(off, angle_between(ellipse[i], polhode[k]));
      const double facing = model.moments.cwiseProduct(ellipse[i]).normalized().dot(towards);
      const double good = off - std::abs(facing - kFacing);
      if (good <= most) continue;
      most = good;
      best = ellipse[i];
    }
  }
  return best;
}

// closed curves of the body, in units of its radius
void make_body_curves(const Scenery& scenery, Paths& paths) {
  const BodyModel& model = scenery.motion.model();
  const Vec3 w_P = principal_rate(model, scenery.motion.at(0.0));
  const int pieces = 8 * scenery.segments;
  const auto tube = [&](std::vector<Vec3> points, const Vec3& factor, double radius) -> MeshPtr {
    if (points.empty()) return nullptr;
    for (Vec3& point : points)
      point = point.cwiseProduct(factor) / scenery.scale.body;
    return std::make_shared<const Mesh>(
        tube_along(points, radius, sides_of(scenery, radius), true));
  };
  const auto curve = [&](const Vec3& w, const Vec3& factor, double radius) {
    return tube(polhode(model.moments, w, pieces), factor, radius);
  };
  const Vec3 as_omega = Vec3::Constant(scenery.scale.omega);
  if (asks_for(scenery, "polhode")) paths.polhode = curve(w_P, as_omega, kCurveRadius);
  if (asks_for(scenery, "binet"))
    paths.binet = curve(w_P, scenery.scale.momentum * model.moments, kCurveRadius);
  if (!asks_for(scenery, "polhodes")) return;
  const std::vector<std::vector<Vec3>> ellipses = separatrix(model.moments, w_P, pieces);
  for (const Vec3& w : family_of(model, w_P, !ellipses.empty())) {
    if (const MeshPtr mesh = curve(w, as_omega, kRimRadius)) paths.polhodes.push_back(mesh);
  }
  if (ellipses.empty()) return;
  for (const std::vector<Vec3>& ellipse : ellipses)
    paths.separatrix.push_back(tube(ellipse, as_omega, kRimRadius));
  paths.on_separatrix_P = place_of_name(model, ellipses, polhode(model.moments, w_P, pieces));
}

}  // namespace

Paths make_paths(const Scenery& scenery) {
  Paths paths;
  make_trails(scenery, paths);
  make_body_curves(scenery, paths);
  return paths;
}

}  // namespace polhode
