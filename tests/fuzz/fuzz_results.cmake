# The readers of a run's text files: gapcheck_fuzz_results_replay replays kept files and fixed mutations of them,
# gapcheck_fuzz_results (GAPCHECK_FUZZ=ON, clang) is the same function under libFuzzer.
if(NOT TARGET gapcheck_fuzz_results_replay)
  set(here ${CMAKE_CURRENT_LIST_DIR})
  add_executable(gapcheck_fuzz_results_replay ${here}/fuzz_results.cpp ${here}/replay.cpp)
  target_link_libraries(gapcheck_fuzz_results_replay PRIVATE gapcheck_flags gapcheck_results)
  add_test(NAME fuzz_results_replay
    COMMAND gapcheck_fuzz_results_replay --mutations 3000 ${here}/corpus/run.glstat ${here}/corpus/run.rcforc
            ${here}/corpus/run.sleout ${here}/corpus/run.matsum ${here}/corpus/run.nodout)
  set_tests_properties(fuzz_results_replay PROPERTIES TIMEOUT 900)
  gapcheck_twin_test(gapcheck_fuzz_results_replay sanitized fuzz_results_replay --mutations 3000
                     ${here}/corpus/run.glstat ${here}/corpus/run.rcforc ${here}/corpus/run.sleout
                     ${here}/corpus/run.matsum ${here}/corpus/run.nodout)
endif()

if(GAPCHECK_FUZZ AND CMAKE_CXX_COMPILER_ID MATCHES "Clang" AND NOT TARGET gapcheck_fuzz_results)
  add_executable(gapcheck_fuzz_results ${CMAKE_CURRENT_LIST_DIR}/fuzz_results.cpp)
  target_link_libraries(gapcheck_fuzz_results PRIVATE gapcheck_flags gapcheck_results)
  target_link_options(gapcheck_fuzz_results PRIVATE -fsanitize=fuzzer)
endif()
