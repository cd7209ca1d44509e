// SPDX-License-Identifier: MIT
// The OpenGL functions that the program uses, loaded through a Context. To add one: a line in the
// list below. Types come from Khronos' header.
#pragma once

#include <GL/glcorearb.h>

#include "render/context.h"

namespace polhode {

// clang-format off
#define POLHODE_GL_FUNCTIONS(X)                                                                    \
  X(PFNGLATTACHSHADERPROC, AttachShader)                                                           \
  X(PFNGLBINDBUFFERPROC, BindBuffer)                                                               \
  X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)                                                     \
  X(PFNGLBINDRENDERBUFFERPROC, BindRenderbuffer)                                                   \
  X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray)                                                     \
  X(PFNGLBLENDFUNCPROC, BlendFunc)                                                                 \
  X(PFNGLBLITFRAMEBUFFERPROC, BlitFramebuffer)                                                     \
  X(PFNGLBUFFERDATAPROC, BufferData)                                                               \
  X(PFNGLCHECKFRAMEBUFFERSTATUSPROC, CheckFramebufferStatus)                                       \
  X(PFNGLCLEARPROC, Clear)                                                                         \
  X(PFNGLCLEARCOLORPROC, ClearColor)                                                               \
  X(PFNGLCOLORMASKPROC, ColorMask)                                                                 \
  X(PFNGLCOMPILESHADERPROC, CompileShader)                                                         \
  X(PFNGLCREATEPROGRAMPROC, CreateProgram)                                                         \
  X(PFNGLCREATESHADERPROC, CreateShader)                                                           \
  X(PFNGLCULLFACEPROC, CullFace)                                                                   \
  X(PFNGLDELETEBUFFERSPROC, DeleteBuffers)                                                         \
  X(PFNGLDELETEFRAMEBUFFERSPROC, DeleteFramebuffers)                                               \
  X(PFNGLDELETEPROGRAMPROC, DeleteProgram)                                                         \
  X(PFNGLDELETERENDERBUFFERSPROC, DeleteRenderbuffers)                                             \
  X(PFNGLDELETESHADERPROC, DeleteShader)                                                           \
  X(PFNGLDELETEVERTEXARRAYSPROC, DeleteVertexArrays)                                               \
  X(PFNGLDEPTHFUNCPROC, DepthFunc)                                                                 \
  X(PFNGLDEPTHMASKPROC, DepthMask)                                                                 \
  X(PFNGLDISABLEPROC, Disable)                                                                     \
  X(PFNGLDRAWELEMENTSPROC, DrawElements)                                                           \
  X(PFNGLENABLEPROC, Enable)                                                                       \
  X(PFNGLENABLEVERTEXATTRIBARRAYPROC, EnableVertexAttribArray)                                     \
  X(PFNGLFINISHPROC, Finish)                                                                       \
  X(PFNGLFRAMEBUFFERRENDERBUFFERPROC, FramebufferRenderbuffer)                                     \
  X(PFNGLFRONTFACEPROC, FrontFace)                                                                 \
  X(PFNGLGENBUFFERSPROC, GenBuffers)                                                               \
  X(PFNGLGENFRAMEBUFFERSPROC, GenFramebuffers)                                                     \
  X(PFNGLGENRENDERBUFFERSPROC, GenRenderbuffers)                                                   \
  X(PFNGLGENVERTEXARRAYSPROC, GenVertexArrays)                                                     \
  X(PFNGLGETERRORPROC, GetError)                                                                   \
  X(PFNGLGETINTEGERVPROC, GetIntegerv)                                                             \
  X(PFNGLGETPROGRAMINFOLOGPROC, GetProgramInfoLog)                                                 \
  X(PFNGLGETPROGRAMIVPROC, GetProgramiv)                                                           \
  X(PFNGLGETSHADERINFOLOGPROC, GetShaderInfoLog)                                                   \
  X(PFNGLGETSHADERIVPROC, GetShaderiv)                                                             \
  X(PFNGLGETSTRINGPROC, GetString)                                                                 \
  X(PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation)                                               \
  X(PFNGLLINKPROGRAMPROC, LinkProgram)                                                             \
  X(PFNGLPIXELSTOREIPROC, PixelStorei)                                                             \
  X(PFNGLREADPIXELSPROC, ReadPixels)                                                               \
  X(PFNGLRENDERBUFFERSTORAGEMULTISAMPLEPROC, RenderbufferStorageMultisample)                       \
  X(PFNGLSCISSORPROC, Scissor)                                                                     \
  X(PFNGLSHADERSOURCEPROC, ShaderSource)                                                           \
  X(PFNGLSTENCILFUNCPROC, StencilFunc)                                                             \
  X(PFNGLSTENCILOPPROC, StencilOp)                                                                 \
  X(PFNGLUNIFORM1FPROC, Uniform1f)                                                                 \
  X(PFNGLUNIFORM1IPROC, Uniform1i)                                                                 \
  X(PFNGLUNIFORM3FVPROC, Uniform3fv)                                                               \
  X(PFNGLUNIFORM4FVPROC, Uniform4fv)                                                               \
  X(PFNGLUNIFORMMATRIX3FVPROC, UniformMatrix3fv)                                                   \
  X(PFNGLUNIFORMMATRIX4FVPROC, UniformMatrix4fv)                                                   \
  X(PFNGLUSEPROGRAMPROC, UseProgram)                                                               \
  X(PFNGLVERTEXATTRIBPOINTERPROC, VertexAttribPointer)                                             \
  X(PFNGLVIEWPORTPROC, Viewport)
// clang-format on

// The functions of one context as members: gl.Clear(...), gl.Enable(...). Valid on the context's
// thread only.
struct Gl {
#define POLHODE_GL_MEMBER(type, name) type name = nullptr;
  POLHODE_GL_FUNCTIONS(POLHODE_GL_MEMBER)
#undef POLHODE_GL_MEMBER

  // Loads all functions. Throws Error (environment) if one is missing.
  explicit Gl(const Context& context);
};

}  // namespace polhode
