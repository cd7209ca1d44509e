// SPDX-License-Identifier: MIT
// A library opened at run time.
#pragma once

#include <dlfcn.h>
#include <string>
#include <vector>

#include "base/error.h"

namespace polhode {

// Invariant: holds an open library until it is destroyed.
class SharedLibrary {
 public:
  // Tries the names in order. Throws Error (environment) with the loader's own words.
  explicit SharedLibrary(const std::vector<std::string>& names) {
    std::string reason;
    for (const std::string& name : names) {
      handle_ = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
      if (handle_ != nullptr) return;
      if (reason.empty()) reason = dlerror();
    }
    throw environment_error("{}", reason);
  }
  // Mesa keeps threads and thread-local data of its own: the library stays mapped.
  ~SharedLibrary() = default;
  SharedLibrary(const SharedLibrary&) = delete;
  SharedLibrary& operator=(const SharedLibrary&) = delete;

  // The function `name`, typed as the header declares it. Throws Error (environment).
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
