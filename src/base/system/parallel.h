// SPDX-License-Identifier: MIT
// Independent pieces of work on all processors.
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace polhode {

// Calls work(i) for i in [0, count), each once, on `jobs` threads (0: as many as processors), in no
// order. The first exception stops the rest and is thrown again here. `work` is shared by threads.
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
  {
    std::vector<std::jthread> crew;
    for (long i = 1; i < threads; ++i)
      crew.emplace_back(take_pieces);
    take_pieces();
  }
  if (error) std::rethrow_exception(error);
}

}  // namespace polhode
