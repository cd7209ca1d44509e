// SPDX-License-Identifier: MIT
// A body on a table: where it touches, what the table does to it, and the paths of the contact.
#include <algorithm>
#include <cmath>

#include "frame/elements/parts.h"

namespace polhode {
namespace {

// Ideal rolling can ask for any friction: what is longer than this, in units of the body's radius,
// is drawn this long.
constexpr double kLongestForce = 1.5 * kForceLength;
constexpr double kTouchRadius = 0.03;  // of the point of contact, in units of the body's radius

// the lowest point of the body at this moment, S, m
Vec3 contact_S(const Scenery& scenery, const Sample& sample) {
  return sample.center_S +
         sample.q_SB * (scenery.motion.model().R_BP * lowest_point(scenery.motion, sample));
}

// Which part of a straight way is outside a sphere that it enters: `start` is where the way begins,
// seen from the centre, and `way` leads to its end. 1 if it does not enter.
double part_outside(const Vec3& start, const Vec3& way, double radius) {
  const double along = -start.dot(way), length2 = way.squaredNorm();
  const double root2 = along * along - length2 * (start.squaredNorm() - radius * radius);
  if (along <= 0.0 || root2 < 0.0) return 1.0;
  return std::min(1.0, (along - std::sqrt(root2)) / length2);
}

// from when on the path has been near the body: the table around it, which a camera takes along
double near_since(const Scenery& scenery, const Vec3& here, double t) {
  const double near = 4.2 * scenery.scale.body;
  for (auto trail = scenery.paths.contact.rbegin(); trail != scenery.paths.contact.rend();
       ++trail) {
    const Path& path = trail->path();
    const auto end = std::upper_bound(path.parameters.begin(), path.parameters.end(), t);
    for (auto i = static_cast<std::size_t>(end - path.parameters.begin()); i > 0; --i) {
      const Vec3 from_here = path.points[i - 1] - here;
      if (from_here.norm() < near) continue;
      const double since = path.parameters[i - 1];
      if (i == path.points.size()) return since;
      const double part = part_outside(from_here, path.points[i] - path.points[i - 1], near);
      return since + part * (path.parameters[i] - since);
    }
  }
  return 0.0;
}

Vec3 drawn_force(const Scenery& scenery, const Vec3& force_S) {
  const Vec3 arrow = scenery.scale.force * force_S;
  const double most = kLongestForce * scenery.scale.body;
  return arrow.norm() > most ? Vec3(most * arrow.normalized()) : arrow;
}

}  // namespace

std::string needs_table(const Scenery& scenery) {
  return scenery.motion.model().table ? "" : "needs a body on a table (motion.hold = \"table\")";
}

Vec3 lowest_point(const Motion& motion, const Sample& sample) {
  const BodyModel& model = motion.model();
  const Quat q_SP = sample.q_SB * Quat(model.R_BP);
  const Vec3 down_P = down_in_body(q_SP);
  const ContactSurface& surface = *model.table->surface;
  return surface.at(down_P, Vec3::Zero(), surface.lowest(down_P)).arm_P;
}

// normal force upwards and friction along the table, from a dot
void add_contact(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const std::optional<Reaction> found = reaction_at(scenery.motion, sample.t);
  if (!found) return;
  const Vec3 at = contact_S(scenery, sample);
  const Material material = plain(scenery.theme.force, 0.25f);
  const Placement place = ball_placement(at, kTouchRadius * scenery.scale.body);
  glyphs.meshes.push_back({scenery.ball, place, drawn_through(scenery, material)});
  glyphs.marks.push_back({at, kTouchRadius * scenery.scale.body});
  glyphs.reach.push_back(at);
  const Vec3 normal = drawn_force(scenery, found->normal * Vec3::UnitZ());
  add_vector(scenery, at, at + normal, kForceShape, material, glyphs, "<b>N</b>");
  const Vec3 friction = drawn_force(scenery, found->friction_S);
  const float named = name_presence(scenery, friction.norm());
  if (named > 0.0f) {  // a speck without a name would say nothing
    Material of_friction = plain(scenery.theme.friction, 0.25f);
    of_friction.fade = named;
    add_vector(scenery, at, at + friction, kForceShape, of_friction, glyphs, "<b>F</b>");
  }
}

void add_slip(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const std::optional<Reaction> found = reaction_at(scenery.motion, sample.t);
  if (!found || scenery.scale.slip == 0.0) return;
  const Vec3 at = contact_S(scenery, sample);
  add_vector(scenery,
             at,
             at + scenery.scale.slip * found->slip_S,
             kOmegaShape,
             plain(scenery.theme.velocity, 0.25f),
             glyphs,
             "<b>v</b><sub>P</sub>");
}

// on the table in space, and on the body as the body stands now
void add_contact_trail(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const double begins = trail_begins(scenery, sample.t);
  const double on_table =
      scenery.table_goes_along ? near_since(scenery, contact_S(scenery, sample), sample.t) : 0.0;
  for (const Trail& trail : scenery.paths.contact)
    add_path(trail, std::max(begins, on_table), sample.t, scenery.theme.trail, glyphs);
  const Placement space_from_body = body_placement(scenery, sample);
  const Material material = plain(scenery.theme.force, 0.1f);
  for (const Trail& on_body : scenery.paths.contact_on_body)
    glyphs.paths.push_back({&on_body, begins, sample.t, space_from_body, material, true});
}

}  // namespace polhode
