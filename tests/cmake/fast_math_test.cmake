# Flags that break the proofs of the decisions are refused, whatever variable they come in: by cmake/fast_math.cmake when
# the project is configured, and by lib/geometry/arithmetic.hpp when it is compiled.
# cmake -DROOT=source -DCOMPILER=c++ -DSCRATCH=folder -P fast_math_test.cmake
cmake_minimum_required(VERSION 3.25)
include(${ROOT}/cmake/fast_math.cmake)

# The child of this script: stops with an error if the flags it was given are refused.
if(CHILD)
  gapcheck_refuse_fast_math()
  return()
endif()

set(failures 0)
# `code` and `output` are those of the last command.
macro(expect_refused what)
  if(code EQUAL 0 OR NOT output MATCHES "gapcheck[ \n]+decides[ \n]+exactly")
    message(SEND_ERROR "not refused, or for another reason (exit code ${code}): ${what}\n${output}")
    math(EXPR failures "${failures} + 1")
  endif()
endmacro()
macro(expect_accepted what)
  if(NOT code EQUAL 0)
    message(SEND_ERROR "refused (exit code ${code}): ${what}\n${output}")
    math(EXPR failures "${failures} + 1")
  endif()
endmacro()

# Runs the check with a variable of the environment and a setting of cmake.
function(configured environment arguments)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env ${environment} ${CMAKE_COMMAND} ${arguments} -DCHILD=ON -DROOT=${ROOT}
                          -P ${CMAKE_CURRENT_LIST_FILE}
                  RESULT_VARIABLE code OUTPUT_VARIABLE ignored ERROR_VARIABLE text)
  set(code ${code} PARENT_SCOPE)
  set(output "${text}" PARENT_SCOPE)
endfunction()

foreach(setting
    "CMAKE_CXX_FLAGS=-ffast-math"
    "CMAKE_CXX_FLAGS=-O3 -ffast-math -g"
    "CMAKE_CXX_FLAGS=-Ofast"
    "CMAKE_CXX_FLAGS=-funsafe-math-optimizations"
    "CMAKE_CXX_FLAGS=-g -ffinite-math-only"
    "CMAKE_CXX_FLAGS=-fassociative-math -fno-signed-zeros"
    "CMAKE_CXX_FLAGS=-mrecip=all"
    "CMAKE_CXX_FLAGS=-mfpmath=387"
    "CMAKE_CXX_FLAGS=-ffp-model=fast"
    "CMAKE_CXX_FLAGS_RELEASE=-Ofast -DNDEBUG"
    "CMAKE_CXX_FLAGS_DEBUG=-ffast-math"
    "CMAKE_CXX_FLAGS_RELWITHDEBINFO=-O2 -g -freciprocal-math"
    "CMAKE_CXX_FLAGS_MINSIZEREL=-Os -ffast-math"
    "CMAKE_CXX_FLAGS_MY_OWN=-Ofast"
    "CMAKE_CXX_FLAGS_INIT=-ffast-math"
    "CMAKE_CXX_COMPILER_ARG1= -ffast-math")
  configured("" "-D${setting}")
  expect_refused("${setting}")
endforeach()
configured("CXXFLAGS=-O2 -ffast-math" "")
expect_refused("CXXFLAGS=-ffast-math in the environment")

foreach(setting
    "CMAKE_CXX_FLAGS=-O3 -march=x86-64-v3 -g"
    "CMAKE_CXX_FLAGS=-fno-fast-math"
    "CMAKE_CXX_FLAGS=-DNAME=Ofast -I/opt/-Ofast-headers"
    "CMAKE_CXX_FLAGS=-ffp-contract=fast -mfma"
    "CMAKE_CXX_FLAGS_RELEASE=-O3 -DNDEBUG")
  configured("CXXFLAGS=-O2" "-D${setting}")
  expect_accepted("${setting}")
endforeach()

# The whole project, so that the check is not only there but asked.
execute_process(COMMAND ${CMAKE_COMMAND} -S ${ROOT} -B ${SCRATCH}/refused -DCMAKE_CXX_COMPILER=${COMPILER}
                        -DCMAKE_CXX_FLAGS_DEBUG=-Ofast
                RESULT_VARIABLE code OUTPUT_VARIABLE ignored ERROR_VARIABLE output)
expect_refused("-Ofast in the whole project")

# Compiles an empty program behind the header with a flag.
function(compiled flag)
  file(WRITE ${SCRATCH}/arithmetic.cpp "#include \"geometry/arithmetic.hpp\"\nint main() {}\n")
  execute_process(COMMAND ${COMPILER} -std=c++20 -fsyntax-only -I${ROOT}/lib ${flag} ${SCRATCH}/arithmetic.cpp
                  RESULT_VARIABLE code ERROR_VARIABLE text)
  set(code ${code} PARENT_SCOPE)
  set(output "${text}" PARENT_SCOPE)
endfunction()
foreach(flag -ffast-math -Ofast -ffinite-math-only)
  compiled("${flag}")
  expect_refused("${flag} by the compiler")
endforeach()
foreach(flag -O2 -O3 -ffp-contract=fast)
  compiled("${flag}")
  expect_accepted("${flag} by the compiler")
endforeach()

if(failures GREATER 0)
  message(FATAL_ERROR "${failures} of the expectations failed")
endif()
