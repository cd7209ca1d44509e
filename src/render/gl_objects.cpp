// SPDX-License-Identifier: MIT
#include "render/gl_objects.h"

#include <cstddef>
#include <vector>

#include "base/check.h"
#include "base/error.h"

namespace polhode {
namespace {

GLuint compile(const Gl& gl, GLenum stage, const std::string& file, const std::string& head) {
  const GLuint shader = gl.CreateShader(stage);
  std::string source = shader_source(file);
  source.insert(source.find('\n') + 1, head);  // nothing may stand before #version
  const char* text = source.c_str();
  gl.ShaderSource(shader, 1, &text, nullptr);
  gl.CompileShader(shader);
  GLint good = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good != 0) return shader;
  std::vector<char> log(4096);
  gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  gl.DeleteShader(shader);
  throw environment_error("shader {} does not compile here: {}", file, log.data());
}

}  // namespace

GpuMesh::GpuMesh(const Gl& gl, const Mesh& mesh)
    : gl_(gl), count_(static_cast<GLsizei>(mesh.indices.size())) {
  gl.GenVertexArrays(1, &array_);
  gl.BindVertexArray(array_);
  gl.GenBuffers(1, &vertices_);
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_);
  gl.BufferData(GL_ARRAY_BUFFER,
                static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(Vertex)),
                mesh.vertices.data(),
                GL_STATIC_DRAW);
  gl.GenBuffers(1, &indices_);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
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

GpuMesh::~GpuMesh() {
  gl_.DeleteBuffers(1, &vertices_);
  gl_.DeleteBuffers(1, &indices_);
  gl_.DeleteVertexArrays(1, &array_);
}

void GpuMesh::draw() const {
  gl_.BindVertexArray(array_);
  gl_.DrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
}

Program::Program(const Gl& gl,
                 const std::string& vertex_file,
                 const std::string& fragment_file,
                 const std::string& head)
    : gl_(gl) {
  const GLuint vertex = compile(gl, GL_VERTEX_SHADER, vertex_file, head);
  const GLuint fragment = compile(gl, GL_FRAGMENT_SHADER, fragment_file, head);
  id_ = gl.CreateProgram();
  gl.AttachShader(id_, vertex);
  gl.AttachShader(id_, fragment);
  gl.LinkProgram(id_);
  gl.DeleteShader(vertex);
  gl.DeleteShader(fragment);
  GLint good = 0;
  gl.GetProgramiv(id_, GL_LINK_STATUS, &good);
  if (good != 0) return;
  std::vector<char> log(4096);
  gl.GetProgramInfoLog(id_, static_cast<GLsizei>(log.size()), nullptr, log.data());
  gl.DeleteProgram(id_);
  throw environment_error(
      "shaders {} and {} do not link here: {}", vertex_file, fragment_file, log.data());
}

Program::~Program() {
  gl_.DeleteProgram(id_);
}

GLint Program::uniform(const std::string& name) const {
  return gl_.GetUniformLocation(id_, name.c_str());
}

Framebuffer::Framebuffer(const Gl& gl, int width, int height, int samples, bool with_depth)
    : gl_(gl), width_(width), height_(height) {
  gl.GenFramebuffers(1, &id_);
  gl.BindFramebuffer(GL_FRAMEBUFFER, id_);
  color_ = attach(GL_COLOR_ATTACHMENT0, GL_RGBA8, width, height, samples);
  if (with_depth)
    depth_ = attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, width, height, samples);
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw environment_error(
        "OpenGL cannot create a {}x{} framebuffer with {} samples here", width, height, samples);
  }
}

Framebuffer::~Framebuffer() {
  gl_.DeleteFramebuffers(1, &id_);
  gl_.DeleteRenderbuffers(1, &color_);
  gl_.DeleteRenderbuffers(1, &depth_);
}

GLuint Framebuffer::attach(
    GLenum attachment, GLenum format, int width, int height, int samples) const {
  GLuint buffer = 0;
  gl_.GenRenderbuffers(1, &buffer);
  gl_.BindRenderbuffer(GL_RENDERBUFFER, buffer);
  gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
  return buffer;
}

const std::string& shader_source(const std::string& file) {
  const auto found = embedded_shaders().find(file);
  CHECK(found != embedded_shaders().end());
  return found->second;
}

}  // namespace polhode
