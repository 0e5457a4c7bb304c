# cmake -DSTAGE=03_damping -DOUT=FOLDER -P forward.cmake: the headers that a stage's files find in place of their own
# where `course play 3 --mine` builds it, by course.cmd. They include the learner's; those that are right stay as old as they are.
set(stages ${CMAKE_CURRENT_LIST_DIR}/../../stages)
cmake_path(NORMAL_PATH stages)

function(put header file)
  file(CONFIGURE OUTPUT ${OUT}/${header} CONTENT "#pragma once\n#include \"${stages}/${file}\"\n" @ONLY)
endfunction()

function(is_written out file gap) # the learner's file is there, and that gap in it is filled
  set(${out} OFF PARENT_SCOPE)
  if(EXISTS ${stages}/${file})
    file(READ ${stages}/${file} text)
    string(REGEX MATCH "// \\[${gap}\\].*// \\[${gap}\\]" text "${text}")
    if(NOT text MATCHES "<- here")
      set(${out} ON PARENT_SCOPE)
    endif()
  endif()
endfunction()

file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/subjects/${STAGE}.cpp header REGEX "define BOUNCE_STAGE_HEADER")
string(REGEX REPLACE ".*\"(.*)\".*" "\\1" header "${header}")
put(${header} ${STAGE}/mine.hpp)
# With it come the learner's loop of stage 1 and the learner's own method, once they are written.
set(loop "#pragma once\n")
is_written(has_loop 01_free_fall/mine.hpp loop)
if(has_loop)
  put(01_free_fall/free_fall.hpp 01_free_fall/mine.hpp)
  string(APPEND loop "#define BOUNCE_MY_LOOP\n#include \"01_free_fall/free_fall.hpp\"\n")
endif()
is_written(has_method 02_spring_floor/mine_method.hpp step)
if(has_method)
  put(mine/method.hpp 02_spring_floor/mine_method.hpp)
  string(APPEND loop "#define BOUNCE_MY_METHOD\n#include \"mine/method.hpp\"\n")
endif()
file(CONFIGURE OUTPUT ${OUT}/mine/loop.hpp CONTENT "${loop}" @ONLY)
