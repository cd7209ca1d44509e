// SPDX-License-Identifier: MIT
#include "chart/gnuplot.h"

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "support/expect_error.h"
#include "support/in_child.h"
#include "support/run.h"

namespace polhode::test {
namespace {

TEST(Gnuplot, DrawsEveryFormat) {
  const std::string script = "plot [0:1] x title " + gnuplot_text("a line") + "\n";
  EXPECT_EQ(draw_with_gnuplot(script, PlotFormat::png, 200, 100).substr(1, 3), "PNG");
  EXPECT_EQ(draw_with_gnuplot(script, PlotFormat::pdf, 200, 100).substr(0, 5), "%PDF-");
  const std::string svg = draw_with_gnuplot(script, PlotFormat::svg, 200, 100);
  EXPECT_NE(svg.find("<svg"), std::string::npos);
  EXPECT_NE(svg.find("a line"), std::string::npos);
}

TEST(Gnuplot, UnknownNumbersAreNotDrawn) {
  EXPECT_EQ(gnuplot_number(0.5), "0.5");
  EXPECT_EQ(gnuplot_number(std::nan("")), "NaN");
  EXPECT_EQ(gnuplot_number(INFINITY), "NaN");
}

// whatever stands in a scene's title stays text: no command runs, and every script still draws
TEST(Gnuplot, TextRunsNoCommands) {
  const TemporaryFolder folder;
  const std::string file = folder / "pwned";
  const std::string attacks[] = {
      "'; system('touch " + file + "'); '",
      "`touch " + file + "`",
      "\"; system(\"touch " + file + "\"); \"",
      "x'\nsystem('touch " + file + "')\n'",
      "\\' ; ! touch " + file + " #",
      "@macro $var %n {/:Bold x} ^_&~",
      "$(touch " + file + ")",
      "' . system('touch " + file + "') . '",
      std::string("nul\0byte", 8),
      "\xff\xfe broken utf-8",
  };
  for (const std::string& attack : attacks) {
    SCOPED_TRACE(attack);
    const std::string text = gnuplot_text(attack);
    const std::string script = "set label 1 " + text + " at 0,0\nset title " + text +
                               "\nplot [0:1] x title " + text + "\n";
    for (const PlotFormat format : {PlotFormat::svg, PlotFormat::png})
      EXPECT_FALSE(draw_with_gnuplot(script, format, 200, 100).empty());
    EXPECT_FALSE(std::filesystem::exists(file));
  }
}

// in titles, names of axes, labels and keys
TEST(Gnuplot, TextIsAsItIs) {
  const std::string words = "50 % of E_1^2, a@b, $5, C:\\x, `q`, {r}, ~, %g, \\";
  const std::string text = gnuplot_text(words);
  const std::string svg = draw_with_gnuplot(
      "set title " + text + "\nset xlabel " + text + "\nset ylabel " + text + "\nset label 1 " +
          text + " at graph 0.5,0.5 front\nset key noenhanced\nplot [0:1] x title " + text + "\n",
      PlotFormat::svg,
      600,
      400);
  std::size_t found = 0;
  for (std::size_t i = svg.find("<text>" + words); i != std::string::npos;
       i = svg.find("<text>" + words, i + 1))
    ++found;
  EXPECT_EQ(found, 5u) << svg;
}

TEST(Gnuplot, TitlesAreEscapedInSvg) {
  const std::string svg = draw_with_gnuplot(
      "plot [0:1] x title " + gnuplot_text("<script>alert(1)</script> & co") + "\n",
      PlotFormat::svg,
      300,
      200);
  EXPECT_EQ(svg.find("<script>alert"), std::string::npos);
}

// a gnuplot that is missing, that has no right to run, and that fails: each is told
TEST(Gnuplot, WhatCannotRunIsToldWithTheReason) {
  const TemporaryFolder folder;
  const auto told = [&](const char* script, std::filesystem::perms rights, const char* reason) {
    write_text(folder / "gnuplot", script);
    std::filesystem::permissions(folder / "gnuplot", rights);
    return exit_code_in_child([&] {
      setenv("PATH", folder.path().c_str(), 1);
      try {
        require_gnuplot();
      } catch (const Error& error) {
        const bool said = error.fault() == Fault::environment &&
                          error.message().find(reason) != std::string::npos;
        return said && find_gnuplot().version.empty() ? 0 : 1;
      }
      return 2;
    });
  };
  const char* fails = "#!/bin/sh\necho 'libgd.so.3: cannot open' >&2\nexit 127\n";
  EXPECT_EQ(told(fails, std::filesystem::perms::owner_read, "Permission denied"), 0);
  EXPECT_EQ(told(fails, std::filesystem::perms::owner_all, "libgd.so.3: cannot open"), 0);
  std::filesystem::remove(folder / "gnuplot");
  const auto missing = [&] {
    setenv("PATH", folder.path().c_str(), 1);
    return find_gnuplot().why_not == "gnuplot is not installed" ? 0 : 1;
  };
  EXPECT_EQ(exit_code_in_child(missing), 0);
}

// what is no picture must not take the place of one
TEST(Gnuplot, OnlyAPictureOfTheFormatIsTaken) {
  const TemporaryFolder folder;
  write_text(folder / "gnuplot", "#!/bin/sh\nwhile read line; do :; done; echo garbage >&3\n");
  std::filesystem::permissions(folder / "gnuplot", std::filesystem::perms::owner_all);
  for (const PlotFormat format : {PlotFormat::svg, PlotFormat::png, PlotFormat::pdf}) {
    const int told = exit_code_in_child([&] {
      setenv("PATH", (folder.path().string() + ":/usr/bin:/bin").c_str(), 1);
      try {
        draw_with_gnuplot("", format, 200, 100);
      } catch (const Error& error) {
        const bool said = error.message().ends_with("gnuplot wrote no picture");
        return said && error.fault() == Fault::environment ? 0 : 1;
      }
      return 2;
    });
    EXPECT_EQ(told, 0);
  }
}

// a disk that fills up would cut them off without a word
TEST(Gnuplot, PicturesNeedNoRoomOnADisk) {
  for (const PlotFormat format : {PlotFormat::svg, PlotFormat::png, PlotFormat::pdf}) {
    const std::string whole = draw_with_gnuplot("plot [0:1] x\n", format, 200, 100);
    const int same = exit_code_in_child([&] {
      setenv("TMPDIR", "/nonexistent", 1);
      return draw_with_gnuplot("plot [0:1] x\n", format, 200, 100).size() == whole.size() ? 0 : 1;
    });
    EXPECT_EQ(same, 0);
  }
}

TEST(Gnuplot, ABrokenScriptIsTold) {
  expect_error([] { draw_with_gnuplot("plot nonsense(\n", PlotFormat::svg, 200, 100); },
               Fault::environment,
               "",
               "gnuplot ended with exit code");
}

}  // namespace
}  // namespace polhode::test
