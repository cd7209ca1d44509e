// SPDX-License-Identifier: MIT
// Contexts of both back ends, and the functions that are loaded through them.
#include <string>

#include <gtest/gtest.h>

#include "render/context.h"
#include "render/gl.h"
#include "support/expect_error.h"

namespace polhode {
namespace {

TEST(Context, EveryBackEndGivesACoreContext) {
  for (const Backend& backend : backends()) {
    const std::unique_ptr<Context> context = open_context(backend.name);
    EXPECT_EQ(context->backend(), backend.name);
    const Gl gl(*context);
    const std::string version = reinterpret_cast<const char*>(gl.GetString(GL_VERSION));
    EXPECT_GE(std::stod(version), 3.3) << version;
    GLint profile = 0;
    gl.GetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    EXPECT_TRUE((profile & GL_CONTEXT_CORE_PROFILE_BIT) != 0) << backend.name;
    EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
  }
}

// one after another, of either kind: each begins with objects of its own
TEST(Context, OneFollowsAnother) {
  for (const char* backend : {"osmesa", "egl", "osmesa", "egl"}) {
    const std::unique_ptr<Context> context = open_context(backend);
    const Gl gl(*context);
    GLuint buffer = 0;
    gl.GenBuffers(1, &buffer);
    EXPECT_EQ(buffer, 1u) << backend;
  }
}

TEST(Context, AutoIsTheFirstThatOpens) {
  EXPECT_EQ(open_context("auto")->backend(), backends().front().name);
  EXPECT_EQ(backend_names().front(), "auto");
  EXPECT_EQ(backend_names().size(), backends().size() + 1);
}

TEST(Context, AnUnknownBackEndNamesTheNearest) {
  test::expect_input_error([] { open_context("osmessa"); }, "--backend", "'osmesa'");
}

// a driver that lacks one function
class Lacking final : public Context {
 public:
  explicit Lacking(const Context& whole) : whole_(whole) {}
  std::string backend() const override { return whole_.backend(); }
  void* function(const char* name) const override {
    return std::string(name) == "glBlitFramebuffer" ? nullptr : whole_.function(name);
  }

 private:
  const Context& whole_;
};

TEST(Context, AMissingFunctionIsNamed) {
  const std::unique_ptr<Context> context = open_context("auto");
  test::expect_error(
      [&] { Gl{Lacking(*context)}; }, Fault::environment, "", "lacks glBlitFramebuffer");
}

}  // namespace
}  // namespace polhode
