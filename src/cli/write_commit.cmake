# Writes OUTPUT, a C++ file that holds the commit of the folder SOURCE; leaves it alone when it is as it should be.
# POLHODE_COMMIT in the environment says it instead, for builds from an archive.
set(commit "$ENV{POLHODE_COMMIT}")
if(commit STREQUAL "" AND EXISTS "${SOURCE}/.git")
  find_program(GIT git)
  if(GIT)
    execute_process(COMMAND ${GIT} -C ${SOURCE} rev-parse --short=12 HEAD
      OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed ERROR_QUIET)
    if(failed)
      set(commit "")
    else()
      execute_process(COMMAND ${GIT} -C ${SOURCE} diff --quiet HEAD -- RESULT_VARIABLE differs ERROR_QUIET)
      if(differs)
        string(APPEND commit "-modified")
      endif()
    endif()
  endif()
endif()
set(text "// Made by src/cli/write_commit.cmake.
#include \"cli/commit.h\"

namespace polhode {

const char* program_commit() {
  return \"${commit}\";
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
