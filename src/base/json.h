// SPDX-License-Identifier: MIT
// JSON whose objects keep the order in which their keys were added.
#pragma once

#include <nlohmann/json.hpp>

namespace polhode {

using Json = nlohmann::ordered_json;

}  // namespace polhode
