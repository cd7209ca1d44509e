// SPDX-License-Identifier: MIT
// What the body stands on, and the body itself.
#include <algorithm>
#include <memory>

#include <glm/common.hpp>

#include "frame/elements/parts.h"
#include "frame/stand.h"

namespace polhode {
namespace {

// wide enough for the shadow of a body that leans, or is high above
constexpr double kFloorRadius = 1.55;
constexpr double kFreeFloorRadius = 2.1;    // under a free body
constexpr double kFramedFloor = 0.587;      // the part of it that a picture has to show
constexpr double kFramedFreeFloor = 0.386;  // of that under a free body
constexpr double kTableAround = 4.5;    // radius of the part of a table that a camera takes along
constexpr double kSeenOfTable = 0.9;    // so far around it the table is framed
constexpr double kSeenOfTravels = 1.6;  // of a body whose path matters
constexpr double kTravels = 2.0;        // a body that goes so far needs lines to be seen moving
constexpr double kLinesOfTable = 7.0;   // at most, from the middle of the table to its rim
constexpr double kFinestTable = 4.0;
constexpr double kGridWidth = 2.0;                        // of its lines, in that of the dial's
constexpr double kThin = 2.8 * kOmegaShape.shaft_radius;  // rods, beside which vectors are no lines
constexpr double kDialRadius = 1.05;                      // in units of the body's radius
constexpr double kFreeDialRadius = 0.8;                   // under a free body
constexpr float kDialAlpha = 0.3f;
constexpr double kSector = 0.14;  // half the angle of what shows how a turntable turns, rad
constexpr float kSectorAlpha = 0.3f;
// how dark a full shadow of the lamp is, and where no light of the sky comes
constexpr float kShadowDepth = 0.42f;
constexpr float kShadeDepth = 0.5f;
constexpr double kBearingRadius = 0.014;  // of axles and bearings, in units of the body's radius
constexpr double kHingeRadius = 0.035;    // in units of the body's radius
constexpr double kTipRadius = 0.022;      // of the axes of an ensemble, likewise
constexpr std::size_t kPaleBodies = 5;    // of an ensemble
constexpr double kApart = 0.08;           // rad from the body until they are seen in full
constexpr float kGhostAlpha = 0.32f;      // of the last earlier position
constexpr float kPaleAlpha = 0.16f;       // of bodies of an ensemble, which lie in each other

// a disc that fades outwards, with a dial of the radius `of_dial` (m), and what lies on it
FloorGlyph floor_at(
    const Scenery& scenery, const Vec3& center, const Vec3& up, double radius, double of_dial) {
  Material floor = plain(scenery.theme.floor, 0.0f);
  floor.flat = floor.soft = true;
  Material shadow = floor;
  shadow.color = scenery.theme.shadow;
  shadow.alpha = kShadowDepth;
  Material lines = floor;
  lines.color = scenery.theme.space_axes;
  lines.alpha = kDialAlpha * static_cast<float>(kDialLine / scenery.dial_line);
  floor.mark_color = glm::mix(floor.color, scenery.theme.shadow, kShadeDepth);
  return {disc_placement(center, up, radius),
          floor,
          shadow,
          {scenery.dial, disc_placement(center, up, of_dial), lines}};
}

// The table is seen all over where the body goes or, if a camera goes along, around the body. Lines
// on it show how a body that travels moves, and whether the table turns.
void add_table(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const double size = scenery.scale.body;
  const Vec3 below(sample.center_S.x(), sample.center_S.y(), 0.0);
  const bool along = scenery.table_goes_along;
  const Vec3 middle = along ? below : scenery.table_middle;
  const double radius = along ? kTableAround * size : kFreeFloorRadius * size + scenery.table_reach;
  FloorGlyph floor = floor_at(scenery, middle, Vec3::UnitZ(), radius, kFreeDialRadius * size);
  floor.material.covers = true;  // vectors through it are seen as those in bodies
  floor.fineness = std::clamp(radius / (kFreeFloorRadius * size), 1.0, kFinestTable);
  const Vec2 origin = -middle.head<2>() / radius;
  const double turntable = scenery.motion.model().table->friction.turntable;
  const double turned = turntable * sample.t;
  if (turntable != 0.0 && origin.norm() < 1.0) {
    floor.sector = floor.dial;
    floor.sector.material.alpha = kSectorAlpha;
    floor.sector.space_from_mesh = floor.place;
    floor.sector.mesh = std::make_shared<const Mesh>(floor_sector(origin, turned, kSector));
  }
  if (along || scenery.table_reach > kTravels * size) {
    const double spacing = along ? size : std::max(size, radius / kLinesOfTable);
    const double width = kGridWidth * scenery.dial_line * std::max(size, radius / kTableAround);
    const auto lines = floor.sector.mesh ? polar_floor_grid : floor_grid;
    floor.grid = floor.dial;
    floor.grid.space_from_mesh = floor.place;
    floor.grid.mesh =
        std::make_shared<const Mesh>(lines(origin, turned, spacing / radius, width / radius));
    floor.dial.mesh = nullptr;
  }
  glyphs.floors.push_back(floor);
  const double seen = scenery.table_reach > kTravels * size ? kSeenOfTravels : kSeenOfTable;
  add_rim_reach(disc_placement(below, Vec3::UnitZ(), seen * size), 16, glyphs);
}

// wider where the body is higher above it
double floor_radius(const Scenery& scenery) {
  return (scenery.motion.model().on_pivot ? kFloorRadius : kFreeFloorRadius) * scenery.scale.body;
}

// where the floor is: under the stand, or below all that a free body reaches
double floor_depth(const Scenery& scenery) {
  return scenery.motion.model().on_pivot ? foot_depth(scenery) : kFreeFloor * scenery.scale.body;
}

// a stand whose tip is at `tip` (S, m)
void add_stand_under(const Scenery& scenery, const Vec3& tip, Glyphs& glyphs) {
  const Vec3& up = scenery.motion.model().up_S;
  const double size = scenery.scale.body;
  Material material = plain(scenery.theme.stand, 0.3f);
  material.covers = true;
  const Placement place = disc_placement(tip, up, size);
  glyphs.meshes.push_back({scenery.stand, place, material, scenery.rough_stand});
  add_rim_reach(
      disc_placement(tip - scenery.stand_height * size * up, up, kStandFoot * size), 8, glyphs);
}

// the body at another place, pale
void add_pale(
    const Scenery& scenery, const Placement& place, float alpha, double fade, Glyphs& glyphs) {
  // a hair smaller, so that faces in one place do not fight: the body hides what lies in it
  constexpr double kSmaller = 0.996;
  const Vec3& center_B = scenery.motion.model().body.center;
  const Placement smaller =
      place * Eigen::Translation3d((1.0 - kSmaller) * center_B) * Eigen::Scaling(kSmaller);
  for (const LookPart& part : scenery.look) {
    Material material = part.material;
    material.alpha = alpha;
    material.fade *= static_cast<float>(fade);
    glyphs.ghosts.push_back({part.mesh, smaller * part.body_from_mesh, material});
  }
}

}  // namespace

void add_body(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const Placement space_from_body = body_placement(scenery, sample);
  for (const LookPart& part : scenery.look) {
    Material material = part.material;
    material.alpha = static_cast<float>(scenery.options.body_opacity);
    material.covers = true;
    material.thin = part.breadth < kThin * scenery.scale.body;
    glyphs.meshes.push_back(
        {part.mesh, space_from_body * part.body_from_mesh, material, part.rough});
  }
  for (const Vec3& point_B : scenery.hull_B)
    glyphs.reach.push_back(space_from_body * point_B);
}

// the body where it was, at equal times back from now; each comes gently
void add_ghosts(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  constexpr double kComes = 0.3;  // of the time between two
  const double apart = scenery.options.ghost_s.value_or(scenery.motion.duration() / 40.0);
  for (int k = scenery.options.ghost_count; k >= 1; --k) {
    const double t = sample.t - k * apart;
    if (t < 0.0) continue;
    const Placement place = body_placement(scenery, scenery.motion.at(t));
    const double older = (k - 1.0) / scenery.options.ghost_count;
    add_pale(scenery,
             place,
             kGhostAlpha * static_cast<float>(1.0 - 0.6 * older),
             std::min(1.0, t / (kComes * apart)),
             glyphs);
    for (const Vec3& point_B : scenery.hull_B)
      glyphs.reach.push_back(place * point_B);
  }
}

// where the axes of the other motions are, on the sphere on which a trail is drawn; and some of
// their bodies
void add_ensemble(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const Vec3 tip_B = kTrailRadius * scenery.scale.body * figure_axis_B(scenery.motion.model());
  const double radius = kTipRadius * scenery.scale.body;
  for (std::size_t i = 0; i < scenery.ensemble.size(); ++i) {
    const Motion& motion = scenery.ensemble[i];
    const Sample now = motion.at(std::min(sample.t, motion.duration()));
    const Vec3 tip = now.reference_S + now.q_SB * tip_B;
    const Placement ball = ball_placement(tip, radius);
    glyphs.meshes.push_back({scenery.ball, ball, plain(scenery.theme.trail, 0.2f)});
    glyphs.reach.push_back(tip);
    if (i >= kPaleBodies) continue;
    // those that are all but where the body is would speckle it
    const double apart = sample.q_SB.angularDistance(now.q_SB) +
                         (now.reference_S - sample.reference_S).norm() / scenery.scale.body;
    const double presence = std::clamp(apart / kApart - 0.2, 0.0, 1.0);
    if (presence == 0.0) continue;
    add_pale(scenery, body_placement(scenery, now), kPaleAlpha, presence, glyphs);
  }
}

void add_stand(const Scenery& scenery, const Sample&, Glyphs& glyphs) {
  add_stand_under(scenery, Vec3::Zero(), glyphs);
}

// the fixed point of a body that leaves no room for a stand, seen through the body
void add_hinge(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const Placement ball = ball_placement(sample.reference_S, kHingeRadius * scenery.scale.body);
  Material material = drawn_through(scenery, plain(scenery.theme.position, 0.3f));
  material.dashes = 0.0f;
  glyphs.meshes.push_back({scenery.ball, ball, material});
  glyphs.marks.push_back({sample.reference_S, kHingeRadius * scenery.scale.body});
  glyphs.reach.push_back(sample.reference_S);
}

// The outer ring turns about the vertical, the inner one in it about the line of nodes, and the
// body in that about its axle: the angles phi, theta and psi. While the axle of rings without mass
// is upright, there is no line of nodes, and any will do.
void add_gimbals(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const BodyModel& model = scenery.motion.model();
  const Vec3& up = model.up_S;
  Vec3 axle = sample.q_SB * figure_axis_B(scenery.motion.model());
  const Vec3 across = up.cross(axle);
  Vec3 nodes = across.norm() > 1e-9 ? Vec3(across.normalized()) : up.unitOrthogonal();
  if (model.loads.gimbals) {
    const Vec3 angles = scenery.motion.state_at(sample.t).rings.angles;
    const Mat3 axes = turning_axes_P(*model.loads.gimbals, angles);
    nodes = sample.q_SB * (model.R_BP * axes.col(1));
    axle = sample.q_SB * (model.R_BP * axes.col(2));
  }
  const Vec3& pivot = sample.reference_S;
  const double inner = kInnerGimbal * scenery.scale.body;
  const double outer = kOuterGimbal * scenery.scale.body;
  const double thin = kBearingRadius * scenery.scale.body;
  const Material material = plain(scenery.theme.stand, 0.3f);

  const auto add_ring = [&](const Vec3& normal, double radius) {
    const Placement place = disc_placement(pivot, normal, radius);
    glyphs.meshes.push_back({scenery.gimbal, place, material, scenery.rough_gimbal});
    add_rim_reach(place, 16, glyphs);
  };
  add_ring(up.cross(nodes), outer);
  add_ring(axle.cross(nodes), inner);
  glyphs.rods.push_back({pivot - inner * axle, pivot + inner * axle, thin, material});
  for (const double side : {-1.0, 1.0}) {
    glyphs.rods.push_back(
        {pivot + side * inner * nodes, pivot + side * outer * nodes, thin, material});
  }
  add_stand_under(scenery, pivot - outer * up, glyphs);
}

// a disc that fades outwards, a dial on it, and the shadow of the body and its stand
void add_floor(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  if (scenery.motion.model().table) {
    add_table(scenery, sample, glyphs);
    return;
  }
  const Vec3& up = scenery.motion.model().up_S;
  const bool on_pivot = scenery.motion.model().on_pivot;
  const Vec3 center = scenery.motion.at(0.0).reference_S - floor_depth(scenery) * up;
  const double radius = floor_radius(scenery);
  const double of_dial = (on_pivot ? kDialRadius : kFreeDialRadius) * scenery.scale.body;
  glyphs.floors.push_back(floor_at(scenery, center, up, radius, of_dial));
  const double framed = on_pivot ? kFramedFloor : kFramedFreeFloor;
  add_rim_reach(disc_placement(center, up, framed * radius), 16, glyphs);
}

}  // namespace polhode
