// SPDX-License-Identifier: MIT
// OpenGL contexts without a window: OSMesa, and EGL on the surfaceless platform. The libraries are
// loaded at run time, so the program also starts if one is missing.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace polhode {

// An OpenGL 3.3 core context that is current on the thread that made it, as long as the object
// lives. A thread may have one at a time, and must destroy it itself.
class Context {
 public:
  virtual ~Context() = default;
  // Its name in backends(): "osmesa" or "egl".
  virtual std::string backend() const = 0;
  // The address of an OpenGL function; null if the library knows none of that name. Another value
  // does not prove that the driver supports the function. Valid as long as the context.
  virtual void* function(const char* name) const = 0;
};

// A way to get a context. To add one: a row in render/context.cpp and its function.
struct Backend {
  std::string name;  // value of --backend
  std::string doc;   // one phrase, for help
  // Opens it on the calling thread. Throws Error (environment) that says what is missing.
  std::unique_ptr<Context> (*open)();
};

// All back ends, in the order in which "auto" tries them; the table exists until the program ends.
const std::vector<Backend>& backends();
// "auto" and the names of all back ends.
std::vector<std::string> backend_names();

// Takes from the environment what is for those who debug Mesa and would make it stop, or draw
// something else, and keeps EGL silent unless EGL_LOG_LEVEL is set: call it before Backend::open,
// while no other thread uses the environment.
void settle_mesa();

// Opens the named back end, one of backend_names(), on the calling thread. Throws Error (input),
// naming --backend, for an unknown name; (environment) if there is no context, the limit of memory
// (ulimit -v) is below what Mesa needs (1 GiB and more) or LP_NATIVE_VECTOR_WIDTH asks for vectors
// that make Mesa crash. With "auto" the message has the reason of each back end. Calls
// settle_mesa().
std::unique_ptr<Context> open_context(const std::string& backend);

// Open one back end on the calling thread, for the table. Throw Error (environment) that says what
// is missing.
std::unique_ptr<Context> open_osmesa();
std::unique_ptr<Context> open_egl();

}  // namespace polhode
