#pragma once
#include <vector>

#include "keyword/deck.hpp"
#include "model/model.hpp"
#include "records/report.hpp"

namespace gapcheck::audit {

/// Adds to messages about nodes and elements that *INCLUDE_AUTO_OFFSET shifted which ids these have in their files.
void name_ids_in_files(const keyword::Deck& deck, const model::Model& model, std::vector<Finding>& findings);

}  // namespace gapcheck::audit
