// Any bytes as a baseline: what is read is written and read back as it was, and the comparison counts every finding.
#include "fuzz.hpp"
#include "report/baseline/baseline.hpp"
#include "samples.hpp"

namespace gapcheck::fuzz::baseline_target {

GAPCHECK_FUZZ_TARGET(baseline) {
  const auto known = report::read_baseline(input, "baseline");
  if (!known) {
    require(!known.error().message.empty());
    return;
  }
  const std::string text = report::baseline_text(known.value());
  const auto again = report::read_baseline(text, "again");
  require(again.ok() && report::baseline_text(again.value()) == text);
  const auto compared = report::compare_with_baseline(sample_audit(), known.value(), [](const auto&) { return true; });
  require(compared.states.size() == report::known_findings(sample_audit()).size());
  require(compared.gone.size() <= known.value().size());
  static_cast<void>(report::summary(compared));
  for (const KnownFinding& finding : compared.gone) static_cast<void>(report::describe(finding));
}

}  // namespace gapcheck::fuzz::baseline_target
