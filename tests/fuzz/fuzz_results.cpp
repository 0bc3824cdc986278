// Any bytes as each of the text files of a run.
#include <cmath>

#include "fuzz.hpp"
#include "results/curves/contact_forces.hpp"
#include "results/curves/glstat.hpp"
#include "results/curves/matsum.hpp"
#include "results/curves/nodout.hpp"
#include "results/curves/run_results.hpp"

namespace gapcheck::fuzz::results_target {
namespace {

template <class States>
void times_are_numbers(const States& states) {
  for (const auto& state : states) require(!std::isnan(state.time));
}

}  // namespace

GAPCHECK_FUZZ_TARGET(results) {
  Diagnostics diagnostics;
  times_are_numbers(results::read_glstat(input, "glstat", diagnostics));
  times_are_numbers(results::read_rcforc(input, "rcforc", diagnostics).states);
  times_are_numbers(results::read_sleout(input, "sleout", diagnostics).states);
  times_are_numbers(results::read_matsum(input, "matsum", diagnostics).states);
  times_are_numbers(results::read_nodout(input, "nodout", diagnostics).states);
  times_are_numbers(results::read_secforc(input, "secforc", diagnostics).states);
  times_are_numbers(results::read_spcforc(input, "spcforc", diagnostics).states);
  times_are_numbers(results::read_bndout(input, "bndout", diagnostics).states);
  times_are_numbers(results::read_rwforc(input, "rwforc", diagnostics).states);
  times_are_numbers(results::read_rbdout(input, "rbdout", diagnostics).states);
  times_are_numbers(results::read_swforc(input, "swforc", diagnostics).states);
  times_are_numbers(results::read_elout(input, "elout", diagnostics).states);
  static_cast<void>(diagnostics.sorted());
}

}  // namespace gapcheck::fuzz::results_target
