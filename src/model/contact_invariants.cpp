// SPDX-License-Identifier: MIT
#include "model/contact_invariants.h"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

constexpr double kOnAxis = 1e-12;  // of the reach: so far a centre may be beside the axis

Vec3 arm_of(const BodyModel& m, const Moving& now) {
  const Vec3 down_P = down_in_body(now.q);
  const ContactSurface& surface = *m.table->surface;
  return surface.at(down_P, Vec3::Zero(), surface.lowest(down_P)).arm_P;
}

Vec3 up_in(const Moving& now) {
  return now.q.conjugate() * Vec3::UnitZ();
}

// forces at the contact only, whatever they are
bool acts_at_contact(const BodyModel& m) {
  const Friction& law = m.table->friction;
  return is_level_and_unloaded(m) && law.rolling == 0.0 && law.boring == 0.0;
}

bool is_frictionless(const BodyModel& m) {
  return is_level_and_unloaded(m) && m.table->friction.kind == Friction::Kind::none;
}

bool rolls_freely(const BodyModel& m) {
  return acts_at_contact(m) && m.table->friction.kind == Friction::Kind::rolling &&
         m.table->friction.turntable == 0.0;
}

bool is_centred_sphere(const BodyModel& m) {
  const SurfacePiece* sphere = m.table->surface->as_sphere();
  return sphere != nullptr && sphere->center_P.norm() <= kOnAxis * m.table->surface->reach();
}

bool keeps_jellett(const BodyModel& m) {
  EccentricSphere sphere;
  return acts_at_contact(m) && (is_centred_sphere(m) || is_eccentric_sphere(m, sphere));
}

Vec3 only(double value) {
  return {value, 0.0, 0.0};
}

double momentum_at_start(const BodyModel&, const Moving& start) {
  return start.y.norm();
}

Vec3 routh(const BodyModel& m, const Moving& now) {
  EccentricSphere s;
  is_eccentric_sphere(m, s);
  const double cosine = s.axis_P.dot(up_in(now));
  const double along = angular_velocity(m, now.y).dot(s.axis_P);
  const double mR2 = m.body.mass * s.radius * s.radius;
  const double away = cosine - s.offset;
  return only(along * std::sqrt(s.across * s.along + mR2 * (s.across * (1.0 - cosine * cosine) +
                                                            s.along * away * away)));
}

}  // namespace

bool is_level_and_unloaded(const BodyModel& model) {
  return model.loads.empty() && horizontal(model.gravity_S).isZero(0.0);
}

bool is_eccentric_sphere(const BodyModel& model, EccentricSphere& sphere) {
  const SurfacePiece* piece = model.table->surface->as_sphere();
  if (piece == nullptr) return false;
  const double away = piece->center_P.norm();
  const bool centred = away <= kOnAxis * model.table->surface->reach();
  const bool spherical = model.kind.shape == TopKind::Shape::spherical;
  if (!spherical && !model.kind.symmetric()) return false;
  sphere.radius = piece->ball;
  sphere.offset = centred ? 0.0 : away / piece->ball;
  sphere.axis_P = spherical ? (centred ? Vec3(Vec3::UnitZ()) : Vec3(piece->center_P / away))
                            : Vec3(Vec3::Unit(model.kind.axis));
  const int axis = model.kind.axis;
  sphere.across = model.moments[(axis + 1) % 3];
  sphere.along = model.moments[axis];
  if (centred || spherical) return true;
  if (piece->center_P.cross(sphere.axis_P).norm() > kOnAxis * away) return false;
  if (piece->center_P.dot(sphere.axis_P) < 0.0) sphere.axis_P = -sphere.axis_P;
  return true;
}

bool is_of_revolution(const BodyModel& model, Vec3& axis_P) {
  const std::vector<SurfacePiece>& pieces = model.table->surface->pieces();
  EccentricSphere sphere;
  if (is_eccentric_sphere(model, sphere)) {
    axis_P = sphere.axis_P;
    return true;
  }
  const bool spherical = model.kind.shape == TopKind::Shape::spherical;
  if (!spherical && !model.kind.symmetric()) return false;
  axis_P = spherical ? Vec3(pieces.front().R_PD.col(2)) : Vec3(Vec3::Unit(model.kind.axis));
  const double noise = kOnAxis * model.table->surface->reach();
  return std::all_of(pieces.begin(), pieces.end(), [&](const SurfacePiece& p) {
    const Vec3& a = p.semi_axes;
    const bool round = p.ring == 0.0 && a.isZero(0.0) && !p.outline;
    const bool about_axis =
        p.R_PD.col(2).cross(axis_P).norm() <= 1e-9 && std::abs(a.x() - a.y()) <= noise;
    return p.center_P.cross(axis_P).norm() <= noise && (round || about_axis);
  });
}

// Long, because it is one table: a row for each.
const std::vector<ContactInvariant>& contact_invariants() {
  static const std::vector<ContactInvariant> table = {
      // L' . r = 0, as forces act at r; L . r' = L . (w x c) = 0 for a centre c on the axis
      {"jellett",
       "Jellett's constant -L . r, with r from the centre of mass to the contact, whatever the "
       "friction",
       "kg m^3/s",
       keeps_jellett,
       // not the negative: of nothing that would be -0
       [](const BodyModel& m, const Moving& now) { return only(0.0 - now.y.dot(arm_of(m, now))); },
       [](const BodyModel& m, const Moving& start) {
         return start.y.norm() * m.table->surface->reach();
       }},
      {"momentum_about_contact",
       "angular momentum about the contact, a vector (Chaplygin's ball)",
       "kg m^2/s",
       [](const BodyModel& m) { return rolls_freely(m) && is_centred_sphere(m); },
       [](const BodyModel& m, const Moving& now) -> Vec3 {
         return now.q * now.y - (now.q * arm_of(m, now)).cross(m.body.mass * now.velocity_S);
       },
       momentum_at_start},
      {"routh",
       "Routh's constant omega3 sqrt(I1 I3 + m R^2 (I1 sin^2 + I3 (cos - e)^2)) of a sphere that "
       "rolls",
       "kg m^2 rad/s",
       [](const BodyModel& m) {
         EccentricSphere sphere;
         return rolls_freely(m) && is_eccentric_sphere(m, sphere);
       },
       routh,
       momentum_at_start,
       true},
      {"vertical_momentum",
       "angular momentum about the vertical through the centre of mass",
       "kg m^2/s",
       is_frictionless,
       [](const BodyModel&, const Moving& now) { return only(now.y.dot(up_in(now))); },
       momentum_at_start},
      {"axial_momentum",
       "angular momentum about the axis of a body of revolution",
       "kg m^2/s",
       [](const BodyModel& m) {
         Vec3 axis_P;
         return is_frictionless(m) && is_of_revolution(m, axis_P);
       },
       [](const BodyModel& m, const Moving& now) {
         Vec3 axis_P;
         is_of_revolution(m, axis_P);
         return only(now.y.dot(axis_P));
       },
       momentum_at_start},
      {"horizontal_velocity",
       "horizontal velocity of the centre of mass",
       "m/s",
       is_frictionless,
       [](const BodyModel&, const Moving& now) {
         return Vec3(now.velocity_S.x(), now.velocity_S.y(), 0.0);
       },
       [](const BodyModel& m, const Moving& start) {
         return start.velocity_S.norm() + std::sqrt(m.gravity_S.norm() * m.table->surface->reach());
       }},
  };
  return table;
}

std::vector<const ContactInvariant*> invariants_from(const BodyModel& model, const Moving& start) {
  const bool touches = is_on_table(model, start);
  std::vector<const ContactInvariant*> found;
  for (const ContactInvariant& law : contact_invariants()) {
    if (law.holds(model) && (touches || !law.while_touching)) found.push_back(&law);
  }
  return found;
}

}  // namespace polhode
