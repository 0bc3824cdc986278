// Any bytes as a table of message kinds; the log behind a line of equals signs is read with it.
#include "fuzz.hpp"
#include "results/log/log_collector.hpp"
#include "results/log/log_reader.hpp"
#include "results/log/message_kinds.hpp"
#include "results/log/write_messag.hpp"
#include "samples.hpp"

namespace gapcheck::fuzz::kinds_target {

GAPCHECK_FUZZ_TARGET(kinds) {
  static const std::string sample = results::write_messag(sample_audit());
  const auto texts = parts(input);
  Diagnostics diagnostics;
  results::MessageKinds kinds;
  kinds.add(texts.front(), "kinds.txt", diagnostics);
  results::LogCollector collector(diagnostics);
  const std::string_view log = texts.size() > 1 ? texts[1] : std::string_view(sample);
  static_cast<void>(results::read_log_file(log, {"messag", false}, kinds, collector));
  const Report report = collector.finish({});
  for (const auto& record : report.penetrations) require(record.contact < report.contacts.size());
  for (const auto& record : report.tie_failures) require(record.contact < report.contacts.size());
  static_cast<void>(diagnostics.sorted());
}

}  // namespace gapcheck::fuzz::kinds_target
