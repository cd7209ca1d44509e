// SPDX-License-Identifier: MIT
#include "model/friction.h"

#include <fmt/format.h>

#include "base/error.h"

namespace polhode {

Friction make_friction(const FrictionSpec& spec) {
  const auto refuse = [&](const char* key, const char* kind) {
    throw input_error("is for kind = \"{}\", and this is \"{}\"", kind, spec.kind)
        .at({{}, 0, fmt::format("motion.friction.{}", key)});
  };
  const auto need = [&](const char* key) {
    throw input_error("kind = \"{}\" needs {}", spec.kind, key).at({{}, 0, "motion.friction"});
  };
  Friction law;
  if (spec.kind == "rolling") law.kind = Friction::Kind::rolling;
  if (spec.kind == "viscous") law.kind = Friction::Kind::viscous;
  if (spec.kind == "coulomb") law.kind = Friction::Kind::coulomb;
  if (spec.mu && law.kind != Friction::Kind::coulomb) refuse("mu", "coulomb");
  if (spec.c && law.kind != Friction::Kind::viscous) refuse("c", "viscous");
  if (!spec.mu && law.kind == Friction::Kind::coulomb) need("mu");
  if (!spec.c && law.kind == Friction::Kind::viscous) need("c");
  if (law.kind == Friction::Kind::none) {
    const auto refuse_on_ice = [](const std::optional<double>& value, const char* key) {
      if (!value) return;
      throw input_error("is for a table with friction; kind = \"none\" has none")
          .at({{}, 0, fmt::format("motion.friction.{}", key)});
    };
    refuse_on_ice(spec.rolling, "rolling");
    refuse_on_ice(spec.boring, "boring");
    refuse_on_ice(spec.turntable, "turntable");
  }
  law.mu = spec.mu.value_or(0.0);
  law.c = spec.c.value_or(0.0);
  law.rolling = spec.rolling.value_or(0.0);
  law.boring = spec.boring.value_or(0.0);
  law.restitution = spec.restitution.value_or(0.0);
  law.turntable = spec.turntable.value_or(0.0);
  return law;
}

}  // namespace polhode
