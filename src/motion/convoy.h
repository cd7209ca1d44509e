// SPDX-License-Identifier: MIT
// Motions that step together. Each is computed by a call of its own, as if it were alone: with its
// own steps, tolerance and judgement. But where several calls on a thread want a step of the same
// method, the step is taken for all of them at once, in the lanes of wide registers.
#pragma once

#include <functional>

namespace polhode {

// How many motions step together.
inline constexpr int kLanes = 8;

// As parallel_for (base/system/parallel.h), but on each thread up to kLanes calls take turns: one
// waits in each step_in_convoy() until the others wait too. Whatever `work` computes is the same,
// to the bit, as without others. `work` may not take steps while it handles an exception, may not
// hold a lock while it steps, and has 512 KB of stack.
void parallel_in_convoys(long count, int jobs, const std::function<void(long)>& work);

// Takes one step for each of `count` parts, 2 to kLanes, which are of one type.
using StepMany = void (*)(void* const* parts, int count);

// Takes the step `part` by step_many(), together with those of other motions on this thread. False
// if no other wants one of the kind: then nothing was done, and the caller takes it by itself.
#if defined(__wasm__)
inline bool step_in_convoy(StepMany /*step_many*/, void* /*part*/) {
  return false;  // nothing steps together in pages
}
#else
bool step_in_convoy(StepMany step_many, void* part);
#endif

// Whether the caller is one of the calls of parallel_in_convoys(), so that methods that step
// together cost less than others (false in programs with a sanitizer, where calls follow one
// another).
bool in_convoy();

}  // namespace polhode
