// The functions under test: any bytes as each of the text files of a run. They must neither crash nor hang nor need
// more memory than a small multiple of the input.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "results/curves/contact_forces.hpp"
#include "results/curves/glstat.hpp"
#include "results/curves/matsum.hpp"
#include "results/curves/nodout.hpp"

namespace {

template <class States>
void check(const States& states) {
  for (const auto& state : states)
    if (std::isnan(state.time)) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gapcheck;
  Diagnostics diagnostics;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  check(results::read_glstat(text, "glstat", diagnostics));
  check(results::read_rcforc(text, "rcforc", diagnostics).states);
  check(results::read_sleout(text, "sleout", diagnostics).states);
  check(results::read_matsum(text, "matsum", diagnostics).states);
  check(results::read_nodout(text, "nodout", diagnostics).states);
  static_cast<void>(diagnostics.sorted());
  return 0;
}
