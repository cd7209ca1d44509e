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
  // Opens the first of `names` (at least one) that can be loaded. A name without a slash, such as
  // "libEGL.so.1", is looked for in the system's library folders. Throws Error (environment), with
  // the loader's message about the first name, if none can be loaded.
  explicit SharedLibrary(const std::vector<std::string>& names) {
    std::string reason;
    for (const std::string& name : names) {
      handle_ = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
      if (handle_ != nullptr) return;
      if (reason.empty()) reason = dlerror();
    }
    throw environment_error("{}", reason);
  }
  // Does not unload the library, because Mesa's threads and thread-local data still need its code
  // when the process ends.
  ~SharedLibrary() = default;
  SharedLibrary(const SharedLibrary&) = delete;
  SharedLibrary& operator=(const SharedLibrary&) = delete;

  // The function `name`, valid until the process ends. `Function` is its type as declared in
  // the library's header; it is not checked. Throws Error (environment) if the library has no
  // such function.
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
