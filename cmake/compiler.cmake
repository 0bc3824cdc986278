# Flags as INTERFACE targets: gapcheck_flags for all of our own code.
add_library(gapcheck_flags INTERFACE)
target_include_directories(gapcheck_flags INTERFACE ${PROJECT_SOURCE_DIR}/lib)
target_compile_options(gapcheck_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Wcast-align)
# g++ 12 warns about overlapping copies inside its own std::string (GCC bug 105329).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(gapcheck_flags INTERFACE -Wno-restrict)
endif()
if(GAPCHECK_WERROR)
  target_compile_options(gapcheck_flags INTERFACE -Werror)
endif()
# The same bits from every compiler, and of audits on every machine (docs/machines.md). The proofs also hold with fused operations, as
# GAPCHECK_CONTRACT shows. All rooms use the same flags: Eigen aligns memory by -mfma.
if(GAPCHECK_CONTRACT)
  include(CheckCXXSourceRuns)
  set(CMAKE_REQUIRED_FLAGS -mfma)
  check_cxx_source_runs("#include <immintrin.h>
    int main() { return _mm_cvtsd_f64(_mm_fmadd_sd(_mm_set_sd(2), _mm_set_sd(3), _mm_set_sd(4))) == 10 ? 0 : 1; }"
    GAPCHECK_HAS_FMA)
  unset(CMAKE_REQUIRED_FLAGS)
  target_compile_options(gapcheck_flags INTERFACE -ffp-contract=fast $<$<BOOL:${GAPCHECK_HAS_FMA}>:-mfma>)
else()
  target_compile_options(gapcheck_flags INTERFACE -ffp-contract=off)
endif()
# On arm64 a plain char has no sign, unlike on x86-64.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch64|arm64|ARM64)$")
  target_compile_options(gapcheck_flags INTERFACE -fsigned-char)
endif()
# g++ aligns the stack of Windows to 16 bytes and yet moves wider vectors as if it were aligned to their size (GCC bug
# 54412); and a room has more sections than usual objects of Windows hold.
if(MINGW)
  target_compile_options(gapcheck_flags INTERFACE -Wa,-muse-unaligned-vector-move -Wa,-mbig-obj
                         -include base/system/windows/plain_names.hpp)
endif()
if(GAPCHECK_SANITIZE)
  # Instrumented std::variant and std::regex look uninitialised to g++ 12.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(gapcheck_flags INTERFACE -Wno-maybe-uninitialized)
  endif()
  target_compile_options(gapcheck_flags INTERFACE -fsanitize=${GAPCHECK_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(gapcheck_flags INTERFACE -fsanitize=${GAPCHECK_SANITIZE})
endif()
# libFuzzer finds its way by the edges that the libraries report.
if(GAPCHECK_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    message(FATAL_ERROR "GAPCHECK_FUZZ needs clang: cmake --preset fuzz")
  endif()
  set(ignorelist ${PROJECT_SOURCE_DIR}/tests/fuzz/ignorelist.txt)
  target_compile_options(gapcheck_flags INTERFACE -fsanitize=fuzzer-no-link -fno-sanitize=null,object-size,vptr
                         -fsanitize-coverage-ignorelist=${ignorelist})
endif()

find_program(GAPCHECK_CCACHE ccache)
if(GAPCHECK_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${GAPCHECK_CCACHE})
endif()
