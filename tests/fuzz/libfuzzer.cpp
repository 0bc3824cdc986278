// Gives libFuzzer the one target that is linked with this file.
#include <cstddef>
#include <cstdint>

#include "base/parallel.hpp"
#include "fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const gapcheck::JobLimit one_thread(1);
  gapcheck::fuzz::targets().front().run({reinterpret_cast<const char*>(data), size});
  return 0;
}
