// SPDX-License-Identifier: MIT
// OpenGL objects that are deleted by their destructors. Use them on the thread of the context. The
// context and `gl`, to which they keep a reference, must outlive them.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "frame/mesh.h"
#include "render/gl.h"

namespace polhode {

// A mesh in GPU memory: a vertex array with vertex and index buffers.
class GpuMesh {
 public:
  // Copies the mesh.
  GpuMesh(const Gl& gl, const Mesh& mesh);
  ~GpuMesh();
  GpuMesh(const GpuMesh&) = delete;
  GpuMesh& operator=(const GpuMesh&) = delete;
  // Draws all triangles with the current program.
  void draw() const;

 private:
  const Gl& gl_;
  GLuint array_ = 0;
  GLuint vertices_ = 0;
  GLuint indices_ = 0;
  GLsizei count_ = 0;
};

// A shader program, linked from two files of shaders/.
class Program {
 public:
  // `head` is inserted after the #version line of both files, which are names of files in shaders/.
  // Throws Error (environment) with the message of the compiler or linker.
  Program(const Gl& gl,
          const std::string& vertex_file,
          const std::string& fragment_file,
          const std::string& head);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  // Makes it the current program of the context.
  void use() const { gl_.UseProgram(id_); }
  // The location of a uniform; -1, which OpenGL ignores, if the program does not use it.
  GLint uniform(const std::string& name) const;

 private:
  const Gl& gl_;
  GLuint id_ = 0;
};

// A framebuffer with RGBA8 colour and optional 32-bit floating-point depth.
class Framebuffer {
 public:
  // Sizes in pixels; samples: per pixel, 0 without multisampling. Throws Error (environment) if
  // OpenGL cannot make it.
  Framebuffer(const Gl& gl, int width, int height, int samples, bool with_depth);
  ~Framebuffer();
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;
  // OpenGL's name of the framebuffer.
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

// The text of a file of shaders/, embedded at build time; valid until the program ends. Aborts if
// there is no such file.
const std::string& shader_source(const std::string& file);
// The texts of all shader files by name; defined in a file that CMake generates.
const std::map<std::string, std::string>& embedded_shaders();

}  // namespace polhode
