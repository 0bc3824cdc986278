# Sanitized twins of libraries and programs, in the same build: with GAPCHECK_TWINS every room and library of the programs
# is compiled a second time with the address, leak and undefined-behaviour sanitizers (kind "sanitized"), and what
# gapcheck_test_threads needs a third time with the thread sanitizer (kind "threads"). Test programs are not compiled
# again: their twins link the same objects with the sanitized libraries. That halves the time of ./test.
option(GAPCHECK_TWINS "Build sanitized twins of libraries and tests (targets …_sanitized, …_threads)" OFF)

# Eigen must take and free memory as in the objects that are not compiled again. Left out: checks that the address
# sanitizer makes as well, or that cost the compiler most: alignment and pointer-overflow took a third of its time; the preset fuzz has them.
set(GAPCHECK_TWIN_sanitized -O1 -g1 -UNDEBUG -DEIGEN_MALLOC_ALREADY_ALIGNED=1 -fsanitize=address,undefined
    -fno-sanitize=null,object-size,vptr,alignment,pointer-overflow -fno-sanitize-recover=all -fno-omit-frame-pointer)
set(GAPCHECK_TWIN_threads -O0 -g1 -UNDEBUG -fsanitize=thread -fno-omit-frame-pointer)
# clang compiles the twins in half the time of g++, as far as it is installed; its code and that of g++ go together.
find_program(GAPCHECK_TWIN_COMPILER clang++-14)
set(GAPCHECK_TWIN_LAUNCHER "")
if(GAPCHECK_TWIN_COMPILER)
  set(command ${GAPCHECK_TWIN_COMPILER})
  if(GAPCHECK_CCACHE)
    set(command "${GAPCHECK_CCACHE} ${command}")
  endif()
  set(GAPCHECK_TWIN_LAUNCHER ${PROJECT_SOURCE_DIR}/cmake/use_instead.sh "${command}")
endif()
# lld links their large programs in a quarter of the time.
find_program(GAPCHECK_TWIN_LINKER ld.lld-14)
# Rooms that print, read or pass on: without optimisation the compiler needs a third of the time, and their tests no more.
set(GAPCHECK_LIGHT_TWINS gapcheck_base gapcheck_records gapcheck_keyword gapcheck_model gapcheck_results
    gapcheck_report gapcheck_api gapcheck_apps gapcheck_commands gapcheck_manual_text gapcheck_check_c_arguments)

# gapcheck_twins(TARGET KIND…): twins of a library TARGET of the present directory, made at the directory's end, when
# nothing is added to it any more.
function(gapcheck_twins target)
  if(NOT GAPCHECK_TWINS)
    return()
  endif()
  foreach(kind ${ARGN})
    set_property(GLOBAL APPEND PROPERTY gapcheck_twins_${kind} ${target})
    cmake_language(EVAL CODE "cmake_language(DEFER CALL gapcheck_twin_library ${target} ${kind})")
  endforeach()
endfunction()

# gapcheck_twin_test(TARGET KIND TEST ARGUMENT…): a twin of a test program, and test TEST_KIND that runs it.
function(gapcheck_twin_test target kind test)
  if(GAPCHECK_TWINS)
    # Deferred calls see the variables of the directory's end, so the arguments are kept under a name of their own.
    set_property(GLOBAL PROPERTY gapcheck_arguments_${test}_${kind} "${ARGN}")
    cmake_language(EVAL CODE "cmake_language(DEFER CALL gapcheck_twin_program ${target} ${kind})")
    cmake_language(EVAL CODE "cmake_language(DEFER CALL gapcheck_add_twin_test ${target} ${kind} ${test})")
  endif()
endfunction()

# gapcheck_add_halves(TARGET TEST SUFFIX TIMEOUT seconds [LABELS …] [ENVIRONMENT …] [ARGUMENTS …]): test TEST+SUFFIX that runs program TARGET+SUFFIX. The longest
# ones run in two halves at once, before the others. Under its second name it writes results of its own.
function(gapcheck_add_halves target test suffix)
  cmake_parse_arguments(HALF "" "TIMEOUT" "LABELS;ENVIRONMENT;ARGUMENTS" ${ARGN})
  set(halves ${test})
  if(test MATCHES "^(apps|solver)$")
    list(APPEND halves ${test}.second)
    add_custom_command(TARGET ${target}${suffix} POST_BUILD
      COMMAND ${CMAKE_COMMAND} -E create_symlink $<TARGET_FILE_NAME:${target}${suffix}> ${target}.second${suffix}
      WORKING_DIRECTORY $<TARGET_FILE_DIR:${target}${suffix}>)
  endif()
  list(LENGTH halves count)
  set(number 0)
  foreach(half ${halves})
    string(REPLACE ${test} ${target} program ${half})
    add_test(NAME ${half}${suffix}
             COMMAND $<TARGET_FILE_DIR:${target}${suffix}>/${program}${suffix} ${HALF_ARGUMENTS})
    set(environment ${HALF_ENVIRONMENT})
    if(count GREATER 1)
      list(APPEND environment GTEST_TOTAL_SHARDS=${count} GTEST_SHARD_INDEX=${number})
      set_tests_properties(${half}${suffix} PROPERTIES COST 1000)
    endif()
    set_tests_properties(${half}${suffix} PROPERTIES TIMEOUT ${HALF_TIMEOUT} LABELS "${HALF_LABELS}"
                         ENVIRONMENT "${environment}")
    math(EXPR number "${number} + 1")
  endforeach()
endfunction()

function(gapcheck_add_twin_test target kind test)
  get_property(arguments GLOBAL PROPERTY gapcheck_arguments_${test}_${kind})
  # Random tests take fewer samples, and those of slow_tests.txt are left to the plain programs.
  file(STRINGS ${PROJECT_SOURCE_DIR}/tests/slow_tests.txt slow REGEX "^[^#]")
  list(JOIN slow ":" slow)
  set(environment ASAN_OPTIONS=detect_leaks=1 UBSAN_OPTIONS=print_stacktrace=1 TSAN_OPTIONS=halt_on_error=1
      GAPCHECK_STRESS_PAIRS=1000 GAPCHECK_RANDOM_FIELDS=100000 "GTEST_FILTER=-${slow}"
      GAPCHECK_PROGRAM=$<TARGET_FILE:gapcheck>_${kind} CHECK_C_PROGRAM=$<TARGET_FILE:check-c>_${kind})
  gapcheck_add_halves(${target} ${test} _${kind} TIMEOUT 900 LABELS ${kind}
                      ENVIRONMENT ${environment} ARGUMENTS ${arguments})
endfunction()

# `out`: the libraries `links` with the names of those replaced that have a twin.
function(gapcheck_twin_links kind out links)
  get_property(twins GLOBAL PROPERTY gapcheck_twins_${kind})
  list(JOIN twins "|" twins)
  string(REGEX REPLACE "(^|[:;])(${twins})($|[>;])" "\\1\\2_${kind}\\3" links "${links}")
  # Neighbours share a separator, and the first pass leaves every other one.
  string(REGEX REPLACE "(^|[:;])(${twins})($|[>;])" "\\1\\2_${kind}\\3" links "${links}")
  set(${out} "${links}" PARENT_SCOPE)
endfunction()

function(gapcheck_twin_library target kind)
  set(twin ${target}_${kind})
  get_target_property(sources ${target} SOURCES)
  add_library(${twin} STATIC EXCLUDE_FROM_ALL ${sources})
  foreach(property COMPILE_DEFINITIONS COMPILE_FEATURES INCLUDE_DIRECTORIES INTERFACE_INCLUDE_DIRECTORIES
                   INTERFACE_COMPILE_FEATURES LINK_LIBRARIES INTERFACE_LINK_LIBRARIES MANUALLY_ADDED_DEPENDENCIES)
    get_target_property(value ${target} ${property})
    if(NOT value)
      continue()
    endif()
    if(property MATCHES "LINK_LIBRARIES$")
      gapcheck_twin_links(${kind} value "${value}")
    endif()
    if(property STREQUAL MANUALLY_ADDED_DEPENDENCIES)
      add_dependencies(${twin} ${value})
    else()
      set_property(TARGET ${twin} PROPERTY ${property} "${value}")
    endif()
  endforeach()
  set_target_properties(${twin} PROPERTIES CXX_COMPILER_LAUNCHER "${GAPCHECK_TWIN_LAUNCHER}")
  # The plain library has told its warnings.
  target_compile_options(${twin} PRIVATE ${GAPCHECK_TWIN_${kind}} -w)
  if(target IN_LIST GAPCHECK_LIGHT_TWINS)
    target_compile_options(${twin} PRIVATE -O0)
  endif()
endfunction()

# All libraries of the project that a target links, directly or not.
function(gapcheck_libraries_below target out)
  set(found "")
  set(open ${target})
  while(open)
    list(POP_FRONT open next)
    get_target_property(links ${next} LINK_LIBRARIES)
    foreach(link ${links})
      if(TARGET ${link} AND link MATCHES "^gapcheck_" AND NOT link IN_LIST found AND NOT link STREQUAL gapcheck_flags)
        list(APPEND found ${link})
        list(APPEND open ${link})
      endif()
    endforeach()
  endwhile()
  set(${out} "${found}" PARENT_SCOPE)
endfunction()

# gapcheck_link_first(TARGET LIBRARY…): the static libraries among these come first and as a whole. Of inline functions that
# both they and the program's own objects hold, the linker takes the first, and that must be the one compiled like the library.
function(gapcheck_link_first target)
  set(files "")
  foreach(library ${ARGN})
    get_target_property(type ${library} TYPE)
    if(type STREQUAL "STATIC_LIBRARY")
      list(APPEND files $<TARGET_FILE:${library}>)
      add_dependencies(${target} ${library})
    endif()
  endforeach()
  if(files)
    target_link_options(${target} PRIVATE -Wl,--whole-archive ${files} -Wl,--no-whole-archive)
    set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${files})
  endif()
endfunction()

function(gapcheck_twin_program target kind)
  set(twin ${target}_${kind})
  if(TARGET ${twin})  # several tests run it
    return()
  endif()
  add_executable(${twin} EXCLUDE_FROM_ALL $<TARGET_OBJECTS:${target}>)
  set_target_properties(${twin} PROPERTIES LINKER_LANGUAGE CXX CXX_LINKER_LAUNCHER "${GAPCHECK_TWIN_LAUNCHER}")
  string(REGEX MATCH "-fsanitize=[a-z,]+" sanitizer "${GAPCHECK_TWIN_${kind}}")
  target_link_options(${twin} PRIVATE ${sanitizer})
  # The tests start these large programs a thousand times: without addresses to relocate that takes three quarters of
  # the time.
  if(kind STREQUAL sanitized)
    target_link_options(${twin} PRIVATE -no-pie)
  endif()
  if(GAPCHECK_TWIN_COMPILER AND GAPCHECK_TWIN_LINKER)
    target_link_options(${twin} PRIVATE -fuse-ld=lld)
  endif()
  gapcheck_libraries_below(${target} libraries)
  get_property(twins GLOBAL PROPERTY gapcheck_twins_${kind})
  set(twins_below "")
  foreach(library ${libraries})
    if(library IN_LIST twins)
      list(APPEND twins_below ${library}_${kind})
    endif()
  endforeach()
  gapcheck_link_first(${twin} ${twins_below})
  get_target_property(links ${target} LINK_LIBRARIES)
  gapcheck_twin_links(${kind} links "${links}")
  set_property(TARGET ${twin} PROPERTY LINK_LIBRARIES "${links}")
  add_dependencies(gapcheck_twins_of_${kind} ${twin})
endfunction()

if(GAPCHECK_TWINS)
  add_custom_target(gapcheck_twins_of_sanitized)
  add_custom_target(gapcheck_twins_of_threads)
endif()
