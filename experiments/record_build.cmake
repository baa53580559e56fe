# Run at every build: writes gcslab_build_info.h, and touches it only when something changed.
# Needs -DSOURCE_DIR, -DFLAGS, -DOUTPUT. A build without git, or outside a repository, is of commit "unknown".

set(commit "unknown")
set(dirty "false")
find_program(GIT_PROGRAM git)
if(GIT_PROGRAM)
  execute_process(COMMAND ${GIT_PROGRAM} -C ${SOURCE_DIR} rev-parse HEAD
                  OUTPUT_VARIABLE found OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(NOT failed)
    set(commit "${found}")
    # Reports are results, not sources: updating them does not make another program.
    execute_process(COMMAND ${GIT_PROGRAM} -C ${SOURCE_DIR} status --porcelain --untracked-files=no -- . :!reports
                    OUTPUT_VARIABLE changes ERROR_QUIET)
    if(NOT changes STREQUAL "")
      set(dirty "true")
    endif()
  endif()
endif()

string(REPLACE "\\" "\\\\" flags "${FLAGS}")
string(REPLACE "\"" "\\\"" flags "${flags}")
set(text "#pragma once
namespace gcslab::build_info {
inline constexpr char kCommit[] = \"${commit}\";
inline constexpr bool kDirty = ${dirty};
inline constexpr char kFlags[] = \"${flags}\";
}  // namespace gcslab::build_info
")
set(known "")
if(EXISTS "${OUTPUT}")
  file(READ "${OUTPUT}" known)
endif()
if(NOT known STREQUAL text)
  file(WRITE "${OUTPUT}" "${text}")
endif()
