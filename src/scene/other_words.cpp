// SPDX-License-Identifier: MIT
#include "scene/other_words.h"

#include <fmt/format.h>

namespace polhode {
namespace {

// A word, and what it is here.
struct OtherWord {
  const char *written, *instead;
};
constexpr OtherWord kOtherWords[] = {
    {"friction",
     "motion.friction = { kind = \"coulomb\", mu = ... } of a table, or motion.torque = [{ kind = "
     "\"damping\", c = ... }]"},
    {"damping", "motion.torque = [{ kind = \"damping\", c = ... }]"},
    {"drag", "motion.torque = [{ kind = \"damping\", c = ... }]"},
    {"spring", "motion.torque = [{ kind = \"spring\", k = ... }]"},
    {"force", "motion.torque = [{ kind = \"force\", space = [x, y, z] }]"},
    {"bearing",
     "motion.gimbals.friction, or motion.torque = [{ kind = \"damping\", about = ... }]"},
    {"rings", "motion.gimbals"},
    {"earth_rotation", "motion.frame_rotation"},
    {"rotating_frame", "motion.frame_rotation"},
    {"coriolis", "motion.frame_rotation"},
    {"earth", "motion.frame_rotation = [x, y, z], its angular velocity"},
    {"latitude",
     "motion.frame_rotation = [0, w cos(latitude), w sin(latitude)], with Y to the north"},
    {"gravity", "motion.gravity = [0, 0, -9.80665]"},
    {"precession",
     "motion.spin = { rates = [phi, theta, psi] }, or { steady = \"slow\", axial = ... }"},
    {"nutation", "motion.spin = { rates = [phi, theta, psi] }"},
    {"frequency", "motion.spin = { body_hz = [0, 0, 1] } for one turn a second"},
    {"spread", "motion.ensemble = { tilt_deg = 1, momentum = 0.01 }"},
    {"angle", "motion.attitude = { tilt_deg = 30 }"},
    {"angles", "motion.attitude = { zxz_deg = [phi, theta, psi] }"},
    {"orientation", "motion.attitude"},
    {"rotation", "motion.spin, or motion.attitude"},
    {"omega", "motion.spin = { body = [x, y, z] }"},
    {"angular_velocity", "motion.spin = { body = [x, y, z] }"},
    {"angular_momentum", "motion.spin = { momentum_body = [x, y, z] }"},
    {"hz", "motion.spin = { body_hz = [0, 0, 1] } for one turn a second"},
    {"rpm", "motion.spin = { body_rpm = [0, 0, rpm] }"},
    {"inertia", "body.moments or body.tensor"},
    {"shape", "body.solid = { kind = ... }"},
    {"time", "motion.duration"},
    {"length", "motion.duration"},
    {"speed", "video.time_scale"},
    {"slow_motion", "video.time_scale"},
    {"resolution", "video.size"},
    {"framerate", "video.fps"},
    {"colour", "color of a solid, or video.theme"},
    {"shadow", "show.floor"},
    {"grid", "show.floor"},
};

}  // namespace

std::string instead_of(const std::string& name) {
  for (const OtherWord& word : kOtherWords) {
    if (name == word.written || name.starts_with(std::string(word.written) + "_"))
      return word.instead;
  }
  return "";
}

std::string instead_hint(const std::string& name) {
  const std::string instead = instead_of(name);
  return instead.empty() ? "" : fmt::format(" (here it is {})", instead);
}

}  // namespace polhode
