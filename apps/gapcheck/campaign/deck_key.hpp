#pragma once
#include <string>

#include "audit/audit.hpp"
#include "campaign/content_hash.hpp"
#include "common/deck_files.hpp"

namespace gapcheck::app {

/// What the result of an audit depends on: the bytes and paths of the deck and of all its includes, the options and the
/// baseline. Equal keys: an audit would find the same. The day counts only where a demand to leave findings out might
/// end on it. `baseline`: path of the file to compare with; empty: none. `others`: further texts that the result
/// depends on.
[[nodiscard]] ContentHash key_of(const std::string& deck, const audit::AuditOptions& options,
                                 const std::string& baseline, const std::vector<std::string>& others, DeckFiles& files);

}  // namespace gapcheck::app
