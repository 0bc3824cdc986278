#pragma once
#include "contact/tie/ties.hpp"
#include "model/model.hpp"
#include "records/tie_failure.hpp"

namespace gapcheck::contact {

/// The record of a node that did not tie, or tied with a separation; only for nodes with a reason.
[[nodiscard]] TieFailure record_tie(const JudgedNode& judged, const model::Model& model);

}  // namespace gapcheck::contact
