// SPDX-License-Identifier: MIT
#include "render/renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <mutex>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include "base/error.h"
#include "render/gl_objects.h"
#include "render/outlines.h"
#include "render/surface.h"

namespace polhode {
namespace {

// in the stencil, where a table is in front; 1 is for thin items
constexpr int kBehindTable = 2;

int integer(const Gl& gl, GLenum name) {
  GLint value = 0;
  gl.GetIntegerv(name, &value);
  return value;
}

const RenderSettings& fitting(const Gl& gl, const RenderSettings& settings) {
  const int most = integer(gl, GL_MAX_RENDERBUFFER_SIZE);
  if (settings.width > most || settings.height > most) {
    throw input_error("a picture of {}x{} is larger than OpenGL can draw here ({} pixels a side)",
                      settings.width,
                      settings.height,
                      most);
  }
  return settings;
}

// the corners of the box around a mesh, in its own coordinates
std::array<glm::vec3, 8> box_corners(const Mesh& mesh) {
  glm::vec3 low(mesh.vertices.front().position);
  glm::vec3 high(low);
  for (const Vertex& vertex : mesh.vertices) {
    low = glm::min(low, vertex.position);
    high = glm::max(high, vertex.position);
  }
  std::array<glm::vec3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners[i] = {(i & 1) != 0 ? high.x : low.x,
                  (i & 2) != 0 ? high.y : low.y,
                  (i & 4) != 0 ? high.z : low.z};
  }
  return corners;
}

// the box around a mesh in the plane z = 0, from its corners
Mesh flat_box(const std::array<glm::vec3, 8>& corners) {
  Mesh mesh;
  for (std::size_t i = 0; i < 4; ++i)
    mesh.vertices.push_back({corners[i], glm::vec3(0.0f, 0.0f, 1.0f)});
  mesh.indices = {0, 1, 3, 0, 3, 2};
  return mesh;
}

// premultiplied colour, as blending leaves it, to the straight alpha of Image
void unpremultiply(Image& image, const PixelBox& box) {
  for (int y = box.y; y < box.bottom(); ++y) {
    std::uint8_t* pixel = image.at(box.x, y);
    for (int x = 0; x < box.width; ++x, pixel += 4) {
      const int alpha = pixel[3];
      if (alpha == 0 || alpha == 255) continue;
      for (int c = 0; c < 3; ++c) {
        const int value = (pixel[c] * 255 + alpha / 2) / alpha;
        pixel[c] = static_cast<std::uint8_t>(std::min(value, 255));
      }
    }
  }
}

std::uint8_t byte_of(float part) {
  return static_cast<std::uint8_t>(std::lround(255.0f * glm::clamp(part, 0.0f, 1.0f)));
}

// how many samples: 0 where outlines are smoothed by their geometry
int samples_to_use(const Gl& gl, const RenderSettings& settings) {
  const bool large = settings.width * settings.height >= kOutlinePixels;
  if (settings.edges == Edges::outlines || (settings.edges == Edges::by_size && large)) return 0;
  return std::min(settings.samples, integer(gl, GL_MAX_SAMPLES));
}

}  // namespace

class Renderer::Implementation {
 public:
  Implementation(const Context& context, const RenderSettings& settings)
      : gl_(context),
        settings_(fitting(gl_, settings)),
        samples_(samples_to_use(gl_, settings)),
        surfaces_(gl_) {
    info_.backend = context.backend();
    info_.gl_renderer = reinterpret_cast<const char*>(gl_.GetString(GL_RENDERER));
    info_.gl_version = reinterpret_cast<const char*>(gl_.GetString(GL_VERSION));
    info_.samples = std::max(1, samples_);
    info_.by_outlines = settings.edges != Edges::samples && samples_ == 0;
  }

  Retouch begin(const Picture& picture, Image& image) {
    const bool single = picture.panels.size() == 1;
    if (!single) clear(picture, {}, image);
    const std::shared_ptr<Rest> rest = spare_->take();
    rest->panels.resize(picture.panels.size());
    rest->stamps = picture.stamps;
    for (std::size_t i = 0; i < picture.panels.size(); ++i) {
      const Panel& panel = picture.panels[i];
      DrawnPanel& drawn = rest->panels[i];
      drawn.region = region_of(panel, drawn.smoother);
      if (single) clear(picture, drawn.region.parts, image);
      if (drawn.region.parts.empty()) continue;
      draw_panel(panel, drawn.region.box);
      read_back(drawn, image);
      if (image.ground) {
        image.painted.insert(
            image.painted.end(), drawn.region.parts.begin(), drawn.region.parts.end());
      }
    }
    refuse_errors();
    forget_unused_meshes();
    Retouch finish = [spare = spare_,
                      rest,
                      smooth = info_.by_outlines,
                      transparent = settings_.transparent](Image& drawn) {
      StageTime time;
      retouch(*rest, smooth, transparent, drawn, time);
      spare->give_back(rest, time);
    };
    // depths take as much memory as the picture; who is behind with several has no time for more
    if (spare_->are_many_out()) {
      finish(image);
      return {};
    }
    return finish;
  }

  PixelBox whole() const { return {0, 0, settings_.width, settings_.height}; }
  const RendererInfo& info() const { return info_; }
  RenderTimes times() const {
    RenderTimes times = times_;
    times.smooth += spare_->time();
    return times;
  }

 private:
  // The part of the picture that a panel's items may cover: the box that is drawn, and the boxes of
  // it that are read back. A function of the panel alone.
  struct DrawnRegion {
    PixelBox box;
    std::vector<PixelBox> parts;
  };
  struct DrawnPanel {
    DrawnRegion region;
    OutlineSmoother smoother;
    std::vector<float> depth;  // in the box, where it was read back
  };
  // What a picture needs besides OpenGL.
  struct Rest {
    std::vector<DrawnPanel> panels;
    std::vector<Stamp> stamps;
  };
  // Memory for it, of which pictures that are whole leave some to others; for several threads.
  class Spare {
   public:
    std::shared_ptr<Rest> take() {
      const std::scoped_lock lock(mutex_);
      ++out_;
      if (free_.empty()) return std::make_shared<Rest>();
      std::shared_ptr<Rest> rest = std::move(free_.back());
      free_.pop_back();
      return rest;
    }
    // time: what it took
    void give_back(const std::shared_ptr<Rest>& rest, const StageTime& time) {
      const std::scoped_lock lock(mutex_);
      --out_;
      free_.push_back(rest);
      time_ += time;
    }
    bool are_many_out() const {
      constexpr int kMany = 3;
      const std::scoped_lock lock(mutex_);
      return out_ >= kMany;
    }
    StageTime time() const {
      const std::scoped_lock lock(mutex_);
      return time_;
    }

   private:
    mutable std::mutex mutex_;
    std::vector<std::shared_ptr<Rest>> free_;
    int out_ = 0;  // taken and not given back
    StageTime time_;
  };

  static void retouch(
      Rest& rest, bool by_outlines, bool transparent, Image& image, StageTime& time) {
    for (DrawnPanel& panel : rest.panels) {
      if (by_outlines && !panel.region.parts.empty()) {
        const StageTimer timer(time);
        panel.smoother.smooth(panel.region.box, panel.depth, image);
      }
      if (!transparent) continue;
      for (const PixelBox& part : panel.region.parts)
        unpremultiply(image, part);
    }
    for (const Stamp& stamp : rest.stamps)
      lay_over(image, stamp);
    rest.stamps.clear();
  }

  struct Uploaded {
    MeshPtr keep;  // the address is the key, so the mesh must live
    std::unique_ptr<GpuMesh> gpu;
    std::array<glm::vec3, 8> corners;
    std::unique_ptr<MeshEdges> edges;  // made when outlines are smoothed
    bool used = true;
  };

  std::array<std::uint8_t, 4> ground_of(const Panel& panel) const {
    if (settings_.transparent) return {0, 0, 0, 0};
    const glm::vec3& color = panel.list.background;
    return {byte_of(color.r), byte_of(color.g), byte_of(color.b), 255};
  }

  // the background of all panels; `kept` is drawn anyway
  void clear(const Picture& picture, const std::vector<PixelBox>& kept, Image& image) {
    const StageTimer timer(times_.read_back);
    const std::array<std::uint8_t, 4> ground = ground_of(picture.panels.front());
    image.wipe(settings_.width, settings_.height, ground, kept);
    for (const Panel& panel : picture.panels) {
      if (ground_of(panel) == ground) continue;
      image.fill(panel.place, ground_of(panel));
      image.ground.reset();
    }
  }

  DrawnRegion region_of(const Panel& panel, OutlineSmoother& smoother) {
    if (info_.by_outlines) find_outlines(panel, smoother);
    const std::optional<PixelBox> box = box_of(panel);
    if (!box) return {panel.place, {panel.place}};
    if (box->empty()) return {};
    if (!info_.by_outlines) return {*box, {*box}};
    DrawnRegion region{{}, smoother.covered()};
    for (const PixelBox& part : region.parts)
      region.box = region.box.empty() ? part : around(region.box, part);
    return region;
  }

  // the pixels that boxes around all items cover; nothing when one is behind the eye
  std::optional<PixelBox> box_of(const Panel& panel) {
    const DrawList& list = panel.list;
    const glm::vec2 size(panel.place.width, panel.place.height);
    glm::vec2 low(size);
    glm::vec2 high(0.0f);
    for (const std::vector<DrawItem>* items : {&list.opaque, &list.translucent}) {
      for (const DrawItem& item : *items) {
        const glm::mat4 clip_from_mesh = list.view.clip_from_world * item.world_from_mesh;
        for (const glm::vec3& corner : uploaded(item.mesh).corners) {
          const glm::vec4 clip = clip_from_mesh * glm::vec4(corner, 1.0f);
          if (clip.w <= 0.0f) return std::nullopt;
          const glm::vec2 pixel = (0.5f + glm::vec2(0.5f, -0.5f) * glm::vec2(clip) / clip.w) * size;
          low = glm::min(low, pixel);
          high = glm::max(high, pixel);
        }
      }
    }
    // a pixel more on each side for rounding, another for the neighbours of outlines
    low = glm::floor(glm::clamp(low - 2.0f, glm::vec2(0.0f), size));
    high = glm::ceil(glm::clamp(high + 2.0f, glm::vec2(0.0f), size));
    return PixelBox{panel.place.x + static_cast<int>(low.x),
                    panel.place.y + static_cast<int>(low.y),
                    static_cast<int>(high.x - low.x),
                    static_cast<int>(high.y - low.y)};
  }

  void find_outlines(const Panel& panel, OutlineSmoother& smoother) {
    const StageTimer timer(times_.smooth);
    smoother.begin(panel.list.view, panel.place);
    for (const std::vector<DrawItem>* items : {&panel.list.opaque, &panel.list.translucent}) {
      for (const DrawItem& item : *items) {
        Uploaded& mesh = uploaded(item.mesh);
        if (mesh.edges == nullptr) {
          // what is soft has no outlines; it only has to be within what is drawn
          mesh.edges =
              std::make_unique<MeshEdges>(item.material.soft ? flat_box(mesh.corners) : *item.mesh);
        }
        smoother.add(*mesh.edges, item);
      }
    }
  }

  void draw_panel(const Panel& panel, const PixelBox& box) {
    const StageTimer timer(times_.draw);
    const std::vector<DrawItem>& opaque = panel.list.opaque;
    const std::vector<DrawItem>& translucent = panel.list.translucent;
    const bool any_thin = std::any_of(
        opaque.begin(), opaque.end(), [](const DrawItem& item) { return item.material.thin; });
    const bool any_table = std::any_of(translucent.begin(), translucent.end(), is_table);
    if (any_thin || any_table) buffers_ = Buffers::depth_and_stencil;
    begin(panel, box);
    for (const DrawItem& item : opaque) {
      if (item.material.covers && !item.material.thin) draw_item(item);
    }
    draw_hidden(panel.list);
    // what thin items leave as it is has 1 in the stencil
    if (any_thin) {
      gl_.Enable(GL_STENCIL_TEST);
      gl_.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    }
    for (const DrawItem& item : opaque) {
      if (item.material.covers) continue;
      if (any_thin) gl_.StencilFunc(GL_ALWAYS, item.material.hidden > 0.0f ? 1 : 0, 0xff);
      draw_item(item);
    }
    if (any_thin) {
      gl_.StencilFunc(GL_NOTEQUAL, 1, 0xff);
      gl_.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
      for (const DrawItem& item : opaque) {
        if (item.material.thin) draw_item(item);
      }
      gl_.Disable(GL_STENCIL_TEST);
    }

    // translucent shells come back to front and leave the depth of what is behind them
    gl_.Enable(GL_BLEND);
    gl_.DepthMask(GL_FALSE);
    for (const DrawItem& item : translucent)
      draw_item(item);
    gl_.DepthMask(GL_TRUE);
    gl_.Disable(GL_BLEND);
    if (any_table) draw_hidden_by_tables(panel.list);
    gl_.Finish();
  }

  // a floor behind which lines are seen as they are behind bodies
  static bool is_table(const DrawItem& item) { return item.material.covers && item.material.soft; }

  // Where a table is in front of all else, its depth becomes that of the picture. This comes last:
  // what is translucent below a floor is drawn over it.
  void draw_hidden_by_tables(const DrawList& list) {
    gl_.Enable(GL_STENCIL_TEST);
    gl_.StencilFunc(GL_ALWAYS, kBehindTable, 0xff);
    gl_.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    for (const DrawItem& item : list.translucent) {
      if (is_table(item)) draw_item(item);
    }
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.StencilFunc(GL_EQUAL, kBehindTable, 0xff);
    gl_.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    draw_hidden(list);
    gl_.Disable(GL_STENCIL_TEST);
  }

  // over what covers them, before anything else is drawn; by the distance of their feet, so that of
  // several vectors in one line the thickest hides the others
  void draw_hidden(const DrawList& list) {
    std::vector<std::pair<float, const DrawItem*>> hidden;
    for (const std::vector<DrawItem>* items : {&list.opaque, &list.translucent}) {
      for (const DrawItem& item : *items) {
        if (item.material.hidden <= 0.0f) continue;
        const glm::vec3 foot(item.world_from_mesh[3]);
        const float radius = glm::length(glm::vec3(item.world_from_mesh[0]));
        // of a rim only the far side is drawn
        const float nearer = item.faces == Faces::back ? -radius : radius;
        hidden.emplace_back(glm::distance(list.view.eye, foot) - nearer, &item);
      }
    }
    if (hidden.empty()) return;
    std::stable_sort(hidden.begin(), hidden.end(), [](const auto& a, const auto& b) {
      return a.first > b.first;
    });
    gl_.Enable(GL_BLEND);
    gl_.DepthMask(GL_FALSE);
    gl_.DepthFunc(GL_GREATER);
    for (const auto& [distance, item] : hidden)
      draw_item(*item, true);
    gl_.DepthFunc(GL_LESS);
    gl_.DepthMask(GL_TRUE);
    gl_.Disable(GL_BLEND);
  }

  // the box begins at the framebuffer's corner: what lies outside is neither cleared nor copied
  void begin(const Panel& panel, const PixelBox& box) {
    fit(drawn_, box, samples_, buffers_);
    if (samples_ > 0) fit(resolved_, box, 0, Buffers::color);
    const DrawList& list = panel.list;
    gl_.BindFramebuffer(GL_FRAMEBUFFER, drawn_->id());
    gl_.Viewport(
        panel.place.x - box.x, panel.place.y - box.y, panel.place.width, panel.place.height);
    const std::array<std::uint8_t, 4> ground = ground_of(panel);
    gl_.ClearColor(static_cast<float>(ground[0]) / 255.0f,
                   static_cast<float>(ground[1]) / 255.0f,
                   static_cast<float>(ground[2]) / 255.0f,
                   static_cast<float>(ground[3]) / 255.0f);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.Enable(GL_CULL_FACE);
    gl_.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);

    // the picture is drawn upside down, so that rows are read back from top to bottom; that turns
    // every triangle round
    gl_.FrontFace(GL_CW);
    glm::mat4 flip(1.0f);
    flip[1][1] = -1.0f;
    surfaces_.begin(list.view, flip * list.view.clip_from_world);
  }

  // as large as the box: all of a framebuffer is cleared
  void fit(std::unique_ptr<Framebuffer>& buffer,
           const PixelBox& box,
           int samples,
           Buffers buffers) {
    constexpr int kTile = 64;  // pixels, of the rasteriser
    const auto tiles = [](int side) {
      return (side + kTile - 1) / kTile * kTile;
    };
    const int width = std::min(tiles(box.width), settings_.width);
    const int height = std::min(tiles(box.height), settings_.height);
    if (buffer != nullptr && buffer->width() == width && buffer->height() == height &&
        buffer->buffers() == buffers)
      return;
    buffer = std::make_unique<Framebuffer>(gl_, width, height, samples, buffers);
  }

  // hidden: the parts that something covers
  void draw_item(const DrawItem& item, bool hidden = false) {
    surfaces_.use(item.material, item.faces, item.world_from_mesh, hidden);
    if (item.faces == Faces::both) {
      gl_.Disable(GL_CULL_FACE);
    } else {
      gl_.Enable(GL_CULL_FACE);
      gl_.CullFace(item.faces == Faces::front ? GL_BACK : GL_FRONT);
    }
    uploaded(item.mesh).gpu->draw();
  }

  Uploaded& uploaded(const MeshPtr& mesh) {
    Uploaded& entry = meshes_[mesh.get()];
    if (entry.gpu == nullptr) {
      entry.keep = mesh;
      entry.gpu = std::make_unique<GpuMesh>(gl_, *mesh);
      entry.corners = box_corners(*mesh);
    }
    entry.used = true;
    return entry;
  }

  void forget_unused_meshes() {
    for (auto entry = meshes_.begin(); entry != meshes_.end();) {
      if (!std::exchange(entry->second.used, false)) {
        entry = meshes_.erase(entry);
      } else {
        ++entry;
      }
    }
  }

  void read_back(DrawnPanel& panel, Image& image) {
    const StageTimer timer(times_.read_back);
    const DrawnRegion& region = panel.region;
    const PixelBox& box = region.box;
    const Framebuffer* source = drawn_.get();
    if (samples_ > 0) {
      gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, drawn_->id());
      gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_->id());
      gl_.BlitFramebuffer(0,
                          0,
                          box.width,
                          box.height,
                          0,
                          0,
                          box.width,
                          box.height,
                          GL_COLOR_BUFFER_BIT,
                          GL_NEAREST);
      source = resolved_.get();
    }
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, source->id());
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl_.PixelStorei(GL_PACK_ROW_LENGTH, image.width);
    for (const PixelBox& part : region.parts)
      read(part, box, GL_RGBA, GL_UNSIGNED_BYTE, image.at(part.x, part.y));
    if (info_.by_outlines) {
      gl_.PixelStorei(GL_PACK_ROW_LENGTH, box.width);
      panel.depth.resize(static_cast<std::size_t>(box.width) *
                         static_cast<std::size_t>(box.height));
      for (const PixelBox& part : region.parts) {
        const std::size_t first =
            static_cast<std::size_t>(part.y - box.y) * static_cast<std::size_t>(box.width) +
            static_cast<std::size_t>(part.x - box.x);
        read(part, box, GL_DEPTH_COMPONENT, GL_FLOAT, &panel.depth[first]);
      }
    }
    gl_.PixelStorei(GL_PACK_ROW_LENGTH, 0);
  }

  void read(const PixelBox& part, const PixelBox& box, GLenum what, GLenum type, void* to) const {
    gl_.ReadPixels(part.x - box.x, part.y - box.y, part.width, part.height, what, type, to);
  }

  void refuse_errors() const {
    const GLenum error = gl_.GetError();
    if (error != GL_NO_ERROR) throw environment_error("OpenGL error 0x{:04x} while drawing", error);
  }

  Gl gl_;
  RenderSettings settings_;
  int samples_;
  SurfacePrograms surfaces_;
  Buffers buffers_ = Buffers::depth;  // with a stencil from the first picture on that needs it
  std::unique_ptr<Framebuffer> drawn_;
  std::unique_ptr<Framebuffer> resolved_;
  std::unordered_map<const Mesh*, Uploaded> meshes_;
  std::shared_ptr<Spare> spare_ = std::make_shared<Spare>();
  RendererInfo info_;
  RenderTimes times_;
};

Renderer::Renderer(const Context& context, const RenderSettings& settings)
    : implementation_(std::make_unique<Implementation>(context, settings)) {}

Renderer::~Renderer() = default;

Retouch Renderer::begin(const Picture& picture, Image& image) {
  return implementation_->begin(picture, image);
}

void Renderer::draw(const Picture& picture, Image& image) {
  if (const Retouch retouch = begin(picture, image)) retouch(image);
}

void Renderer::draw(const DrawList& list, Image& image) {
  draw(Picture{{{implementation_->whole(), list}}, {}}, image);
}

const RendererInfo& Renderer::info() const {
  return implementation_->info();
}

RenderTimes Renderer::times() const {
  return implementation_->times();
}

}  // namespace polhode
