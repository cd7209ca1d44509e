// SPDX-License-Identifier: MIT
// Arrows: axes, angular velocity, angular momentum, torque, forces, velocities.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "frame/coil.h"
#include "frame/elements.h"
#include "frame/elements/parts.h"
#include "math/so3.h"
#include "text/markup.h"

namespace polhode {
namespace {

constexpr double kBodyAxisLength = 1.2;
constexpr double kFrameLength = 1.55;  // out of the rings of gimbals
constexpr double kBallRadius = 0.05;
constexpr float kHiddenField = 0.4f;  // of the opacity of other hidden vectors: there are many
// of springs, in units of the body's radius
constexpr double kCoilRadius = 0.11;
constexpr double kWireRadius = 0.02;
constexpr double kCoilEnd = 0.2;  // straight

// names of what is shown, as the notes write them
constexpr std::array<const char*, 3> kBodyAxisNames = {
    "<b>ê</b><sub>1</sub>", "<b>ê</b><sub>2</sub>", "<b>ê</b><sub>3</sub>"};
constexpr std::array<const char*, 3> kSpaceAxisNames = {"<i>X</i>", "<i>Y</i>", "<i>Z</i>"};
constexpr std::array kSpaceAxes = {&VectorNames::x, &VectorNames::y, &VectorNames::z};

constexpr std::array<const char*, 3> kComponentNames = {
    "<i>Ω</i><sub>1</sub>", "<i>Ω</i><sub>2</sub>", "<i>Ω</i><sub>3</sub>"};
constexpr const char* kFieldName = "<b>V</b> + <b>Ω</b> × <b>r</b>";
constexpr std::array<const char*, 3> kRateNames = {"<i>φ̇</i>", "<i>θ̇</i>", "<i>ψ̇</i>"};

// what the scene calls a vector, else `usual` (markup)
std::string name_of(const Scenery& scenery,
                    std::optional<std::string> VectorNames::*vector,
                    const char* usual) {
  const std::optional<VectorNames>& names = scenery.options.names;
  if (!names || !((*names).*vector)) return usual;
  const std::string& name = *((*names).*vector);
  return name.empty() ? "" : "<b>" + plain_text(name) + "</b>";
}

// whether the reference point is seen apart from the origin of space
bool is_away(const Scenery& scenery, const Sample& sample) {
  return sample.reference_S.norm() > kBallRadius * scenery.scale.body;
}

// whether the scene leaves the axes at the reference point, which are shown by default
bool has_space_axes(const Scenery& scenery) {
  const auto found = scenery.options.asked.find("space_axes");
  return found == scenery.options.asked.end() || found->second.value_or(true);
}

void add_axes_at(const Scenery& scenery,
                 const Vec3& from,
                 const std::array<double, 3>& lengths,
                 bool named,
                 Glyphs& glyphs) {
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Vec3 along = lengths[k] * scenery.scale.body * Vec3::Unit(i);
    add_vector(scenery,
               from,
               from + along,
               kAxisShape,
               plain(scenery.theme.space_axes, 0.1f),
               glyphs,
               named ? name_of(scenery, kSpaceAxes[k], kSpaceAxisNames[k]) : "");
  }
}

// The name of a position vector beside its middle, on the side to which `aside` points.
void add_name_beside(const Scenery& scenery,
                     const Vec3& from,
                     const Vec3& to,
                     const Vec3& aside,
                     const std::string& name,
                     Glyphs& glyphs) {
  const Vec3 along = (to - from).stableNormalized();
  const Vec3 across = aside.stableNormalized() - along.dot(aside.stableNormalized()) * along;
  if (across.norm() < 0.1) return;
  glyphs.labels.push_back(
      {0.5 * (from + to), 0.05 * scenery.scale.body * across, name, scenery.theme.position});
}

// A spring from `from` on the body to `to` in space (S, m), where a ball holds it, as a coil whose
// turns and thickness are always the same.
void add_spring(const Scenery& scenery, const Vec3& from, const Vec3& to, Glyphs& glyphs) {
  const double size = scenery.scale.body;
  const double length = (to - from).norm() / size;
  const Vec3 axis = length > 0.0 ? Vec3((to - from).stableNormalized()) : Vec3(Vec3::UnitZ());
  // A coil is made anew for each frame, so it has no more pieces than its size needs. They grow
  // with the root of the radius, as on a torus.
  const auto pieces = [&](double radius) {
    return static_cast<int>(std::ceil(scenery.body_segments * std::sqrt(radius)));
  };
  const std::vector<Vec3> line =
      coil_line(length, kCoilRadius, kCoilEnd, std::max(12, pieces(kCoilRadius)));
  Mesh mesh = tube_along(line, kWireRadius, std::max(8, pieces(kWireRadius)), false);

  // what the body hides of it is pale; dashes would break its turns
  Material material = drawn_through(scenery, plain(scenery.theme.force, 0.35f));
  material.dashes = 0.0f;
  glyphs.meshes.push_back(
      {std::make_shared<const Mesh>(std::move(mesh)), disc_placement(from, axis, size), material});
  for (const Vec3& end : {from, to})
    add_rim_reach(disc_placement(end, axis, kCoilRadius * size), 8, glyphs);
  // what holds it
  const Placement held = ball_placement(to, kBallRadius * size);
  glyphs.meshes.push_back({scenery.ball, held, plain(scenery.theme.space_axes, 0.35f)});
}

}  // namespace

void add_body_axes(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  for (int i = 0; i < 3; ++i) {
    const Vec3 along = kBodyAxisLength * scenery.scale.body * (sample.q_SB * Vec3::Unit(i));
    add_at_reference(scenery,
                     sample,
                     along,
                     kAxisShape,
                     plain(scenery.theme.body_axes, 0.2f),
                     glyphs,
                     kBodyAxisNames[static_cast<std::size_t>(i)]);
  }
}

void add_space_axes(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  add_axes_at(scenery, sample.reference_S, scenery.axis_lengths, true, glyphs);
}

void add_fixed_frame(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  constexpr std::array<double, 3> kUsual = {kSpaceAxisLength, kSpaceAxisLength, kSpaceAxisLength};
  // where the axes of the body's place are the same ones, one name is enough for both
  const bool named = is_away(scenery, sample) || !has_space_axes(scenery);
  add_axes_at(scenery, Vec3::Zero(), kUsual, named, glyphs);
  add_position(scenery,
               Vec3::Zero(),
               sample.reference_S,
               kAxisShape,
               plain(scenery.theme.position, 0.2f),
               glyphs);
  // at its tip are the feet of all the others
  if (sample.reference_S.norm() < scenery.scale.body) return;
  // above it, or to the right of one that is upright
  const Vec3& R = sample.reference_S;
  const bool upright = R.head<2>().norm() < 0.2 * R.norm();
  Vec3 aside = upright ? Vec3::UnitY() : Vec3::UnitZ();
  if (!scenery.options.points.empty()) {
    aside = sample.reference_S -
            point_position(scenery.motion.model(), sample, scenery.options.points.front());
  }
  add_name_beside(scenery, Vec3::Zero(), sample.reference_S, aside, "<b>R</b>", glyphs);
}

void add_omega(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  add_vector(scenery,
             sample.reference_S,
             omega_tip(scenery, sample),
             kOmegaShape,
             plain(scenery.theme.omega, 0.25f),
             glyphs,
             name_of(scenery, &VectorNames::omega, "<b>Ω</b>"));
}

void add_momentum(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  add_vector(scenery,
             sample.reference_S,
             momentum_tip(scenery, sample),
             kMomentumShape,
             plain(scenery.theme.momentum, 0.25f),
             glyphs,
             name_of(scenery, &VectorNames::momentum, "<b>L</b>"));
  glyphs.arrows.back().rim = true;  // the angular velocity is often parallel to it
}

// along the body axes; their sum is the angular velocity
void add_omega_components(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  for (int i = 0; i < 3; ++i) {
    const Vec3 along = scenery.scale.omega * sample.w_B[i] * (sample.q_SB * Vec3::Unit(i));
    add_at_reference(scenery,
                     sample,
                     along,
                     kComponentShape,
                     plain(scenery.theme.omega, 0.2f),
                     glyphs,
                     kComponentNames[static_cast<std::size_t>(i)]);
  }
}

// about the vertical, the line of nodes and the third body axis: they too add up to the angular
// velocity (Landau and Lifshitz, Mechanics, section 35). Upright, the line of nodes is any. Each
// has the colour of what it belongs to: the vertical, the angle of the tilt, the body's axis.
void add_euler_rates(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const Vec3 angles = zxz_angles(sample.q_SB);
  if (std::sin(angles.y()) < 1e-3) return;
  const std::array<Vec3, 3> axes_S = {Vec3::UnitZ(),
                                      Vec3(std::cos(angles.x()), std::sin(angles.x()), 0.0),
                                      sample.q_SB * Vec3::UnitZ()};
  // the components along axes that are not square to each other
  Mat3 basis;
  for (int i = 0; i < 3; ++i)
    basis.col(i) = axes_S[static_cast<std::size_t>(i)];
  const Vec3 rates = basis.inverse() * sample.w_S;
  const std::array<glm::vec3, 3> colors = {
      scenery.theme.space_axes, scenery.theme.position, scenery.theme.body_axes};
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    add_at_reference(scenery,
                     sample,
                     scenery.scale.omega * rates[i] * axes_S[k],
                     kComponentShape,
                     plain(colors[k], 0.2f),
                     glyphs,
                     kRateNames[k]);
  }
}

// what changes L, about the reference point; with two heads, as engineers draw moments: the weight
// has the same colour
void add_torque(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const std::optional<Vec3> torque_S = torque_at(scenery.motion, sample.t);
  if (!torque_S) return;
  const std::size_t before = glyphs.arrows.size();
  add_at_reference(scenery,
                   sample,
                   scenery.scale.torque * *torque_S,
                   kForceShape,
                   plain(scenery.theme.force, 0.25f),
                   glyphs,
                   name_of(scenery, &VectorNames::torque, "<b>τ</b>"));
  if (glyphs.arrows.size() == before) return;
  const ArrowGlyph& arrow = glyphs.arrows.back();
  const Vec3 along = arrow.tip - arrow.from;
  const double head = fitting(arrow.shape, along.norm()).head_length;
  if (along.norm() < 3.0 * head) return;
  // its neck is where the first head begins
  const Vec3 back = along.normalized() * head;
  ArrowGlyph second = arrow;
  second.tip = arrow.tip - 0.75 * back;
  second.from = second.tip - 1.5 * back;
  glyphs.arrows.push_back(second);
}

// m g on the centre of mass, downwards or to where the Earth is
void add_gravity(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const Load* orbit = gradient_of(scenery);
  const Vec3 up =
      orbit != nullptr ? away_from_earth(*orbit, sample.t) : scenery.motion.model().up_S;
  const Vec3 down = -scenery.scale.weight * up;
  add_vector(scenery,
             sample.center_S,
             sample.center_S + down,
             kForceShape,
             plain(scenery.theme.force, 0.25f),
             glyphs,
             name_of(scenery, &VectorNames::gravity, "<i>m</i><b>g</b>"));
}

// the axis about which space turns; its length says nothing, since it would hardly ever be seen
void add_frame_rotation(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const Vec3 along = *frame_rotation_of(scenery.motion.model());
  add_at_reference(scenery,
                   sample,
                   kFrameLength * scenery.scale.body * along.normalized(),
                   kAxisShape,
                   plain(scenery.theme.position, 0.25f),
                   glyphs,
                   name_of(scenery, &VectorNames::frame_rotation, "<b>Ω</b><sub>0</sub>"));
}

namespace {

// the point of the velocity field that is fastest at the start; in models it has the name of all
std::size_t fastest_in_field(const Scenery& scenery) {
  const Sample start = scenery.motion.at(0.0);
  const auto speed = [&](const Vec3& point_B) {
    return point_velocity(scenery.motion.model(), start, point_B).norm();
  };
  const std::vector<Vec3>& points = scenery.field_points_B;
  const auto fastest =
      std::max_element(points.begin(), points.end(), [&](const Vec3& a, const Vec3& b) {
        return speed(a) < speed(b);
      });
  return static_cast<std::size_t>(fastest - points.begin());
}

}  // namespace

// V + Omega x r (notes, section 0.1) at points of the body, and V at the reference point. All have
// one name, beside their tips.
void add_velocity_field(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const BodyModel& model = scenery.motion.model();
  const Material material = plain(scenery.theme.velocity, 0.2f);
  std::vector<Vec3> tips;
  for (const Vec3& point_B : scenery.field_points_B) {
    const Vec3 from = point_position(model, sample, point_B);
    tips.push_back(from + scenery.scale.velocity * point_velocity(model, sample, point_B));
    add_vector(scenery, from, tips.back(), kFieldShape, material, glyphs, "");
    glyphs.arrows.back().material.hidden *= kHiddenField;
  }
  if (!tips.empty()) {
    const Vec3 tip = tips[fastest_in_field(scenery)];
    add_name(
        scenery, tip, tip - sample.reference_S, kFieldName, scenery.theme.velocity, 1.0f, glyphs);
    glyphs.labels.back().size = 1.0;  // as of other vectors
    glyphs.labels.back().curve = std::move(tips);
  }
  const Vec3 along = scenery.scale.velocity * sample.reference_velocity_S;
  if (along.norm() > 0.0)
    add_at_reference(scenery, sample, along, kOmegaShape, material, glyphs, "<b>V</b>");
}

// forces at the points where they act; springs as coils to where they are held
void add_forces(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const BodyModel& model = scenery.motion.model();
  const Quat q_SP = sample.q_SB * Quat(model.R_BP);
  const Material material = plain(scenery.theme.force, 0.25f);
  for (const Load& load : model.loads.listed) {
    const Vec3 at = sample.reference_S + q_SP * load.at_P;
    const Vec3 force = scenery.scale.force * point_force(load, sample.t, q_SP, sample.reference_S);
    if (load.kind == Load::Kind::spring) {
      add_spring(scenery, at, load.anchor_S, glyphs);
    } else if (force.squaredNorm() > 0.0) {
      add_vector(scenery, at, at + force, kForceShape, material, glyphs, "<b>F</b>");
    }
    if (load.kind == Load::Kind::couple) {
      const Vec3 opposite = at - q_SP * load.arm_P;
      add_vector(scenery, opposite, opposite - force, kForceShape, material, glyphs, "<b>−F</b>");
    }
  }
}

void add_points(const Scenery& scenery, const Sample& sample, bool from_origin, Glyphs& glyphs) {
  const Material material = plain(scenery.theme.position, 0.3f);
  const std::vector<Vec3>& points = scenery.options.points;
  for (std::size_t k = 0; k < points.size(); ++k) {
    // several are numbered as the scene lists them
    const std::string number =
        points.size() > 1 ? "<sub>" + std::to_string(k + 1) + "</sub>" : std::string();
    const Vec3 at = point_position(scenery.motion.model(), sample, points[k]);
    const Placement place = ball_placement(at, kBallRadius * scenery.scale.body);
    glyphs.meshes.push_back({scenery.ball, place, material});
    glyphs.marks.push_back({at, kBallRadius * scenery.scale.body});
    for (int i = 0; i < 3; ++i) {
      glyphs.reach.push_back(place * Vec3::Unit(i));
      glyphs.reach.push_back(place * Vec3(-Vec3::Unit(i)));
    }
    if (!from_origin || !is_away(scenery, sample)) {
      add_position(
          scenery, sample.reference_S, at, kAxisShape, material, glyphs, "<b>r</b>" + number);
      continue;
    }
    add_position(scenery, sample.reference_S, at, kAxisShape, material, glyphs);
    add_name_beside(
        scenery, sample.reference_S, at, sample.reference_S, "<b>r̃</b>" + number, glyphs);
    add_position(scenery, Vec3::Zero(), at, kAxisShape, material, glyphs);
    add_name_beside(
        scenery, Vec3::Zero(), at, at - sample.reference_S, "<b>r</b>" + number, glyphs);
  }
}

}  // namespace polhode
