// SPDX-License-Identifier: MIT
// Draws a Picture into an Image with OpenGL.
#pragma once

#include <memory>
#include <string>

#include "base/system/stage_clock.h"
#include "frame/draw_list.h"
#include "image/image.h"
#include "render/context.h"

namespace polhode {

// What draws the pictures, for reports.
struct RendererInfo {
  std::string backend;       // Context::backend(): "osmesa" or "egl"
  std::string gl_renderer;   // GL_RENDERER
  std::string gl_version;    // GL_VERSION
  int samples = 0;           // per pixel that are used; 1: none besides the pixel's centre
  bool by_outlines = false;  // edges are antialiased by outlines
};

// Time spent in each stage of drawing.
struct RenderTimes {
  StageTime draw;       // rasterising
  StageTime read_back;  // resolving samples and reading pixels
  StageTime smooth;     // antialiasing outlines
};

// How edges are antialiased. Outlines (render/outlines.h) cost less than half as much as four
// samples, and are more accurate where things are several pixels wide. by_size uses them for
// pictures of at least kOutlinePixels, and samples for smaller ones.
enum class Edges { by_size, samples, outlines };
// The least number of pixels (width * height) for which by_size uses outlines.
inline constexpr int kOutlinePixels = 960 * 540;

// Settings that hold for all pictures of a renderer.
struct RenderSettings {
  int width = 1920;   // pixels
  int height = 1080;  // pixels
  int samples = 4;    // per pixel, where outlines are not used; 0: no multisampling; fewer if
                      // the driver supports fewer
  bool transparent = false;  // the background has alpha 0
  Edges edges = Edges::by_size;
};

// Draws pictures of one size, and owns the OpenGL objects that this needs. Use and destroy it on
// the thread of the context, which must outlive it.
class Renderer {
 public:
  // `context` must be current. Throws Error (environment) if OpenGL lacks a function, (input),
  // without a place, if the picture is larger than OpenGL can draw.
  Renderer(const Context& context, const RenderSettings& settings);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  // Draws into `image`, which is resized if needed and should hold an earlier picture of this
  // renderer or nothing; sets its ground and painted boxes. The picture has at least one panel. Its
  // meshes are kept in GPU memory until a picture does without them. The same picture always gives
  // the same pixels. Throws Error (environment) on an OpenGL error and if a shader does not compile
  // or a framebuffer cannot be made.
  void draw(const Picture& picture, Image& image);
  // The same but for what needs no OpenGL (outlines, alpha, stamps): the picture is whole after the
  // Retouch, which may outlive the renderer; at once if two others still wait for theirs.
  Retouch begin(const Picture& picture, Image& image);
  // Draws a picture with a single panel that covers it. Throws Error likewise.
  void draw(const DrawList& list, Image& image);

  const RendererInfo& info() const;  // a reference to a member
  // Summed over all pictures that are whole so far.
  RenderTimes times() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace polhode
