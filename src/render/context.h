// SPDX-License-Identifier: MIT
// OpenGL contexts without a window: OSMesa, and EGL on a surfaceless platform. Both are loaded at
// run time, so the program starts where one is missing.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace polhode {

// A current OpenGL 3.3 core context of the calling thread, for the life of the object; one at a
// time in a thread.
class Context {
 public:
  virtual ~Context() = default;
  virtual std::string backend() const = 0;
  // The address of an OpenGL function, or null.
  virtual void* function(const char* name) const = 0;
};

struct Backend {
  std::string name;
  std::string doc;
  // Throws Error (environment) saying what is missing.
  std::unique_ptr<Context> (*open)();
};

// In the order in which "auto" tries them.
const std::vector<Backend>& backends();
// "auto" and the names of all back ends.
std::vector<std::string> backend_names();

// Throws Error (input) for an unknown name, (environment) when no context can be had; with "auto"
// the message tells what each back end said.
std::unique_ptr<Context> open_context(const std::string& backend);

// The makers, for the table.
std::unique_ptr<Context> open_osmesa();
std::unique_ptr<Context> open_egl();

}  // namespace polhode
