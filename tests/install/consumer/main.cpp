// Audits a deck with the libraries: prints the number of nodes that penetrate, and the first one.
#include <cstdio>

#include "audit/audit.hpp"
#include "report/write/writers.hpp"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  gapcheck::Diagnostics diagnostics;
  const auto report = gapcheck::audit::audit_deck(argv[1], {}, diagnostics);
  if (!report) return 2;
  const auto& records = report.value().penetrations;
  std::printf("%zu", records.size());
  if (!records.empty()) std::printf(" %lld %.9g", static_cast<long long>(records[0].node), records[0].depth);
  std::printf(" %zu\n", gapcheck::report::totals(report.value()).warnings);
  return 0;
}
