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

// Owns the name of one OpenGL object, which it deletes; so a constructor that throws leaves nothing
// behind. The name 0 is none.
class GlName {
 public:
  // Deletes the object of that name; does nothing for 0.
  using Delete = void (*)(const Gl& gl, GLuint name);
  GlName(const Gl& gl, Delete remove, GLuint name = 0) : gl_(gl), delete_(remove), name_(name) {}
  ~GlName() { delete_(gl_, name_); }
  GlName(const GlName&) = delete;
  GlName& operator=(const GlName&) = delete;
  GLuint get() const { return name_; }
  // Where OpenGL is to write the name; call it only while there is none.
  GLuint* place() { return &name_; }

 private:
  const Gl& gl_;
  Delete delete_;
  GLuint name_;
};

// A mesh in GPU memory: a vertex array with vertex and index buffers.
class GpuMesh {
 public:
  // Copies the mesh.
  GpuMesh(const Gl& gl, const Mesh& mesh);
  GpuMesh(const GpuMesh&) = delete;
  GpuMesh& operator=(const GpuMesh&) = delete;
  // Draws all triangles with the current program.
  void draw() const;

 private:
  const Gl& gl_;
  GlName array_, vertices_, indices_;
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
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  // Makes it the current program of the context.
  void use() const { gl_.UseProgram(id_.get()); }
  // The location of a uniform; -1, which OpenGL ignores, if the program does not use it.
  GLint uniform(const std::string& name) const;

 private:
  const Gl& gl_;
  GlName id_;
};

// What a framebuffer has beside RGBA8 colour: 32-bit floating-point depth, and 8 bits of stencil.
enum class Buffers { color, depth, depth_and_stencil };

// A framebuffer.
class Framebuffer {
 public:
  // Sizes in pixels; samples: per pixel, 0 without multisampling. Throws Error (environment) if
  // OpenGL cannot make it.
  Framebuffer(const Gl& gl, int width, int height, int samples, Buffers buffers);
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;
  // OpenGL's name of the framebuffer.
  GLuint id() const { return id_.get(); }
  int width() const { return width_; }
  int height() const { return height_; }
  Buffers buffers() const { return buffers_; }

 private:
  void attach(GlName& buffer, GLenum attachment, GLenum format, int samples) const;

  const Gl& gl_;
  int width_, height_;
  Buffers buffers_;
  GlName id_, color_, depth_;
};

// The text of a file of shaders/, embedded at build time; valid until the program ends. Aborts if
// there is no such file.
const std::string& shader_source(const std::string& file);
// The texts of all shader files by name; defined in a file that CMake generates.
const std::map<std::string, std::string>& embedded_shaders();

}  // namespace polhode
