#pragma once
#include <functional>
#include <string>
#include <string_view>

#include "base/result.hpp"
#include "records/report.hpp"

namespace gapcheck::report {

/// A report on a deck as bytes, for the same version of the program on the same kind of machine. Everything that
/// writers print is in them, to the last bit; not the picture (Report::scene), the mesh and the members of findings,
/// which belong to files that are written when the deck is audited.
[[nodiscard]] std::string archived(const Report& report);

/// The consequence of a rule (RuleIdentity) by its id, in static storage; empty: not known.
using ConsequenceOf = std::function<std::string_view(std::string_view id)>;

/// The report of such bytes. Error: they are not those of a report, whatever else they are.
[[nodiscard]] Result<Report> unarchived(std::string_view bytes, const ConsequenceOf& consequence_of);

}  // namespace gapcheck::report
