#pragma once
#include <cstddef>

#include "base/diagnostic.hpp"
#include "keyword/deck.hpp"
#include "model/model.hpp"
#include "records/report.hpp"

namespace gapcheck::audit {

/// Removes findings that follow from fields that could not be read, which are errors of their own: those in the same
/// block (nodes, elements and sets: in the same line), those on thickness of parts whose *PART or *SECTION has such a
/// field, and empty surfaces whose set has one. Returns how many.
std::size_t leave_out_follow_ups(const keyword::Deck& deck, const model::Model& model, const Diagnostics& diagnostics,
                                 Report& report);

}  // namespace gapcheck::audit
