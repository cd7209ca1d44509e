// SPDX-License-Identifier: MIT
// OpenGL objects that delete themselves.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "frame/mesh.h"
#include "render/gl.h"

namespace polhode {

// A vertex array with its two buffers, filled once from a mesh.
class GpuMesh {
 public:
  GpuMesh(const Gl& gl, const Mesh& mesh);
  ~GpuMesh();
  GpuMesh(const GpuMesh&) = delete;
  GpuMesh& operator=(const GpuMesh&) = delete;
  void draw() const;

 private:
  const Gl& gl_;
  GLuint array_ = 0;
  GLuint vertices_ = 0;
  GLuint indices_ = 0;
  GLsizei count_ = 0;
};

// A linked program from two files of shaders/.
class Program {
 public:
  // `head` are lines that come after the #version of both. Throws Error (environment) with the
  // compiler's words.
  Program(const Gl& gl,
          const std::string& vertex_file,
          const std::string& fragment_file,
          const std::string& head);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  void use() const { gl_.UseProgram(id_); }
  // The location of a uniform; -1, which OpenGL ignores, when this program does without it.
  GLint uniform(const std::string& name) const;

 private:
  const Gl& gl_;
  GLuint id_ = 0;
};

// A framebuffer with RGBA8 colour and, if asked, depth; samples 0 means single-sampled.
class Framebuffer {
 public:
  Framebuffer(const Gl& gl, int width, int height, int samples, bool with_depth);
  ~Framebuffer();
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;
  GLuint id() const { return id_; }
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  GLuint attach(GLenum attachment, GLenum format, int width, int height, int samples) const;

  const Gl& gl_;
  int width_, height_;
  GLuint id_ = 0;
  GLuint color_ = 0;
  GLuint depth_ = 0;
};

// The text of a file of shaders/, embedded when the program was built.
const std::string& shader_source(const std::string& file);
// All of them: name to text; defined in a file that CMake writes.
const std::map<std::string, std::string>& embedded_shaders();

}  // namespace polhode
