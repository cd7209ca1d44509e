// SPDX-License-Identifier: MIT
#include "app/commands/doctor.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "base/version.h"
#include "render/context.h"
#include "support/in_child.h"
#include "text/typesetter.h"
#include "video/encoders.h"

namespace polhode {
namespace {

// what stands behind that name; "" if there is no such line
std::string state_of(const Diagnosis& diagnosis, const std::string& name) {
  const std::string text = "\n" + diagnosis.text;
  const std::size_t at = text.find("\n" + name + "  ");
  if (at == std::string::npos) return "";
  const std::size_t from = text.find_first_not_of(' ', at + 1 + name.size());
  return text.substr(from, text.find('\n', from) - from);
}

bool starts_with(const std::string& text, const std::string& words) {
  return text.rfind(words, 0) == 0;
}

TEST(Doctor, ExaminesBackEndsFontsEncodersAndPrograms) {
  const Diagnosis diagnosis = examine({{"slides", "missing: install it"}});
  EXPECT_EQ(state_of(diagnosis, "polhode"), program_version());
  EXPECT_EQ(state_of(diagnosis, "slides"), "missing: install it");
  for (const Backend& backend : backends()) {
    const std::string state = state_of(diagnosis, "back end " + backend.name);
    EXPECT_TRUE(starts_with(state, "ok, ") || starts_with(state, "missing: ")) << state;
  }
  for (const FilmEncoder& encoder : film_encoders()) {
    const std::string state = state_of(diagnosis, "encoder " + encoder.name);
    EXPECT_TRUE(starts_with(state, has_encoder(encoder.name) ? "ok, " : "missing: ")) << state;
  }
  for (const FontFound& font : examine_fonts())
    EXPECT_EQ(state_of(diagnosis, "font " + font.wanted) == "ok", font.there) << font.wanted;
  EXPECT_GT(std::atoi(state_of(diagnosis, "threads").c_str()), 0);
}

// films need one back end and the encoder of .mp4, nothing else
TEST(Doctor, AMachineThatDrawsAndEncodesIsHealthy) {
  const Diagnosis diagnosis = examine({{"slides", "missing: install it"}});
  bool draws = false;
  for (const Backend& backend : backends())
    draws = draws || starts_with(state_of(diagnosis, "back end " + backend.name), "ok, ");
  EXPECT_EQ(diagnosis.healthy, draws && has_encoder("libx264"));
}

TEST(Doctor, AProgramThatFailsIsNotToBeInstalled) {
  EXPECT_EQ(state_of_program({"program 1.2", "", true}, "install it"), "ok, program 1.2");
  EXPECT_EQ(state_of_program({"", "program is not installed", false}, "install it"),
            "missing: install it");
  EXPECT_EQ(state_of_program({"", "program took longer than 10 s", true}, "install it"),
            "fails: program took longer than 10 s");
}

TEST(Doctor, TriesTheFolderForTemporaryFiles) {
  EXPECT_TRUE(starts_with(state_of(examine({}), "temporary files"), "ok, "));
  EXPECT_EQ(test::exit_code_in_child([] {
              setenv("TMPDIR", "/nowhere", 1);
              const std::string state = state_of(examine({}), "temporary files");
              return state == "fails: there is no folder /nowhere for temporary files; set TMPDIR"
                         ? 0
                         : 1;
            }),
            0);
}

// without programs and without libraries, on any machine
TEST(Doctor, SaysWhatToInstall) {
  EXPECT_EQ(
      test::exit_code_in_child([] {
        setenv("PATH", "/nowhere", 1);
        return state_of(examine({}), "charts").starts_with("missing: install gnuplot-nox") ? 0 : 1;
      }),
      0);
}

}  // namespace
}  // namespace polhode
