// SPDX-License-Identifier: MIT
// Opens a shared library at run time (dlopen), so that the program also starts where it is missing.
#pragma once

#include <dlfcn.h>
#include <string>
#include <vector>

#include "base/error.h"

namespace polhode {

// Invariant: the library is open and stays mapped until the process ends.
class SharedLibrary {
 public:
  // Opens the first of `names` that can be loaded; a name without a slash is searched as the loader
  // does. Throws Error (environment), with the loader's message about the first name, if none can
  // be. At least one name.
  explicit SharedLibrary(const std::vector<std::string>& names) {
    std::string reason;
    for (const std::string& name : names) {
      handle_ = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
      if (handle_ != nullptr) return;
      if (reason.empty()) reason = dlerror();
    }
    throw environment_error("{}", reason);
  }
  // Does not unload the library: Mesa keeps threads and thread-local data.
  ~SharedLibrary() = default;
  SharedLibrary(const SharedLibrary&) = delete;
  SharedLibrary& operator=(const SharedLibrary&) = delete;

  // The function `name`, valid until the process ends. `Function` is its type as declared in the
  // library's header; it is not checked. Throws Error (environment) if the library has no such
  // function.
  template <class Function>
  Function* function(const char* name) const {
    void* address = dlsym(handle_, name);
    if (address == nullptr) throw environment_error("the library has no function {}", name);
    return reinterpret_cast<Function*>(address);
  }

 private:
  void* handle_ = nullptr;
};

}  // namespace polhode
