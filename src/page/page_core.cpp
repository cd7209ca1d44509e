// SPDX-License-Identifier: MIT
// What WebAssembly shows to a page: a place for a request, and its answer (export/recomputed.h).
// Only Emscripten compiles this (src/page/CMakeLists.txt); html/pages/turn_core.js calls it.
#include <cstddef>
#include <string>

#include <emscripten/emscripten.h>

#include "base/system/interrupt.h"
#include "export/recomputed.h"

namespace {

std::string request_text, answer_bytes;

}  // namespace

// a page ends what it no longer waits for
void polhode::stop_if_interrupted() {}

extern "C" {

// A place for a request of `size` bytes.
EMSCRIPTEN_KEEPALIVE char* polhode_request(std::size_t size) {
  request_text.assign(size, ' ');
  return request_text.data();
}

// Answers what stands there; returns the length of the answer, bytes.
EMSCRIPTEN_KEEPALIVE std::size_t polhode_answer() {
  answer_bytes = polhode::recomputed(request_text);
  return answer_bytes.size();
}

// The last answer, until the next one.
EMSCRIPTEN_KEEPALIVE const char* polhode_answer_bytes() {
  return answer_bytes.data();
}
}
