// SPDX-License-Identifier: MIT
// Settings of a scene that its film has no use for.
#pragma once

#include <memory>
#include <vector>

#include "base/error.h"
#include "frame/compose.h"
#include "scene/scene.h"

namespace polhode {

// What the scene file or an option sets, but nothing that the film shows depends on, such as the
// number of ghosts of a film without them; each as an Error (input) with its key, which is not
// thrown. composers: of the panels that show the scene.
std::vector<Error> unused_settings(const Scene& scene,
                                   const std::vector<std::shared_ptr<const Composer>>& composers);

}  // namespace polhode
