#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "base/diagnostic.hpp"
#include "model/entity/part.hpp"

namespace gapcheck::model {

struct Model;

/// A keyword of the deck that is none of the manual's: misspelt, or of a solver that is newer than the list.
struct UnknownKeyword {
  std::string name;         ///< in capitals, without `*`
  Place place;              ///< the first one
  std::uint64_t count = 0;  ///< how many the deck has
  bool read = false;        ///< as another form of a keyword that is read
};

/// Most names that a model keeps, and most that are compared with all known ones; a file with more of them is not a
/// deck.
inline constexpr std::size_t most_unknown_keywords = 1000, unknown_keywords_looked_up = 100;

/// The known keyword that an unknown one is nearest to (keyword::nearest_keyword); contacts by their own table. Empty:
/// none.
[[nodiscard]] std::string nearest_keyword(const UnknownKeyword& unknown);

/// "*ELEMNT_SHELL is not a known keyword, so what it defines is not read; did you mean *ELEMENT_SHELL?"
[[nodiscard]] std::string describe(const UnknownKeyword& unknown, std::string_view nearest);

/// An error if contacts, mesh, sets, includes or the like may be lost, by the nearest keyword or, without one, by the
/// name itself; otherwise a warning. A known name with an option that is near no other may be of a newer solver.
[[nodiscard]] Severity severity(const UnknownKeyword& unknown, std::string_view nearest);

/// A diagnostic for each unknown keyword, for commands that do not run the audit's rules.
void report_unknown_keywords(const Model& model, Diagnostics& diagnostics);

}  // namespace gapcheck::model
