// SPDX-License-Identifier: MIT
// The TOML files of folders of golden pictures.
#include "base/error.h"
#include "fuzz/harness.h"
#include "scene/golden_file.h"

namespace polhode {

void run_harness(const std::string& bytes) {
  const FileInMemory file(bytes);
  try {
    for (const GoldenCase& one : load_golden_file(file.name()).cases)
      promise(is_plain_name(one.name), "names of cases are plain");
    return;
  } catch (const Error&) {
    // it may be a sidecar
  }
  const std::string text = sidecar_text(load_golden_sidecar(file.name()));
  const FileInMemory again(text);
  promise(sidecar_text(load_golden_sidecar(again.name())) == text,
          "a sidecar that is written and read is the same");
}

}  // namespace polhode
