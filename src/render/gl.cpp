// SPDX-License-Identifier: MIT
#include "render/gl.h"

#include "base/error.h"

namespace polhode {
namespace {

template <class Function>
void load(Function& function, const Context& context, const char* name) {
  function = reinterpret_cast<Function>(context.function(name));
  if (function == nullptr) throw environment_error("this OpenGL lacks {}", name);
}

}  // namespace

Gl::Gl(const Context& context) {
#define POLHODE_GL_LOAD(type, name) load(name, context, "gl" #name);
  POLHODE_GL_FUNCTIONS(POLHODE_GL_LOAD)
#undef POLHODE_GL_LOAD
}

}  // namespace polhode
