// SPDX-License-Identifier: MIT
// Loaded before all other libraries (LD_PRELOAD), makes one function of theirs fail as it would on
// a machine that lacks something. POLHODE_LACKS names it; see `lacks` below.
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <pthread.h>
#include <stdexcept>
#include <string_view>

#include <sys/mman.h>

namespace {

bool lacks(std::string_view what) {
  const char* named = std::getenv("POLHODE_LACKS");
  return named != nullptr && what == named;
}

// the function that stands behind the one of this name here
template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

struct AVCodec;
struct _cairo;

// an FFmpeg that was built without any encoder
const AVCodec* avcodec_find_encoder_by_name(const char* name) {
  if (lacks("encoders")) return nullptr;
  return next<const AVCodec*(const char*)>(__func__)(name);
}

// no memory for the chapters of a film
int av_dynarray_add_nofree(void* array, int* count, void* element) {
  if (lacks("chapters")) return -ENOMEM;
  return next<int(void*, int*, void*)>(__func__)(array, count, element);
}

// an exception that nobody expected, or an end, in the first call of FFmpeg
void av_log_set_callback(void (*callback)(void*, int, const char*, va_list)) {
  if (lacks("patience")) std::exit(0);
  if (lacks("reason")) throw std::runtime_error("no reason");
  next<void(decltype(callback))>(__func__)(callback);
}

// no memory for a text (CAIRO_STATUS_NO_MEMORY)
int cairo_status(_cairo* context) {
  if (lacks("cairo")) return 1;
  return next<int(_cairo*)>(__func__)(context);
}

int pthread_create(pthread_t* thread,
                   const pthread_attr_t* attributes,
                   void* (*run)(void*),
                   void* of) {
  if (lacks("threads")) return EAGAIN;
  return next<int(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*)>("pthread_create")(
      thread, attributes, run, of);
}

// memory that drawing processes share
void* mmap(void* at, size_t bytes, int protection, int flags, int file, off_t offset) noexcept {
  if (lacks("shared_memory") && flags == (MAP_SHARED | MAP_ANONYMOUS)) {
    errno = ENOMEM;
    return MAP_FAILED;
  }
  return next<void*(void*, size_t, int, int, int, off_t)>("mmap")(
      at, bytes, protection, flags, file, offset);
}

// the POLHODE_LACKS_AT-th piece of memory that a library takes
int posix_memalign(void** memory, std::size_t alignment, std::size_t bytes) noexcept {
  static std::atomic<int> taken = 0;
  static const bool is_meant = lacks("memory");
  static const int at = is_meant ? std::atoi(std::getenv("POLHODE_LACKS_AT")) : 0;
  if (is_meant && taken++ == at) return ENOMEM;
  return next<int(void**, std::size_t, std::size_t)>("posix_memalign")(memory, alignment, bytes);
}

// room on the disk
int posix_fallocate(int file, off_t from, off_t bytes) {
  if (lacks("room")) return ENOSPC;
  return next<int(int, off_t, off_t)>("posix_fallocate")(file, from, bytes);
}

// captions stay
int remove(const char* name) noexcept {
  if (lacks("removal") && std::string_view(name).ends_with(".vtt")) {
    errno = EPERM;
    return -1;
  }
  return next<int(const char*)>("remove")(name);
}

}  // extern "C"
