// SPDX-License-Identifier: MIT
// Each call is a fiber: a stack of its own, left in the middle of a step and taken up again there.
#include "motion/convoy.h"

#include "base/system/parallel.h"

// the sanitizers do not know which stack is in use, and WebAssembly has one: there calls follow one
// another
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || defined(__wasm__)

namespace polhode {

void parallel_in_convoys(long count, int jobs, const std::function<void(long)>& work) {
  parallel_for(count, jobs, work);
}
#if !defined(__wasm__)
bool step_in_convoy(StepMany, void*) {
  return false;
}
#endif
bool in_convoy() {
  return false;
}

}  // namespace polhode

#else

#include <algorithm>
#include <array>
#include <atomic>
#include <exception>
#include <utility>

#include <boost/context/fiber.hpp>
#include <boost/context/protected_fixedsize_stack.hpp>

namespace polhode {
namespace {

constexpr std::size_t kStack = 524288;  // bytes of each fiber

// The fibers of one thread.
class Convoy {
 public:
  // next() gives the index of a call that nobody has made yet, or -1
  template <class Next>
  Convoy(const Next& next, const std::function<void(long)>& work) {
    for (Member& member : members_) {
      member.fiber = Fiber(std::allocator_arg,
                           boost::context::protected_fixedsize_stack(kStack),
                           [this, &member, &next, &work](Fiber&& back) {
                             member.back = std::move(back);
                             try {
                               for (long i = next(); i >= 0; i = next())
                                 work(i);
                             } catch (...) {
                               if (!error_) error_ = std::current_exception();
                             }
                             --moving_;
                             return std::move(member.back);
                           });
    }
  }

  void run() {
    moving_ = kLanes;
    while (moving_ > 0) {
      // whoever can go on does, until all wait
      for (Member& member : members_) {
        if (!member.fiber || member.part != nullptr) continue;
        here_ = this;
        stepping_ = &member;
        member.fiber = std::move(member.fiber).resume();
        here_ = nullptr;
      }
      step_those_that_wait();
    }
    if (error_) std::rethrow_exception(error_);
  }

  bool step(StepMany step_many, void* part) {
    if (moving_ < 2) return false;
    Member& member = *stepping_;
    member.step_many = step_many;
    member.part = part;
    member.back = std::move(member.back).resume();
    return !member.is_alone;
  }

  static Convoy* here() { return here_; }

 private:
  using Fiber = boost::context::fiber;
  struct Member {
    Fiber fiber;  // its own, while it does not run
    Fiber back;   // that of run(), while it runs
    StepMany step_many = nullptr;
    void* part = nullptr;   // the step that it waits for
    bool is_alone = false;  // nobody waited for the like: it may take the step itself
  };

  bool waits_for(const Member& member, StepMany step_many) const {
    return member.part != nullptr && member.step_many == step_many;
  }

  // what most wait for: the others wait on, so that sooner or later all want the same
  void step_those_that_wait() {
    StepMany wanted = nullptr;
    long most = 0;
    for (const Member& one : members_) {
      if (one.part == nullptr) continue;
      const long like_it =
          std::count_if(members_.begin(), members_.end(), [&](const Member& other) {
            return waits_for(other, one.step_many);
          });
      if (like_it <= most) continue;
      most = like_it;
      wanted = one.step_many;
    }
    std::array<void*, kLanes> parts = {};
    int count = 0;
    for (Member& member : members_) {
      if (!waits_for(member, wanted)) continue;
      parts[static_cast<std::size_t>(count++)] = std::exchange(member.part, nullptr);
      member.is_alone = most == 1;
    }
    if (count > 1) wanted(parts.data(), count);
  }

  std::array<Member, kLanes> members_;
  Member* stepping_ = nullptr;
  int moving_ = 0;  // fibers that have not ended
  std::exception_ptr error_;
  static thread_local Convoy* here_;
};

thread_local Convoy* Convoy::here_ = nullptr;

}  // namespace

void parallel_in_convoys(long count, int jobs, const std::function<void(long)>& work) {
  const long processors = std::max(1L, static_cast<long>(std::thread::hardware_concurrency()));
  const long threads = std::min(count, jobs > 0 ? jobs : processors);
  std::atomic<long> taken = 0;
  std::atomic<bool> failed = false;
  const auto next = [&]() -> long {
    const long i = failed ? count : taken++;
    return i < count ? i : -1;
  };
  parallel_for(threads, static_cast<int>(threads), [&](long) {
    const auto noted = [&](long i) {
      try {
        work(i);
      } catch (...) {
        failed = true;
        throw;
      }
    };
    Convoy(next, noted).run();
  });
}

bool step_in_convoy(StepMany step_many, void* part) {
  Convoy* convoy = Convoy::here();
  return convoy != nullptr && convoy->step(step_many, part);
}

bool in_convoy() {
  return Convoy::here() != nullptr;
}

}  // namespace polhode

#endif
