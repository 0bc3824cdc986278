// Any bytes as a log of the solver. Its records point to contacts that exist.
#include "fuzz.hpp"
#include "results/log/log_collector.hpp"
#include "results/log/log_reader.hpp"
#include "results/log/message_kinds.hpp"
#include "results/log/write_messag.hpp"

namespace gapcheck::fuzz::log_target {

GAPCHECK_FUZZ_TARGET(log) {
  Diagnostics diagnostics;
  static const results::MessageKinds kinds;  // reading the table takes longer than reading a small log
  results::LogCollector collector(diagnostics);
  static_cast<void>(results::read_log_file(input, {"messag", false}, kinds, collector));
  const Report report = collector.finish({});
  for (const auto& record : report.penetrations) require(record.contact < report.contacts.size());
  for (const auto& record : report.tie_failures) require(record.contact < report.contacts.size());
  for (const auto& step : report.run->surface_timesteps) require(step.contact < report.contacts.size());
  static_cast<void>(results::write_messag(report));
  static_cast<void>(diagnostics.sorted());
}

}  // namespace gapcheck::fuzz::log_target
