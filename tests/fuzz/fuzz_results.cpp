// Any bytes as each of the text files of a run.
#include <cmath>

#include "fuzz.hpp"
#include "results/curves/contact_forces.hpp"
#include "results/curves/glstat.hpp"
#include "results/curves/matsum.hpp"
#include "results/curves/nodout.hpp"

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
  static_cast<void>(diagnostics.sorted());
}

}  // namespace gapcheck::fuzz::results_target
