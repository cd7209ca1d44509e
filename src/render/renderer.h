// SPDX-License-Identifier: MIT
// Draws a Picture into an Image.
#pragma once

#include <memory>
#include <string>

#include "base/system/stage_clock.h"
#include "frame/draw_list.h"
#include "image/image.h"
#include "render/context.h"

namespace polhode {

// What draws, for reports.
struct RendererInfo {
  std::string backend;      // "osmesa"
  std::string gl_renderer;  // as OpenGL names it
  std::string gl_version;
  int samples = 0;           // per pixel
  bool by_outlines = false;  // edges are smoothed by their geometry
};

struct RenderTimes {
  StageTime draw;       // until the samples are in the framebuffer
  StageTime read_back;  // resolving samples and copying pixels
  StageTime smooth;     // mixing across outlines
};

// How edges become smooth. Outlines (render/outlines.h) cost less than half of four samples and are
// nearer to the truth where things are several pixels wide, in pictures from kOutlinePixels on;
// samples serve the smaller ones.
enum class Edges { by_size, samples, outlines };
inline constexpr int kOutlinePixels = 960 * 540;

struct RenderSettings {
  int width = 1920;          // pixels
  int height = 1080;         // pixels
  int samples = 4;           // wanted per pixel; fewer where the driver has fewer
  bool transparent = false;  // the background has alpha 0
  Edges edges = Edges::by_size;
};

// Owns a context's objects; used on the thread that opened the context, which must outlive it.
class Renderer {
 public:
  // Throws Error (environment) when OpenGL cannot do what is needed, (input) for a picture larger
  // than it can draw.
  Renderer(const Context& context, const RenderSettings& settings);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  // Draws into `image`, which gets the right size. The same picture gives the same pixels.
  void draw(const Picture& picture, Image& image);
  // A picture of one panel.
  void draw(const DrawList& list, Image& image);

  const RendererInfo& info() const;
  const RenderTimes& times() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace polhode
