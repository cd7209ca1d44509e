// SPDX-License-Identifier: MIT
// Mesa's cache of compiled shaders, which saves a second in every run.
#pragma once

namespace polhode {

// Has Mesa do without its cache if the disk of the cache is full: Mesa maps the cache's index, and
// a page of it for which there is no room is a bus error.
void leave_full_shader_cache();

}  // namespace polhode
