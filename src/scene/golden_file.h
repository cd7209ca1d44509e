// SPDX-License-Identifier: MIT
// The file formats of a folder of golden pictures: cases.toml, and a sidecar file beside every
// reference.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "image/verdict.h"
#include "video/video_spec.h"

namespace polhode {

// Thresholds and the reason for them; the keys of both are in one table.
struct GoldenVerdict {
  Thresholds thresholds;
  std::string reason;  // for people; empty: not given
};

template <class Visitor>
void fields(Visitor& v, GoldenVerdict& s) {
  fields(v, s.thresholds);
  v.field("reason", s.reason, Doc{"reason for these thresholds"});
}

// A picture that must not change.
struct GoldenCase {
  std::string name;                           // of its reference NAME.png; letters, digits, _ and -
  std::string scene;                          // file, relative to the folder of cases.toml
  std::string guards;                         // what it tests
  double still = 0.0;                         // time of the picture, s of motion
  PictureSize size{320, 180};                 // pixels
  bool text = false;                          // with labels, clock, title and caption
  bool transparent = false;                   // without background
  std::optional<GoldenVerdict> verdict = {};  // absent: the folder's
};

template <class Visitor>
void fields(Visitor& v, GoldenCase& s) {
  v.required("name", s.name, Doc{"name of the case and of its pictures"});
  v.required("scene", s.scene, Doc{"scene file, relative to the folder of this file"});
  v.field("guards", s.guards, Doc{"what the case tests"});
  v.field("still", s.still, Doc{"time of the motion that is drawn", Unit::time, kNonNegative});
  v.field("size", s.size, Doc{"picture size, \"320x180\""});
  v.field(
      "text",
      s.text,
      Doc{"draw labels, clock, title and caption, whose fonts differ a little between machines"});
  v.field("transparent", s.transparent, Doc{"without background"});
  v.field("verdict", s.verdict, Doc{"thresholds of this case instead of those of the folder"});
}

// The content of cases.toml.
struct GoldenFile {
  int format = 1;         // version of this format; only 1 is known
  GoldenVerdict verdict;  // of the cases that have none of their own
  std::vector<GoldenCase> cases;
};

template <class Visitor>
void fields(Visitor& v, GoldenFile& s) {
  v.field("format", s.format, Doc{"version of this format", Unit::none, Range{1, 1}});
  v.field("verdict", s.verdict, Doc{"thresholds of all cases that have none of their own"});
  v.required("case", s.cases, Doc{"the pictures"});
}

// The content of a sidecar: what drew the reference, and how to compare with it.
struct GoldenSidecar {
  int format = 1;          // version of this format; only 1 is known
  std::string cause;       // why there is another reference: "mesa-25"; empty for the first
  std::string polhode;     // version
  std::string backend;     // Context::backend() (render/context.h): "osmesa" or "egl"
  std::string renderer;    // GL_RENDERER
  std::string opengl;      // GL_VERSION, which includes Mesa's version
  std::string llvm;        // version; empty if unknown
  std::string cpu_vendor;  // as in /proc/cpuinfo
  int samples = 0;         // per pixel
  GoldenVerdict verdict;   // for comparisons with this reference
};

template <class Visitor>
void fields(Visitor& v, GoldenSidecar& s) {
  v.field("format", s.format, Doc{"version of this format", Unit::none, Range{1, 1}});
  v.field("cause", s.cause, Doc{"why this reference is accepted in addition to the first"});
  v.field("polhode", s.polhode, Doc{"version of the program that drew it"});
  v.field("backend", s.backend, Doc{"back end of OpenGL that drew it"});
  v.field("renderer", s.renderer, Doc{"renderer, as OpenGL names it (GL_RENDERER)"});
  v.field("opengl", s.opengl, Doc{"version of OpenGL and Mesa (GL_VERSION)"});
  v.field("llvm", s.llvm, Doc{"version of LLVM behind the renderer"});
  v.field("cpu_vendor", s.cpu_vendor, Doc{"vendor of the processor, as in /proc/cpuinfo"});
  v.field("samples", s.samples, Doc{"samples per pixel"});
  v.field("verdict", s.verdict, Doc{"thresholds for comparing with this reference"});
}

// Reads cases.toml. Throws Error (input) as read_file (base/system/atomic_file.h) and parse_toml
// (scene/toml_text.h) do, with file, line and key as Reader (scene/reader.h) does, and with file
// and key for invalid or duplicate names of cases.
GoldenFile load_golden_file(const std::filesystem::path& file);

// Reads a sidecar. Throws Error (input) as read_file and parse_toml do, and with file, line and key
// as Reader does.
GoldenSidecar load_golden_sidecar(const std::filesystem::path& file);

// The text of a sidecar file, which load_golden_sidecar() reads back.
std::string sidecar_text(const GoldenSidecar& sidecar);

// Whether the name consists of letters, digits, _ and - only.
bool is_plain_name(const std::string& name);

}  // namespace polhode
