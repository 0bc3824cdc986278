#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "records/penetration.hpp"
#include "records/tie_failure.hpp"

namespace gapcheck {

struct Finding;

/// What a comment of the deck or a settings file leaves out of the report, and why.
struct IgnoreSource {
  std::string file;
  std::uint32_t line = 0;
  std::string reason;         ///< the text after "because"; empty: nothing
  bool in_deck = true;        ///< a comment of the deck; false: a settings file
  std::uint64_t matched = 0;  ///< findings that it leaves out, above 0; of several sources the first one counts
};

/// Findings that were left out on purpose. They count nowhere but stay visible. Each list in the report's order.
struct Ignored {
  std::vector<Penetration> penetrations;
  std::vector<TieFailure> tie_failures;
  std::vector<Finding> findings;
  /// For the penetrations, ties and other findings, in that order: the position in `sources` of what left it out.
  std::vector<std::uint32_t> source;
  std::vector<IgnoreSource> sources;
  [[nodiscard]] std::size_t size() const { return source.size(); }
};

}  // namespace gapcheck
