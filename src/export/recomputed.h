// SPDX-License-Identifier: MIT
// What a page asks for when its reader moves a slider: the scene with other values, solved and
// exported anew. The same program, compiled to WebAssembly (page/page_core.cpp), answers in the
// page.
#pragma once

#include <string>
#include <string_view>

namespace polhode {

// Answers a request, JSON with
//   "scene", "name": the text of the scene file and its name, for messages
//   "settings": list of [key, value], as --set has them
//   "method", "size", "fps", "theme" (text), "step" (s): what replaces values of the scene, as in
//     Overrides (film/overrides.h); null: nothing
//   "from", "to": s of motion
//   "author", "licence": for the notices
// with four bytes, the length of what follows them (least first), JSON, and the bytes of binary
// glTF as `export` writes them, without textures. The JSON has "viewer" (viewer_data() in
// export/viewer_data.h) and "doubts" (list of text), or "error" alone. `name`: that of the scene in
// messages. Throws nothing but std::bad_alloc.
std::string recomputed(std::string_view request);

}  // namespace polhode
