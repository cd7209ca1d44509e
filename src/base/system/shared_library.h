// SPDX-License-Identifier: MIT
// Opens a shared library at run time.
#pragma once

#include <dlfcn.h>
#include <string>
#include <vector>

#include "base/error.h"

namespace polhode {

// Invariant: the library is open and stays mapped until the process ends.
class SharedLibrary {
 public:
  // Opens the first of `names` that exists. Throws Error (environment) with the loader's message
  // for the first name if there is none.
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

  // The function `name`; `Function` is its type as declared in the library's header. Throws Error
  // (environment) if the library does not have it.
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
