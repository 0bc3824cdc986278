# gapcheck_room(NAME SOURCES file… DEPENDS target…): one folder of lib/ as one static library gapcheck_NAME. It can be linked
# into a shared library too, the Python module. Hidden symbols cost nothing there: no call takes a detour.
function(gapcheck_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  add_library(gapcheck_${name} STATIC ${ROOM_SOURCES})
  target_link_libraries(gapcheck_${name} PUBLIC ${ROOM_DEPENDS} PRIVATE $<BUILD_INTERFACE:gapcheck_flags> ${ROOM_PRIVATE_DEPENDS})
  target_include_directories(gapcheck_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/lib>)
  target_compile_features(gapcheck_${name} PUBLIC cxx_std_20)
  set_target_properties(gapcheck_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden
                        VISIBILITY_INLINES_HIDDEN ON)
  if(name IN_LIST GAPCHECK_PLAIN)
    set_target_properties(gapcheck_${name} PROPERTIES UNITY_BUILD OFF)
  endif()
  set(kinds sanitized threads)
  if(name STREQUAL results)  # runs on one thread only
    set(kinds sanitized)
  endif()
  gapcheck_twins(gapcheck_${name} ${kinds})
endfunction()

# gapcheck_optimise(LEVEL TARGET…): another level than -O3 for code that computes little. 1: printing and reading options,
# compiled in three quarters of the time of -O2; large reports take up to 5 % longer. 2: reading files, which -O1 makes a
# tenth slower, and the rules.
function(gapcheck_optimise level)
  foreach(target ${ARGN})
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O${level}>)
  endforeach()
endfunction()

# gapcheck_inline_more(TARGET…): for the rooms that compute. In units of many files g++ soon reaches the growth by inlining
# that it allows, and then calls even what is one line. tests/bench/instructions counts what that costs.
function(gapcheck_inline_more)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    foreach(target ${ARGN})
      target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:--param=inline-unit-growth=200>)
    endforeach()
  endif()
endfunction()

# gapcheck_test(NAME SOURCES file… DEPENDS target…): one test program gapcheck_test_NAME, run by ctest.
function(gapcheck_test name)
  cmake_parse_arguments(TEST "" "" "SOURCES;DEPENDS" ${ARGN})
  add_executable(gapcheck_test_${name} ${TEST_SOURCES})
  target_link_libraries(gapcheck_test_${name} PRIVATE gapcheck_flags ${TEST_DEPENDS} GTest::gtest_main)
  target_include_directories(gapcheck_test_${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(gapcheck_test_${name} PRIVATE GAPCHECK_ROOT="${PROJECT_SOURCE_DIR}")
  # Tests are compiled once and run once: less optimised they are there sooner, but for those with slow twins. clang needs
  # half the time of g++, where it is installed. Those with random scenes stay with g++: in which order the arguments of a
  # call are evaluated is the compiler's choice, and with it which numbers a scene gets.
  set(level -O0)
  if(name MATCHES "^(contact|contact_rules|fix|geometry|stress|threads)$")
    set(level -O1)
  endif()
  target_compile_options(gapcheck_test_${name} PRIVATE $<$<CONFIG:Release>:${level}>)
  if(level STREQUAL "-O0" AND NOT name STREQUAL audit AND GAPCHECK_TWIN_LAUNCHER AND CMAKE_BUILD_TYPE STREQUAL "Release")
    set_target_properties(gapcheck_test_${name} PROPERTIES CXX_COMPILER_LAUNCHER "${GAPCHECK_TWIN_LAUNCHER}")
    target_compile_options(gapcheck_test_${name} PRIVATE -Wno-unknown-warning-option)
  endif()
  gapcheck_libraries_below(gapcheck_test_${name} libraries)
  gapcheck_link_first(gapcheck_test_${name} ${libraries})
  gapcheck_add_halves(gapcheck_test_${name} ${name} "" TIMEOUT 900)
  gapcheck_twin_test(gapcheck_test_${name} sanitized ${name})
endfunction()
