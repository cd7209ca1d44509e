// SPDX-License-Identifier: MIT
#include "render/gl_objects.h"

#include <cstddef>
#include <vector>

#include "base/check.h"
#include "base/error.h"

namespace polhode {
namespace {

void delete_buffer(const Gl& gl, GLuint name) {
  gl.DeleteBuffers(1, &name);
}
void delete_vertex_array(const Gl& gl, GLuint name) {
  gl.DeleteVertexArrays(1, &name);
}
void delete_framebuffer(const Gl& gl, GLuint name) {
  gl.DeleteFramebuffers(1, &name);
}
void delete_renderbuffer(const Gl& gl, GLuint name) {
  gl.DeleteRenderbuffers(1, &name);
}
void delete_shader(const Gl& gl, GLuint name) {
  gl.DeleteShader(name);
}
void delete_program(const Gl& gl, GLuint name) {
  gl.DeleteProgram(name);
}

void compile(const Gl& gl, GLuint shader, const std::string& file, const std::string& head) {
  std::string source = shader_source(file);
  const std::string include = "#include \"surface.glsl\"\n";
  if (const std::size_t at = source.find(include); at != std::string::npos)
    source.replace(at, include.size(), shader_source("surface.glsl"));
  source.insert(source.find('\n') + 1, head);  // nothing may stand before #version
  const char* text = source.c_str();
  gl.ShaderSource(shader, 1, &text, nullptr);
  gl.CompileShader(shader);
  GLint good = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good != 0) return;
  std::vector<char> log(4096);
  gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  throw environment_error("shader {} does not compile here: {}", file, log.data());
}

}  // namespace

GpuMesh::GpuMesh(const Gl& gl, const Mesh& mesh)
    : gl_(gl),
      array_(gl, delete_vertex_array),
      vertices_(gl, delete_buffer),
      indices_(gl, delete_buffer),
      count_(static_cast<GLsizei>(mesh.indices.size())) {
  gl.GenVertexArrays(1, array_.place());
  gl.BindVertexArray(array_.get());
  gl.GenBuffers(1, vertices_.place());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.get());
  gl.BufferData(GL_ARRAY_BUFFER,
                static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(Vertex)),
                mesh.vertices.data(),
                GL_STATIC_DRAW);
  gl.GenBuffers(1, indices_.place());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.get());
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER,
                static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(std::uint32_t)),
                mesh.indices.data(),
                GL_STATIC_DRAW);

  // locations 0 and 1 of scene.vert
  const auto attribute = [&gl](GLuint location, std::size_t offset) {
    gl.EnableVertexAttribArray(location);
    // OpenGL takes the offset in the shape of a pointer
    const void* at = reinterpret_cast<const void*>(offset);  // NOLINT(performance-no-int-to-ptr)
    gl.VertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), at);
  };
  attribute(0, offsetof(Vertex, position));
  attribute(1, offsetof(Vertex, normal));
}

void GpuMesh::draw() const {
  gl_.BindVertexArray(array_.get());
  gl_.DrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
}

Program::Program(const Gl& gl,
                 const std::string& vertex_file,
                 const std::string& fragment_file,
                 const std::string& head)
    : gl_(gl), id_(gl, delete_program) {
  const GlName vertex(gl, delete_shader, gl.CreateShader(GL_VERTEX_SHADER));
  const GlName fragment(gl, delete_shader, gl.CreateShader(GL_FRAGMENT_SHADER));
  compile(gl, vertex.get(), vertex_file, head);
  compile(gl, fragment.get(), fragment_file, head);
  *id_.place() = gl.CreateProgram();
  gl.AttachShader(id_.get(), vertex.get());
  gl.AttachShader(id_.get(), fragment.get());
  gl.LinkProgram(id_.get());
  GLint good = 0;
  gl.GetProgramiv(id_.get(), GL_LINK_STATUS, &good);
  if (good != 0) return;
  std::vector<char> log(4096);
  gl.GetProgramInfoLog(id_.get(), static_cast<GLsizei>(log.size()), nullptr, log.data());
  throw environment_error(
      "shaders {} and {} do not link here: {}", vertex_file, fragment_file, log.data());
}

GLint Program::uniform(const std::string& name) const {
  return gl_.GetUniformLocation(id_.get(), name.c_str());
}

Framebuffer::Framebuffer(const Gl& gl, int width, int height, int samples, Buffers buffers)
    : gl_(gl),
      width_(width),
      height_(height),
      buffers_(buffers),
      id_(gl, delete_framebuffer),
      color_(gl, delete_renderbuffer),
      depth_(gl, delete_renderbuffer) {
  gl.GenFramebuffers(1, id_.place());
  gl.BindFramebuffer(GL_FRAMEBUFFER, id_.get());
  attach(color_, GL_COLOR_ATTACHMENT0, GL_RGBA8, samples);
  if (buffers == Buffers::depth) {
    attach(depth_, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, samples);
  } else if (buffers == Buffers::depth_and_stencil) {
    attach(depth_, GL_DEPTH_STENCIL_ATTACHMENT, GL_DEPTH32F_STENCIL8, samples);
  }
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw environment_error(
        "OpenGL cannot create a {}x{} framebuffer with {} samples here", width, height, samples);
  }
}

void Framebuffer::attach(GlName& buffer, GLenum attachment, GLenum format, int samples) const {
  gl_.GenRenderbuffers(1, buffer.place());
  gl_.BindRenderbuffer(GL_RENDERBUFFER, buffer.get());
  gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width_, height_);
  gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer.get());
}

const std::string& shader_source(const std::string& file) {
  const auto found = embedded_shaders().find(file);
  CHECK(found != embedded_shaders().end());
  return found->second;
}

}  // namespace polhode
