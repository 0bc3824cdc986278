# Two small databases and mutations of them; gapcheck_fuzz_d3plot is the same function under libFuzzer.
if(NOT TARGET gapcheck_fuzz_replay_d3plot)
  set(corpus ${CMAKE_CURRENT_LIST_DIR}/corpus)
  add_executable(gapcheck_fuzz_replay_d3plot fuzz_d3plot.cpp replay.cpp)
  target_link_libraries(gapcheck_fuzz_replay_d3plot PRIVATE gapcheck_flags gapcheck_results)
  add_test(NAME fuzz_replay_d3plot COMMAND gapcheck_fuzz_replay_d3plot --mutations 20000
           ${corpus}/single.d3plot ${corpus}/double.d3plot)
  set_tests_properties(fuzz_replay_d3plot PROPERTIES TIMEOUT 900)
  gapcheck_twin_test(gapcheck_fuzz_replay_d3plot sanitized fuzz_replay_d3plot --mutations 20000 ${corpus}/single.d3plot
                     ${corpus}/double.d3plot)
endif()

if(GAPCHECK_FUZZ AND CMAKE_CXX_COMPILER_ID MATCHES "Clang" AND NOT TARGET gapcheck_fuzz_d3plot)
  add_executable(gapcheck_fuzz_d3plot fuzz_d3plot.cpp)
  target_link_libraries(gapcheck_fuzz_d3plot PRIVATE gapcheck_flags gapcheck_results)
  target_link_options(gapcheck_fuzz_d3plot PRIVATE -fsanitize=fuzzer)
endif()
