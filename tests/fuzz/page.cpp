// SPDX-License-Identifier: MIT
// What a page asks the program for when a slider moves: scenes that are quickly computed, with
// settings and other keys of the request from the bytes.
#include <array>
#include <string_view>

#include "base/json.h"
#include "export/recomputed.h"
#include "fuzz/harness.h"

namespace polhode {
namespace {

constexpr std::array<const char*, 3> kScenes = {
    "[body]\nmoments = [1, 1, 2]\n[motion]\nduration = 0.2\nspin = { body = [1, 0, 3] }\n",
    "[body]\nsolid = { kind = \"sphere\", radius = 0.03, mass = 0.1 }\n[motion]\nhold = \"table\"\n"
    "duration = 0.2\nvelocity = [0.3, 0, 0]\nspin = { body = [1, 0, 3] }\n"
    "friction = { mu = 0.2, restitution = 0.5 }\n",
    "[body]\nsolid = { kind = \"cone\", radius = 0.03, height = 0.05, mass = 0.1 }\n[motion]\n"
    "hold = \"pivot\"\nduration = 0.2\nattitude = { tilt = 0.3 }\nspin = { body = [0, 0, 90] }\n"};

void look_at(const std::string& answer) {
  promise(answer.size() >= 4, "an answer has a length");
  std::size_t length = 0;
  for (std::size_t i = 0; i < 4; ++i)
    length |= static_cast<std::size_t>(static_cast<unsigned char>(answer[i])) << (8 * i);
  promise(length <= answer.size() - 4, "the length is within the answer");
  const Json about = Json::parse(answer.substr(4, length));
  promise(about.contains("error") != about.contains("viewer"), "a viewer or an error");
  const std::string_view glb = std::string_view(answer).substr(4 + length);
  promise(about.contains("error") ? glb.empty() : glb.starts_with("glTF"), "a model");
}

}  // namespace

// a byte that names the scene, then JSON with the other keys of the request; any other text is the
// request itself
void run_harness(const std::string& bytes) {
  Json request =
      Json::parse(bytes.empty() ? bytes : bytes.substr(1), nullptr, /*allow_exceptions=*/false);
  if (!request.is_object()) {
    look_at(recomputed(bytes));
    return;
  }
  request["scene"] = kScenes[static_cast<unsigned char>(bytes[0]) % kScenes.size()];
  request["name"] = "a.toml";
  look_at(recomputed(request.dump(-1, ' ', true, Json::error_handler_t::replace)));
}

}  // namespace polhode
