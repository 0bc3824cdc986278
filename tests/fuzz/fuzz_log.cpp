// The function under test: any bytes as a log of the solver. It must neither crash nor hang nor need more memory than a
// small multiple of the input, and its records must point to contacts that exist.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "results/log/solver_log.hpp"
#include "results/log/write_messag.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  gapcheck::Diagnostics diagnostics;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const gapcheck::Report report = gapcheck::results::read_solver_log_text(text, "messag", {}, diagnostics);
  for (const auto& record : report.penetrations)
    if (record.contact >= report.contacts.size()) std::abort();
  for (const auto& record : report.tie_failures)
    if (record.contact >= report.contacts.size()) std::abort();
  for (const auto& step : report.run->surface_timesteps)
    if (step.contact >= report.contacts.size()) std::abort();
  static_cast<void>(gapcheck::results::write_messag(report));
  static_cast<void>(diagnostics.sorted());
  return 0;
}
