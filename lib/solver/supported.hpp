#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "keyword/deck.hpp"
#include "model/model.hpp"

namespace gapcheck::solver {

/// A part of the deck that influences a calculation and that the solver does not calculate.
struct Unsupported {
  std::string keyword;  ///< as written, without `*`
  std::string file;
  std::uint32_t line = 0;
  std::string why;
};

/// All of them by file (in the order of reading) and line: keywords that supported_keywords.txt does not name as
/// calculated or harmless, materials of parts with elements, contacts, rigid walls and settings that are not
/// calculated. Empty: the deck is calculated as it is, as far as formulations of elements go, of which
/// build_structure() speaks.
[[nodiscard]] std::vector<Unsupported> unsupported(const keyword::Deck& deck, const model::Model& model);

}  // namespace gapcheck::solver
