// SPDX-License-Identifier: MIT
#include "base/system/scratch_folder.h"

#include "support/expect_error.h"
#include "support/in_child.h"
#include "support/run.h"

namespace polhode::test {
namespace {

namespace fs = std::filesystem;

TEST(ScratchFolder, IsRemovedWithAllThatIsInIt) {
  fs::path inside;
  {
    const ScratchFolder scratch;
    const ScratchFolder other;
    inside = scratch / "a";
    EXPECT_NE(inside, fs::path(other / "a"));
    fs::create_directories(inside / "deep");
    write_text(inside / "deep" / "file", "text");
    EXPECT_EQ(fs::status(inside.parent_path()).permissions(), fs::perms::owner_all);
  }
  EXPECT_FALSE(fs::exists(inside.parent_path()));
}

TEST(ScratchFolder, LiesInTmpdirAndSaysSoWhenItCannot) {
  const TemporaryFolder folder;
  const int code = exit_code_in_child([&] {
    setenv("TMPDIR", folder.path().c_str(), 1);
    {
      const ScratchFolder scratch;
      if (fs::path(scratch / "a").parent_path().parent_path() != folder.path()) return 1;
    }
    setenv("TMPDIR", "", 1);
    {
      const ScratchFolder scratch;
      if (fs::path(scratch / "a").parent_path().parent_path() != "/tmp") return 2;
    }
    setenv("TMPDIR", (folder / "none").c_str(), 1);
    try {
      const ScratchFolder scratch;
    } catch (const Error& error) {
      const bool told = error.message().find("set TMPDIR") != std::string::npos;
      return told ? static_cast<int>(error.fault()) : 4;
    }
    return 5;
  });
  EXPECT_EQ(code, static_cast<int>(Fault::environment));
  EXPECT_EQ(folder.entries(), 0);
}

}  // namespace
}  // namespace polhode::test
