#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "keyword/deck.hpp"
#include "model/model.hpp"

namespace gapcheck::solver {

/// Something in the deck that affects a run but that the solver does not calculate.
struct Unsupported {
  std::string keyword;  ///< as written, without `*`
  std::string file;
  std::uint32_t line = 0;
  std::string why;
};

/// All of them by file (in the order of reading) and line: keywords that supported_keywords.txt does not list as
/// calculated or harmless, and materials of parts with elements, contacts, rigid walls and settings that are not
/// calculated. Empty: the deck is calculated as given, except for element formulations, which build_structure()
/// reports.
[[nodiscard]] std::vector<Unsupported> unsupported(const keyword::Deck& deck, const model::Model& model);

}  // namespace gapcheck::solver
