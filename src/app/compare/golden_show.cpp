// SPDX-License-Identifier: MIT
#include "app/compare/golden_show.h"

#include "app/compare/golden_results.h"
#include "base/json.h"

namespace polhode {
namespace {

Json thresholds_json(const GoldenVerdict& verdict) {
  const Thresholds& t = verdict.thresholds;
  Json json = {{"max", t.max}, {"fraction", t.fraction}, {"limit", t.limit}};
  if (t.ssim) json["ssim"] = *t.ssim;
  if (t.flip) json["flip"] = *t.flip;
  json["reason"] = verdict.reason;
  return json;
}

std::string thresholds_words(const GoldenVerdict& verdict) {
  const Thresholds& t = verdict.thresholds;
  std::string text = fmt::format("max {}, fraction {}, limit {}", t.max, t.fraction, t.limit);
  if (t.ssim) text += fmt::format(", ssim {}", *t.ssim);
  if (t.flip) text += fmt::format(", flip {}", *t.flip);
  return verdict.reason.empty() ? text : fmt::format("{}: {}", text, verdict.reason);
}

std::string description(const LoadedCase& one) {
  const GoldenCase& spec = one.spec;
  std::string text = fmt::format("{}: {} at {} s, {}x{}{}{}\n",
                                 spec.name,
                                 spec.scene,
                                 spec.still,
                                 spec.size.width,
                                 spec.size.height,
                                 spec.text ? ", with text" : "",
                                 spec.transparent ? ", transparent" : "");
  if (!spec.guards.empty()) text += fmt::format("  guards      {}\n", spec.guards);
  text += fmt::format("  thresholds  {}\n", thresholds_words(one.verdict));
  if (one.references.empty()) text += "  reference   none\n";
  for (const Reference& reference : one.references) {
    const GoldenSidecar& s = reference.sidecar;
    const std::string name = reference.file.filename().string();
    if (!reference.has_sidecar) {
      text += fmt::format("  reference   {}: no sidecar\n", name);
      continue;
    }
    text += fmt::format("  reference   {}: {} on {}, {} samples, {}\n",
                        name,
                        s.renderer,
                        s.cpu_vendor,
                        s.samples,
                        s.opengl);
    if (!same_rule(s.verdict, one.verdict))
      text += fmt::format("    compared by {}\n", thresholds_words(s.verdict));
  }
  return text;
}

Json description_json(const LoadedCase& one) {
  Json references = Json::array();
  for (const Reference& reference : one.references) {
    const GoldenSidecar& s = reference.sidecar;
    Json row = {{"file", reference.file.filename().string()}, {"cause", reference.cause}};
    if (reference.has_sidecar) {
      row.update({{"polhode", s.polhode},
                  {"backend", s.backend},
                  {"renderer", s.renderer},
                  {"opengl", s.opengl},
                  {"llvm", s.llvm},
                  {"cpu_vendor", s.cpu_vendor},
                  {"samples", s.samples},
                  {"thresholds", thresholds_json(s.verdict)}});
    }
    references.push_back(std::move(row));
  }
  const GoldenCase& spec = one.spec;
  return {{"name", spec.name},
          {"scene", spec.scene},
          {"guards", spec.guards},
          {"still_s", spec.still},
          {"width", spec.size.width},
          {"height", spec.size.height},
          {"text", spec.text},
          {"transparent", spec.transparent},
          {"thresholds", thresholds_json(one.verdict)},
          {"references", std::move(references)}};
}

}  // namespace

GoldenResult golden_show(const GoldenJob& job) {
  const std::vector<LoadedCase> cases = load_cases(job.folder, job.cases);
  Json json = {{"folder", job.folder}, {"cases", Json::array()}};
  std::string text;
  for (const LoadedCase& one : cases) {
    text += description(one);
    json["cases"].push_back(description_json(one));
  }
  return {0, job.json ? json_text(json) : text};
}

}  // namespace polhode
