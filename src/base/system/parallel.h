// SPDX-License-Identifier: MIT
// A parallel loop over independent pieces of work.
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace polhode {

// Calls work(i) once for each i in [0, count), in no particular order, on at most `jobs` threads
// (0: one per processor; fewer where the system gives no more), of which the calling thread is one,
// and returns when all calls have ended. `work` must be thread-safe. After the first exception no
// further call is started, and the exception is rethrown here, on the calling thread.
template <class Work>
void parallel_for(long count, int jobs, const Work& work) {
  const long processors = std::max(1L, static_cast<long>(std::thread::hardware_concurrency()));
  const long threads = std::min(count, jobs > 0 ? jobs : processors);
  std::atomic<long> next = 0;
  std::atomic<bool> failed = false;
  std::exception_ptr error;
  std::mutex error_lock;
  const auto take_pieces = [&] {
    for (long i = next++; i < count && !failed; i = next++) {
      try {
        work(i);
      } catch (...) {
        const std::lock_guard lock(error_lock);
        if (!error) error = std::current_exception();
        failed = true;
      }
    }
  };
#if defined(__wasm__)
  take_pieces();  // pages have one thread
#else
  {
    std::vector<std::jthread> crew;
    try {
      for (long i = 1; i < threads; ++i)
        crew.emplace_back(take_pieces);
    } catch (const std::system_error&) {
      // those there are do the work
    }
    take_pieces();
  }
#endif
  if (error) std::rethrow_exception(error);
}

}  // namespace polhode
