// SPDX-License-Identifier: MIT
// What the machine lacks, or takes away amid the work: one line, exit code 3 (130 for an
// interrupt), and nothing left behind.
#include <algorithm>
#include <sstream>

#include <sys/stat.h>

#include "support/background.h"

namespace polhode {
namespace {

using test::Ran;
using test::run_polhode;
using test::TemporaryFolder;
using test::write_text;

// libraries write lines of their own: x264 does when it gets no memory
long lines_of_polhode(const std::string& text) {
  std::istringstream lines(text);
  long count = 0;
  for (std::string line; std::getline(lines, line);) {
    count += line.starts_with("polhode: ") ? 1 : 0;
  }
  return count;
}

// a scene in the folder, and the command for a picture of it
std::string still_in(const TemporaryFolder& folder) {
  write_text(folder / "scene.toml", test::kSmallScene);
  return "render '" + (folder / "scene.toml") + "' --still 0 -o '" + (folder / "a.png") + "'";
}

// makes a film of a small scene, and gives its name for a shell
std::string film_in(const TemporaryFolder& folder,
                    const std::string& name = "a.mp4",
                    const std::string& options = "") {
  write_text(folder / "scene.toml", test::kSmallScene);
  const std::string film = "'" + (folder / name) + "'";
  EXPECT_EQ(run_polhode("render '" + (folder / "scene.toml") + "' -o " + film + options).code, 0);
  return film;
}

// the environment of a machine that lacks something (tests/support/lacking.cpp)
std::string lacking(const std::string& what) {
  return "POLHODE_LACKS=" + what + " LD_PRELOAD='" POLHODE_LACKING "'";
}

// the real loader against a machine without the libraries: files of their names that are no
// libraries
TEST(Environment, WithoutAnyOpenGlTheRunSaysWhatIsMissing) {
  const TemporaryFolder folder;
  write_text(folder / "scene.toml", test::kSmallScene);
  for (const char* name :
       {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so", "libEGL.so.1", "libEGL.so"}) {
    write_text(folder / name, "");
  }
  const std::string before = "LD_LIBRARY_PATH='" + folder.path().string() + "'";
  const long files = folder.entries();
  for (const std::string backend : {"auto", "osmesa", "egl"}) {
    const Ran ran = run_polhode("render '" + (folder / "scene.toml") + "' -o '" +
                                    (folder / "a.mp4") + "' --backend " + backend,
                                before);
    EXPECT_EQ(ran.code, 3) << ran.err;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_EQ(folder.entries(), files);
  }
  // with one of the two back, auto finds it
  for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}) {
    std::filesystem::remove(folder / name);
  }
  const Ran ran = run_polhode("render '" + (folder / "scene.toml") + "' -o '" + (folder / "a.png") +
                                  "' --report '" + (folder / "r.json") + "'",
                              before);
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(test::read_text(folder / "r.json").find("\"backend\": \"osmesa\""), std::string::npos);
}

TEST(Environment, AFullDiskLeavesNothing) {
  const TemporaryFolder folder;
  write_text(folder / "scene.toml", test::kSmallScene);
  // one block of 512 bytes (sh) is less than any film; stdout and stderr stay below it
  const Ran ran = run_polhode(
      "render '" + (folder / "scene.toml") + "' -o '" + (folder / "a.mp4") + "'", "ulimit -f 1;");
  EXPECT_EQ(ran.code, 3) << ran.err;
  EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
  EXPECT_EQ(folder.entries(), 1);
}

// a shell sets the limit at which the system tells and that at which it kills together
TEST(Environment, AnEndOfProcessorTimeLeavesNothing) {
  const TemporaryFolder folder;
  write_text(folder / "scene.toml", test::kSmallScene);
  const Ran ran = run_polhode("render '" + (folder / "scene.toml") + "' --size 1920x1080 -o '" +
                                  (folder / "a.mp4") + "' --fps 1000 --set motion.duration=100",
                              "ulimit -t 2;");
  EXPECT_NE(ran.code, 0);
  EXPECT_NE(ran.err.find("ulimit -t"), std::string::npos) << ran.err;
  EXPECT_EQ(folder.entries(), 1);
}

// Mesa itself crashes below this
TEST(Environment, LittleMemoryIsToldInOneLine) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer itself needs terabytes of addresses";
#endif
  const TemporaryFolder folder;
  write_text(folder / "scene.toml", test::kSmallScene);
  for (const std::string limit : {"200000", "300000", "400000", "600000", "900000"}) {
    const Ran ran =
        run_polhode("render '" + (folder / "scene.toml") + "' -o '" + (folder / "a.mp4") + "'",
                    "ulimit -v " + limit + ";");
    EXPECT_EQ(ran.code, 3) << ran.err;
    EXPECT_EQ(lines_of_polhode(ran.err), 1) << ran.err;
    EXPECT_EQ(folder.entries(), 1) << limit;
  }
}

TEST(Environment, ASmallStackIsToldBeforeItOverflows) {
  for (const int stack_KB : {64, 256}) {
    const Ran ran = run_polhode("list shapes", "ulimit -s " + std::to_string(stack_KB) + ";");
    EXPECT_EQ(ran.code, 3) << ran.err;
    EXPECT_NE(ran.err.find("ulimit -s"), std::string::npos) << ran.err;
  }
  EXPECT_EQ(run_polhode("list shapes", "ulimit -s 512;").code, 0);
}

// a decoder that gets no memory takes the film for damaged
TEST(Environment, AFilmIsNotDamagedWhereMemoryLacks) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer itself needs terabytes of addresses";
#endif
  const TemporaryFolder folder;
  const std::string film = film_in(folder, "a.mp4", " --size 640x360");
  for (int limit = 340'000; limit <= 420'000; limit += 10'000) {
    const Ran ran =
        run_polhode("diff " + film + " " + film, "ulimit -v " + std::to_string(limit) + ";");
    EXPECT_NE(ran.code, 2) << limit << ran.err;
  }
}

// decoders that get no memory tell the log alone, and pass on another picture, or none
TEST(Environment, FilmsDoNotDifferWhereMemoryLacks) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer wants to be loaded first";
#endif
  const TemporaryFolder folder;
  const std::string film = film_in(folder);
  for (int at = 1200; at < 2800; at += 40) {
    const Ran ran = run_polhode("diff " + film + " " + film,
                                "POLHODE_LACKS_AT=" + std::to_string(at) + " " + lacking("memory"));
    EXPECT_NE(ran.code, 1) << at << ran.out;
    EXPECT_EQ(ran.err.find("has more"), std::string::npos) << at << ran.err;
  }
}

// letters of fonts that cannot be opened would be boxes
TEST(Environment, AFewOpenFilesAreToldBeforeTheyLack) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer needs descriptors of its own to look at memory";
#endif
  const TemporaryFolder folder;
  const std::string still = still_in(folder);
  const auto run = [&](int files) {
    return run_polhode(still, "sh -c 'ulimit -n " + std::to_string(files) + "; exec \"$@\"' sh");
  };
  const Ran few = run(12);
  EXPECT_EQ(few.code, 3) << few.err;
  EXPECT_NE(few.err.find("(ulimit -n)"), std::string::npos) << few.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
  EXPECT_EQ(run(64).code, 0);
}

// what tests/support/lacking.cpp takes away, one at a time; the film and the captions of an earlier
// run stay, or the film is whole
TEST(Environment, WhatLibrariesLackIsToldInOneLine) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer wants to be loaded first";
#endif
  const struct {
    const char *lacks, *output, *options, *says;
  } cases[] = {
      {"threads", "a.png", " --still 0", "no more than 0 threads can be started"},
      {"shared_memory", "a.mp4", " --jobs 2", "not enough memory for so many --jobs"},
      {"chapters", "a.mp4", "", "no memory for the film"},
      {"cairo", "a.mp4", "", "text cannot be drawn: out of memory"},
      {"removal", "a.mp4", "", "cannot remove the captions of an earlier film"},
      {"reason", "a.mp4", "", "unexpected: no reason"},
  };
  for (const auto& [lacks, output, options, says] : cases) {
    SCOPED_TRACE(lacks);
    const TemporaryFolder folder;
    std::string scene = test::kSmallScene;
    // a film without captions removes those of an earlier film
    const bool captions = lacks != std::string("removal");
    scene += "[[shots]]\nat = 0\nname = \"start\"\n";
    if (captions) scene += "[[story]]\nat = 0\ncaption = \"It turns\"\n";
    write_text(folder / "scene.toml", scene);
    write_text(folder / "a.mp4", "old");
    write_text(folder / "a.vtt", "WEBVTT - captions by polhode\n");
    const Ran ran = run_polhode(
        "render '" + (folder / "scene.toml") + "' -o '" + (folder / output) + "'" + options,
        lacking(lacks));
    EXPECT_EQ(ran.code, 3) << ran.err;
    EXPECT_EQ(lines_of_polhode(ran.err), 1) << ran.err;
    EXPECT_NE(ran.err.find(says), std::string::npos) << ran.err;
    EXPECT_EQ(folder.entries(), 3);
    if (captions) {
      EXPECT_EQ(test::read_text(folder / "a.mp4"), "old");
    }
  }
}

// a film is not damaged because no thread can decode it
TEST(Environment, ThreadsThatCannotBeStartedAreTold) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer wants to be loaded first";
#endif
  const TemporaryFolder folder;
  for (const char* name : {"a.mp4", "a-%d.png"}) {
    const std::string film = film_in(folder, name);
    const Ran ran = run_polhode("diff " + film + " " + film, lacking("threads"));
    EXPECT_EQ(ran.code, 3) << ran.err;
    EXPECT_EQ(lines_of_polhode(ran.err), 1) << ran.err;
    EXPECT_EQ(ran.err.find("unexpected"), std::string::npos) << ran.err;
  }
}

// libraries that are opened only where they are needed
TEST(Environment, LibrariesThatAreOpenedLateAreNamed) {
  const TemporaryFolder folder, libraries;
  write_text(folder / "scene.toml", test::kSmallScene);
  for (int version = 7; version < 15; ++version) {
    write_text(libraries / ("libavfilter.so." + std::to_string(version)), "");
  }
  const std::string render = "render '" + (folder / "scene.toml") + "' -o '" + (folder / "a");
  const Ran gif =
      run_polhode(render + ".gif'", "LD_LIBRARY_PATH='" + libraries.path().string() + "'");
  EXPECT_EQ(gif.code, 3) << gif.err;
  EXPECT_NE(gif.err.find("a GIF needs libavfilter"), std::string::npos) << gif.err;
  // an EGL that knows no driver
  const Ran egl =
      run_polhode(render + ".mp4' --backend egl", "__EGL_VENDOR_LIBRARY_FILENAMES=/nowhere.json");
  EXPECT_EQ(egl.code, 3) << egl.err;
  EXPECT_NE(egl.err.find("EGL has no surfaceless platform"), std::string::npos) << egl.err;
  EXPECT_EQ(folder.entries(), 1);
}

// Mesa and Pango crash when the environment asks for what they do not have
TEST(Environment, DriversThatAreNotThereAreRefused) {
  const TemporaryFolder folder;
  const std::string still = still_in(folder);
  // "auto" goes on to EGL, which leaks when it fails
  const Ran ran = run_polhode(still + " --backend osmesa", "GALLIUM_DRIVER=none");
  EXPECT_EQ(ran.code, 3) << ran.err;
  EXPECT_NE(ran.err.find("GALLIUM_DRIVER is 'none'"), std::string::npos) << ran.err;
  EXPECT_EQ(folder.entries(), 1);
  EXPECT_EQ(run_polhode(still, "PANGOCAIRO_BACKEND=none").code, 0);
}

// text would be empty boxes
TEST(Environment, WithoutAnyFontTextIsRefused) {
  const TemporaryFolder folder;
  write_text(folder / "scene.toml", test::kSmallScene);
  write_text(folder / "fonts.conf", "<fontconfig></fontconfig>");
  const std::string still =
      "render '" + (folder / "scene.toml") + "' --still 0 -o '" + (folder / "a.png") + "'";
  const std::string none = "FONTCONFIG_FILE='" + (folder / "fonts.conf") + "'";
  const Ran ran = run_polhode(still, none);
  EXPECT_EQ(ran.code, 3) << ran.err;
  EXPECT_NE(ran.err.find("no font is there; install fonts-inter"), std::string::npos) << ran.err;
  EXPECT_EQ(folder.entries(), 2);
  EXPECT_EQ(run_polhode(still + " --no-text", none).code, 0);
}

// Variables for those who debug Mesa: it crashes, draws nothing, or runs tests of its own and ends
// the process with 0, which a check would say.
TEST(Environment, DebuggingOfMesaChangesNothing) {
  const TemporaryFolder folder;
  const std::string still = still_in(folder);
  ASSERT_EQ(run_polhode(still).code, 0);
  const std::string right = read_text(folder / "a.png");
  for (const std::string wrong : {"MESA_GLSL_VERSION_OVERRIDE=110",
                                  "MESA_GL_VERSION_OVERRIDE=2.1",
                                  "MESA_EXTENSION_OVERRIDE=-GL_ARB_framebuffer_object",
                                  "LP_PERF=no_rast",
                                  "LP_NO_RAST=1",
                                  "GALLIUM_NOOP=1",
                                  "GALLIUM_TESTS=1",
                                  "GALLIUM_DDEBUG=true",
                                  "GALLIUM_DUMP_VS=1"}) {
    std::filesystem::remove(folder / "a.png");
    const Ran ran = run_polhode(still, wrong);
    EXPECT_EQ(ran.code, 0) << wrong << ran.err;
    EXPECT_EQ(read_text(folder / "a.png"), right) << wrong;
  }
  EXPECT_EQ(run_polhode(still, "LP_NATIVE_VECTOR_WIDTH=128").code, 0);
  const Ran wide = run_polhode(still, "LP_NATIVE_VECTOR_WIDTH=1024");
  EXPECT_EQ(wide.code, 3);
  EXPECT_NE(wide.err.find("LP_NATIVE_VECTOR_WIDTH is '1024'"), std::string::npos) << wide.err;
}

// what libraries say on standard output would stand in files that go there
TEST(Environment, StandardOutputIsOurs) {
  const TemporaryFolder folder;
  write_text(folder / "scene.toml", test::kSmallScene);
  const std::string inspect = "inspect '" + (folder / "scene.toml") + "' --json";
  const std::string plot =
      "plot '" + (folder / "scene.toml") + "' tilt -o '" + (folder / "a.svg") + "'";
  EXPECT_EQ(run_polhode(inspect, "FC_DEBUG=1").out, run_polhode(inspect).out);
  // Pixman obeys before we can say no
  EXPECT_EQ(run_polhode(inspect, "PIXMAN_DISABLE=wholeops").code, 3);
  // a gnuplot that talks
  write_text(folder / "gnuplot", "#!/bin/sh\necho hello\nexec /usr/bin/gnuplot \"$@\"\n");
  std::filesystem::permissions(folder / "gnuplot", std::filesystem::perms::owner_all);
  const Ran ran = run_polhode(plot, "PATH='" + folder.path().string() + "':\"$PATH\"");
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(read_text(folder / "a.svg").starts_with("<?xml")) << read_text(folder / "a.svg");
}

// whatever it calls that
TEST(Environment, ALibraryThatEndsTheProgramIsAFault) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer wants to be loaded before all else";
#endif
  const TemporaryFolder folder;
  write_text(folder / "scene.toml", test::kSmallScene);
  const Ran ran =
      run_polhode("render '" + (folder / "scene.toml") + "' -o '" + (folder / "a.mp4") + "'",
                  lacking("patience"));
  EXPECT_EQ(ran.code, 3);
  EXPECT_EQ(ran.err, "polhode: a library has ended the program\n");
  EXPECT_EQ(folder.entries(), 1);
}

// Mesa maps the index of its cache: on a full disk that is a bus error
TEST(Environment, AFullDiskOfTheShaderCacheIsLeftAlone) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer wants to be loaded before all else";
#endif
  const TemporaryFolder folder, cache;
  const std::string still = still_in(folder);
  const std::string at = "XDG_CACHE_HOME='" + cache.path().string() + "' ";
  const Ran full = run_polhode(still, at + lacking("room"));
  EXPECT_EQ(full.code, 0) << full.err;
  EXPECT_EQ(cache.entries(), 0);
  EXPECT_EQ(run_polhode(still, at).code, 0);
  EXPECT_TRUE(std::filesystem::exists(cache / "mesa_shader_cache"));
}

// programs that fail are told as what they are, and what was there before stays
TEST(Environment, ProgramsThatFailAreToldWithTheReason) {
  const TemporaryFolder folder, programs;
  write_text(folder / "scene.toml", test::kSmallScene);
  write_text(folder / "deck.md", "# Words\n\n## More\n");
  std::filesystem::create_directory(folder / "out");
  const std::string out = " -o '" + (folder / "out") + "'";
  const std::string stability =
      "stability '" + (folder / "scene.toml") + "' --cells 2x2 --methods rk4" + out;
  const std::string lecture = "lecture '" + (folder / "deck.md") + "'" + out + " --to ";
  // the real one reads
  const std::string reads =
      "case \" $* \" in *' -f json '*) ;; *) PATH=${PATH#*:} exec pandoc \"$@\";; esac\n";
  const struct {
    const char* program;
    std::string script, arguments, says;
  } cases[] = {
      {"gnuplot", "echo no fonts >&2; exit 7", stability, "ended with exit code 7: no fonts"},
      {"gnuplot", "kill -SEGV $$", stability, "was ended by signal 11"},
      {"gnuplot", "exec yes", stability, "wrote more than"},
      {"gnuplot", "exec sleep 60", stability, "took longer than 25 s"},
      {"gnuplot", "cat >/dev/null; echo garbage", stability, "gnuplot wrote no picture"},
      {"pandoc", "exit 7", lecture + "html", "ended with exit code 7"},
      {"pandoc", "sleep 60 & exit 7", lecture + "html", "ended with exit code 7"},
      {"pandoc", "echo garbage", lecture + "html", "syntax tree of an unknown kind"},
      {"pandoc", reads + "kill -SEGV $$", lecture + "html", "was ended by signal 11"},
      {"pandoc", reads + "exit 0", lecture + "html", "pandoc wrote nothing"},
      {"pandoc", reads + "exit 0", lecture + "beamer", "pandoc wrote nothing"},
      {"pandoc", reads + "echo; exit 0", lecture + "pptx", "pandoc wrote no such document"},
  };
  for (const auto& one : cases) {
    SCOPED_TRACE(one.script + " " + one.says);
    for (const char* file : {"index.html", "slides.tex", "slides.pptx", "stability_scene.svg"})
      write_text(folder / ("out/" + std::string(file)), "old");
    write_text(programs / one.program, "#!/bin/sh\n" + one.script + "\n");
    std::filesystem::permissions(programs / one.program, std::filesystem::perms::owner_all);
    const Ran ran =
        run_polhode(one.arguments, "PATH='" + programs.path().string() + "':\"$PATH\" timeout 40");
    std::filesystem::remove(programs / one.program);
    EXPECT_EQ(ran.code, 3) << ran.err;
    EXPECT_NE(ran.err.find(one.says), std::string::npos) << ran.err;
    EXPECT_EQ(ran.err.find("install"), std::string::npos) << ran.err;
    for (const char* file : {"index.html", "slides.tex", "slides.pptx", "stability_scene.svg"})
      EXPECT_EQ(test::read_text(folder / ("out/" + std::string(file))), "old") << file;
  }
}

TEST(Environment, InterruptLeavesNothingAndSaysSo) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const TemporaryFolder folder;
    write_text(folder / "scene.toml", test::long_scene());
    test::Background run(
        {"render", folder / "scene.toml", "-o", folder / "a.mp4", "--progress", "json"});
    run.await_progress();
    const Ran ran = run.end(signal);
    EXPECT_EQ(ran.code, 130) << signal << ran.err;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_EQ(folder.entries(), 1) << signal;
  }
}

// a pipe that nobody reads, as a terminal that is stopped, would hold the last words for ever
TEST(Environment, AnInterruptArrivesWhereNobodyReadsWhatIsSaid) {
  const TemporaryFolder folder;
  write_text(folder / "scene.toml", test::long_scene());
  write_text(folder / "full.sh",
             "cd \"$(dirname \"$0\")\" || exit 1\n"
             "mkfifo pipe; sleep 30 <pipe & reader=$!; exec 3>pipe\n"
             "head -c 65536 /dev/zero >&3\n"
             "timeout --preserve-status -s TERM -k 10 2 \"$@\" 2>&3\n"
             "echo $? >code; kill $reader\n");
  run_polhode("render scene.toml -o a.mp4 --progress json", "sh '" + (folder / "full.sh") + "'");
  EXPECT_EQ(test::read_text(folder / "code"), "130\n");
  EXPECT_EQ(folder.entries(), 4);
}

TEST(Environment, AnAnswerThatCannotBeWrittenIsAFailure) {
  const TemporaryFolder folder;
  write_text(folder / "scene.toml", test::kSmallScene);
  const std::string scene = "'" + (folder / "scene.toml") + "'";
  for (const std::string& arguments : {std::string("list methods"),
                                       std::string("schema"),
                                       std::string("doctor"),
                                       std::string("--help"),
                                       std::string("render --help"),
                                       std::string("--version"),
                                       "inspect " + scene,
                                       "simulate " + scene + " -o -"}) {
    for (const std::string closed : {"1>/dev/full", "1>&-"}) {
      SCOPED_TRACE(arguments + " " + closed);
      const Ran ran = run_polhode(arguments + " " + closed + " 2>'" + (folder / "err") + "' #");
      EXPECT_EQ(ran.code, 3);
      EXPECT_NE(test::read_text(folder / "err").find("cannot write to standard output"),
                std::string::npos);
    }
  }
}

TEST(Environment, AReaderWhoHasHadEnoughIsNoFailure) {
  const TemporaryFolder folder;
  run_polhode("schema 2>'" + (folder / "err") + "'; echo $? >'" + (folder / "code") +
                  "') | head -n 1 >'" + (folder / "out") + "' #",
              "(");
  EXPECT_EQ(test::read_text(folder / "out"), "{\n");
  EXPECT_EQ(test::read_text(folder / "code"), "0\n");
  EXPECT_EQ(test::read_text(folder / "err"), "");
}

TEST(Environment, AFileThatLinksToItselfIsNotMissing) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("loop.toml", folder / "loop.toml");
  const Ran ran = run_polhode("inspect '" + (folder / "loop.toml") + "'");
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("Too many levels of symbolic links"), std::string::npos) << ran.err;
}

// the number of a closed stream must not become that of the film
TEST(Environment, ClosedStreamsChangeNothingElse) {
  const TemporaryFolder folder;
  write_text(folder / "scene.toml", test::kSmallScene);
  const std::string scene = "'" + (folder / "scene.toml") + "'";
  EXPECT_EQ(run_polhode("render 2>&- #").code, 2);
  EXPECT_EQ(
      run_polhode("render " + scene + " -o '" + (folder / "a.png") + "' 0<&- 1>&- 2>&- #").code, 0);
  EXPECT_EQ(run_polhode("render " + scene + " -o '" + (folder / "b.png") + "'").code, 0);
  EXPECT_EQ(test::read_text(folder / "a.png"), test::read_text(folder / "b.png"));
}

TEST(Environment, AFolderThatIsGoneIsTold) {
  const TemporaryFolder folder;
  const std::string gone = folder / "gone";
  for (const char* words : {"status x", "cancel x"}) {
    const Ran ran =
        run_polhode(words, "mkdir '" + gone + "' && cd '" + gone + "' && rmdir '" + gone + "' &&");
    EXPECT_EQ(ran.code, 3) << words;
    EXPECT_NE(ran.err.find("the working folder cannot be found"), std::string::npos) << ran.err;
  }
}

TEST(Environment, WhatIsNoFileIsNotWaitedFor) {
  const TemporaryFolder folder;
  const std::string pipe = folder / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const Ran ran =
      run_polhode("render '" + pipe + "' -o '" + (folder / "a.mp4") + "'", "timeout 20");
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("not a regular file"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace polhode
