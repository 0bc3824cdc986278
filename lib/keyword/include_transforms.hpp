#pragma once
#include <cstdint>
#include <vector>

#include "keyword/card.hpp"

namespace gapcheck::keyword {

/// What one include says about transformation: the cards of *INCLUDE_TRANSFORM behind the file name.
struct IncludeTransform {
  Transform own;
  std::int64_t transformation = 0;  ///< TRANID; 0 = none
  std::uint32_t line = 0;           ///< of TRANID
};
IncludeTransform read_include_transform(CardReader& reader);
/// *INCLUDE_AUTO_OFFSET_USER: offsets of nodes and elements.
IncludeTransform read_include_offsets(CardReader& reader);

/// The transformations of included files. Their placements wait until all *DEFINE_TRANSFORMATION are read.
class IncludeTransforms {
 public:
  /// `order`: position of a *DEFINE_TRANSFORMATION among the deck's blocks.
  void add_definition(std::uint32_t order) { definitions_.push_back(order); }
  /// Adds to `all` the transformation of a file that `block` includes, itself in a file transformed by `parent`.
  TransformIndex add(std::vector<Transform>& all, TransformIndex parent, const IncludeTransform& include,
                     const Block& block, const std::string& path, Diagnostics& diagnostics);
  /// The placements of `all`. A point x of the included file lies at Mp (fp (Mo fo x + so)) + sp, with the placement o
  /// of the include itself and p of what encloses it.
  void resolve(std::vector<Transform>& all, const Deck& deck, Diagnostics& diagnostics) const;

 private:
  struct Pending {
    TransformIndex own, parent;
    std::int64_t transformation = 0;
    FileIndex file;
    std::uint32_t line = 0;
  };
  std::vector<Pending> pending_;            ///< enclosing ones first
  std::vector<std::uint32_t> definitions_;  ///< positions of *DEFINE_TRANSFORMATION blocks
};

}  // namespace gapcheck::keyword
