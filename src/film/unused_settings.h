// SPDX-License-Identifier: MIT
// Settings of a scene that its film has no use for.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "frame/compose.h"
#include "scene/scene.h"

namespace polhode {

// What the scene file or an option sets, but nothing that the film shows depends on, such as the
// number of ghosts of a film without them; each as an Error (input) with its key, which is not
// thrown. composers: of the panels that show the scene; views: those of all panels of the film.
std::vector<Error> unused_settings(const Scene& scene,
                                   const std::vector<std::shared_ptr<const Composer>>& composers,
                                   const std::vector<std::string>& views);

// Those that the motion until `end` (s) has no use for, whatever is shown; unused_settings() has
// them too.
std::vector<Error> unused_in_motion(const Scene& scene, double end);
// Logs them as warnings, with their places; for commands without a film.
void warn_of_unused_in_motion(const Scene& scene);

}  // namespace polhode
