# Writes OUTPUT, a C++ file that holds the commit of the folder SOURCE; leaves it alone when it is as it should be.
# POLHODE_COMMIT in the environment says it instead, for builds from an archive.
set(commit "$ENV{POLHODE_COMMIT}")
set(date "")
if(EXISTS "${SOURCE}/.git")
  find_program(GIT git)
endif()
if(commit STREQUAL "" AND GIT)
  execute_process(COMMAND ${GIT} -C ${SOURCE} log -1 --abbrev=12 --format=%h
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  execute_process(COMMAND ${GIT} -C ${SOURCE} log -1 --format=%cs
    OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  execute_process(COMMAND ${GIT} -C ${SOURCE} diff --quiet HEAD -- RESULT_VARIABLE differs ERROR_QUIET)
  if(differs AND NOT commit STREQUAL "")
    string(APPEND commit "-modified")
  endif()
endif()
if(date STREQUAL "")
  file(TIMESTAMP "${SOURCE}/CHANGELOG.md" date "%Y-%m-%d" UTC)
endif()
set(text "// Made by src/cli/write_commit.cmake.
#include \"cli/commit.h\"

namespace polhode {

const char* program_commit() {
  return \"${commit}\";
}

const char* program_date() {
  return \"${date}\";
}

}  // namespace polhode
")
set(there "")
if(EXISTS "${OUTPUT}")
  file(READ "${OUTPUT}" there)
endif()
if(NOT there STREQUAL text)
  file(WRITE "${OUTPUT}" "${text}")
endif()
