// Audits a deck with the installed library: prints the number of nodes that penetrate, the first one with its depth,
// the number of warnings and what is found in the corrected deck.
#include <cstdio>
#include <gapcheck/gapcheck.hpp>

// The package leads to no other library's headers, and none of them comes with its own.
#if __has_include(<Eigen/Core>)
#error "the package brings the folder of Eigen"
#endif
#if __has_include(<gapcheck/audit/audit.hpp>) || __has_include(<audit/audit.hpp>)
#error "the package brings headers of the rooms"
#endif
#if defined(EIGEN_WORLD_VERSION) || defined(FMT_VERSION) || defined(TBB_VERSION_MAJOR) || defined(CGAL_VERSION)
#error "a public header includes another library"
#endif

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const auto report = gapcheck::api::audit_deck(argv[1]);
  if (!report) return 2;
  const auto& penetrations = report.value().penetrations;
  std::printf("%zu", penetrations.size());
  if (penetrations.size() > 0)
    std::printf(" %lld %.9g", static_cast<long long>(penetrations.node[0]), penetrations.depth[0]);
  std::printf(" %zu", report.value().totals.warnings);
  const auto fix = gapcheck::api::fix_deck(argv[1]);
  if (!fix || fix.value().changed.empty()) return 2;
  const auto fixed = gapcheck::api::audit_text(fix.value().changed[0].text, "fixed.k");
  if (!fixed) return 2;
  std::printf(" %zu\n", fixed.value().penetrations.size());
  return 0;
}
