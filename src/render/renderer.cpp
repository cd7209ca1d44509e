// SPDX-License-Identifier: MIT
#include "render/renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include "base/error.h"
#include "render/gl_objects.h"

namespace polhode {
namespace {

int integer(const Gl& gl, GLenum name) {
  GLint value = 0;
  gl.GetIntegerv(name, &value);
  return value;
}

int samples_to_use(const Gl& gl, int wanted) {
  return std::min(wanted, integer(gl, GL_MAX_SAMPLES));
}

const RenderSettings& fitting(const Gl& gl, const RenderSettings& settings) {
  const int most = integer(gl, GL_MAX_RENDERBUFFER_SIZE);
  if (settings.width > most || settings.height > most) {
    throw input_error("a picture of {}x{} is larger than OpenGL draws here ({} pixels a side)",
                      settings.width,
                      settings.height,
                      most);
  }
  return settings;
}

// A rectangle of pixels, rows from the top; empty when it holds none.
struct Region {
  int left = 0, top = 0, right = 0, bottom = 0;

  bool empty() const { return left >= right || top >= bottom; }
  int width() const { return right - left; }
  int height() const { return bottom - top; }
};

Region all_of(const PixelBox& box) {
  return {box.x, box.y, box.right(), box.bottom()};
}

Region united(const Region& a, const Region& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.left, b.left),
          std::min(a.top, b.top),
          std::max(a.right, b.right),
          std::max(a.bottom, b.bottom)};
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

// the inverse transposed, up to a factor, of a matrix of any size: its determinant may be out of
// single precision's reach
glm::mat3 normal_from_mesh(const glm::mat3& world_from_mesh) {
  const float size = std::max({glm::length(world_from_mesh[0]),
                               glm::length(world_from_mesh[1]),
                               glm::length(world_from_mesh[2])});
  return glm::transpose(glm::inverse(world_from_mesh / size));
}

// premultiplied colour, as blending leaves it, to the straight alpha of Image
void unpremultiply(Image& image) {
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
    const int alpha = image.pixels[i + 3];
    if (alpha == 0 || alpha == 255) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const int value = (image.pixels[i + c] * 255 + alpha / 2) / alpha;
      image.pixels[i + c] = static_cast<std::uint8_t>(std::min(value, 255));
    }
  }
}

}  // namespace

class Renderer::Implementation {
 public:
  Implementation(const Context& context, const RenderSettings& settings)
      : gl_(context),
        settings_(fitting(gl_, settings)),
        samples_(samples_to_use(gl_, settings.samples)),
        program_(gl_, "scene.vert", "scene.frag"),
        drawn_(gl_, settings.width, settings.height, samples_, true),
        resolved_(gl_, settings.width, settings.height, 0, false),
        u_(program_) {
    info_.backend = context.backend();
    info_.gl_renderer = reinterpret_cast<const char*>(gl_.GetString(GL_RENDERER));
    info_.gl_version = reinterpret_cast<const char*>(gl_.GetString(GL_VERSION));
    info_.samples = samples_;
  }

  void draw(const Picture& picture, Image& image) {
    {
      const StageTimer timer(times_.draw);
      choose_regions(picture);
      for (std::size_t i = 0; i < picture.panels.size(); ++i)
        draw_panel(picture.panels[i], regions_[i]);
      gl_.Finish();
    }
    const StageTimer timer(times_.read_back);
    read_back(image);
    refuse_errors();
    forget_unused_meshes();
    for (const Stamp& stamp : picture.stamps)
      lay_over(image, stamp);
  }

  PixelBox whole() const { return {0, 0, settings_.width, settings_.height}; }
  const RendererInfo& info() const { return info_; }
  const RenderTimes& times() const { return times_; }

 private:
  // the uniforms of scene.vert and scene.frag
  struct Uniforms {
    explicit Uniforms(const Program& p)
        : clip_from_world(p.uniform("u_clip_from_world")),
          world_from_mesh(p.uniform("u_world_from_mesh")),
          normal_from_mesh(p.uniform("u_normal_from_mesh")),
          eye(p.uniform("u_eye")),
          key_light(p.uniform("u_key_light")),
          fill_light(p.uniform("u_fill_light")),
          color(p.uniform("u_color")),
          alpha(p.uniform("u_alpha")),
          gloss(p.uniform("u_gloss")),
          mark_color(p.uniform("u_mark_color")),
          mark_width(p.uniform("u_mark_width")),
          finish(p.uniform("u_finish")),
          flat(p.uniform("u_flat")),
          soft(p.uniform("u_soft")),
          fade(p.uniform("u_fade")) {}
    GLint clip_from_world, world_from_mesh, normal_from_mesh, eye, key_light, fill_light, color,
        alpha, gloss, mark_color, mark_width, finish, flat, soft, fade;
  };

  struct Uploaded {
    MeshPtr keep;  // the address is the key, so the mesh must live
    std::unique_ptr<GpuMesh> gpu;
    std::array<glm::vec3, 8> corners;
    bool used = true;
  };

  // what was drawn in a panel of the frame before
  struct Drawn {
    PixelBox place;
    Region covered;
    glm::vec3 background{0.0f};
  };

  // the pixels that the items of a panel may cover
  Region covered(const Panel& panel) {
    const DrawList& list = panel.list;
    const glm::vec2 upper_left(panel.place.x, panel.place.y);
    const glm::vec2 size(panel.place.width, panel.place.height);
    glm::vec2 low(size);
    glm::vec2 high(0.0f);
    for (const std::vector<DrawItem>* items : {&list.opaque, &list.translucent}) {
      for (const DrawItem& item : *items) {
        const glm::mat4 clip_from_mesh = list.view.clip_from_world * item.world_from_mesh;
        for (const glm::vec3& corner : uploaded(item.mesh).corners) {
          const glm::vec4 clip = clip_from_mesh * glm::vec4(corner, 1.0f);
          if (clip.w <= 0.0f) return all_of(panel.place);  // behind the eye: no rectangle
          const glm::vec2 pixel = (0.5f + glm::vec2(0.5f, -0.5f) * glm::vec2(clip) / clip.w) * size;
          low = glm::min(low, pixel);
          high = glm::max(high, pixel);
        }
      }
    }
    // a pixel more on each side for rounding
    low = upper_left + glm::clamp(low - 1.0f, glm::vec2(0.0f), size);
    high = upper_left + glm::clamp(high + 1.0f, glm::vec2(0.0f), size);
    return {static_cast<int>(low.x),
            static_cast<int>(low.y),
            static_cast<int>(std::ceil(high.x)),
            static_cast<int>(std::ceil(high.y))};
  }

  // only what this frame or the one before covers is cleared, drawn and resolved; the rest of both
  // framebuffers is background already
  void choose_regions(const Picture& picture) {
    const bool same_panels =
        std::equal(picture.panels.begin(),
                   picture.panels.end(),
                   before_.begin(),
                   before_.end(),
                   [](const Panel& now, const Drawn& last) { return now.place == last.place; });
    regions_.clear();
    std::vector<Drawn> now;
    for (const Panel& panel : picture.panels) {
      const Drawn drawn{panel.place, covered(panel), panel.list.background};
      const Drawn* last = same_panels ? &before_[now.size()] : nullptr;
      const bool same_ground = last != nullptr && last->background == drawn.background;
      regions_.push_back(same_ground ? united(drawn.covered, last->covered) : all_of(panel.place));
      now.push_back(drawn);
    }
    before_ = std::move(now);
  }

  void draw_panel(const Panel& panel, const Region& region) {
    if (region.empty()) return;
    begin(panel, region);
    for (const DrawItem& item : panel.list.opaque)
      draw_item(item);

    // translucent shells come back to front and leave the depth of what is behind them
    gl_.Enable(GL_BLEND);
    gl_.DepthMask(GL_FALSE);
    for (const DrawItem& item : panel.list.translucent)
      draw_item(item);
    gl_.DepthMask(GL_TRUE);
    gl_.Disable(GL_BLEND);
  }

  void begin(const Panel& panel, const Region& region) {
    const DrawList& list = panel.list;
    gl_.BindFramebuffer(GL_FRAMEBUFFER, drawn_.id());
    gl_.Viewport(panel.place.x, panel.place.y, panel.place.width, panel.place.height);
    gl_.Enable(GL_SCISSOR_TEST);
    gl_.Scissor(region.left, region.top, region.width(), region.height());
    const float alpha = settings_.transparent ? 0.0f : 1.0f;
    const glm::vec3 ground = list.background * alpha;
    gl_.ClearColor(ground.r, ground.g, ground.b, alpha);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.Enable(GL_CULL_FACE);
    gl_.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);

    // the picture is drawn upside down, so that rows are read back from top to bottom; that turns
    // every triangle round
    gl_.FrontFace(GL_CW);
    glm::mat4 flip(1.0f);
    flip[1][1] = -1.0f;
    program_.use();
    const glm::mat4 clip = flip * list.view.clip_from_world;
    gl_.UniformMatrix4fv(u_.clip_from_world, 1, GL_FALSE, glm::value_ptr(clip));
    gl_.Uniform3fv(u_.eye, 1, glm::value_ptr(list.view.eye));
    gl_.Uniform3fv(u_.key_light, 1, glm::value_ptr(list.view.key_light));
    gl_.Uniform3fv(u_.fill_light, 1, glm::value_ptr(list.view.fill_light));
  }

  void draw_item(const DrawItem& item) {
    const glm::mat3 normals = normal_from_mesh(glm::mat3(item.world_from_mesh));
    gl_.UniformMatrix4fv(u_.world_from_mesh, 1, GL_FALSE, glm::value_ptr(item.world_from_mesh));
    gl_.UniformMatrix3fv(u_.normal_from_mesh, 1, GL_FALSE, glm::value_ptr(normals));
    const Material& material = item.material;
    gl_.Uniform3fv(u_.color, 1, glm::value_ptr(material.color));
    gl_.Uniform1f(u_.alpha, material.alpha);
    gl_.Uniform1f(u_.gloss, material.gloss);
    gl_.Uniform3fv(u_.mark_color, 1, glm::value_ptr(material.mark_color));
    gl_.Uniform1f(u_.mark_width, material.mark_width);
    gl_.Uniform1i(u_.finish, static_cast<GLint>(material.finish));
    gl_.Uniform1i(u_.flat, material.flat ? 1 : 0);
    gl_.Uniform1i(u_.soft, material.soft ? 1 : 0);
    gl_.Uniform1f(u_.fade, material.fade);
    if (item.faces == Faces::both) {
      gl_.Disable(GL_CULL_FACE);
    } else {
      gl_.Enable(GL_CULL_FACE);
      gl_.CullFace(item.faces == Faces::front ? GL_BACK : GL_FRONT);
    }
    uploaded(item.mesh).gpu->draw();
  }

  const Uploaded& uploaded(const MeshPtr& mesh) {
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

  void read_back(Image& image) {
    const int w = settings_.width;
    const int h = settings_.height;
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.id());
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.id());
    gl_.Disable(GL_SCISSOR_TEST);  // it clips copies too
    for (const auto& [left, top, right, bottom] : regions_) {
      if (left >= right || top >= bottom) continue;
      gl_.BlitFramebuffer(
          left, top, right, bottom, left, top, right, bottom, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    }
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.id());
    if (image.width != w || image.height != h) image = Image(w, h);
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl_.ReadPixels(0, 0, w, h, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
    if (settings_.transparent) unpremultiply(image);
  }

  void refuse_errors() const {
    const GLenum error = gl_.GetError();
    if (error != GL_NO_ERROR) throw environment_error("OpenGL error 0x{:04x} while drawing", error);
  }

  Gl gl_;
  RenderSettings settings_;
  int samples_;
  Program program_;
  Framebuffer drawn_;
  Framebuffer resolved_;
  Uniforms u_;
  std::unordered_map<const Mesh*, Uploaded> meshes_;
  std::vector<Region> regions_;  // of the panels of the frame being drawn
  std::vector<Drawn> before_;    // the panels of the frame before
  RendererInfo info_;
  RenderTimes times_;
};

Renderer::Renderer(const Context& context, const RenderSettings& settings)
    : implementation_(std::make_unique<Implementation>(context, settings)) {}

Renderer::~Renderer() = default;

void Renderer::draw(const Picture& picture, Image& image) {
  implementation_->draw(picture, image);
}

void Renderer::draw(const DrawList& list, Image& image) {
  implementation_->draw(Picture{{{implementation_->whole(), list}}, {}}, image);
}

const RendererInfo& Renderer::info() const {
  return implementation_->info();
}

const RenderTimes& Renderer::times() const {
  return implementation_->times();
}

}  // namespace polhode
