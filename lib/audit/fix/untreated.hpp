#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "records/fix.hpp"

namespace gapcheck::audit {

/// Penetrations of one contact that a correction leaves, because it moves nodes out of segments only.
struct Untreated {
  bool by_segments = false;  ///< SOFT = 2 or mortar: none of the contact's penetrations are corrected
  bool mortar = false;
  FixContact::State segments;  ///< of these contacts
  std::uint64_t edges = 0;     ///< pairs of edges in types 26
};

/// Such penetrations at coordinates (n x 3, beside the model's nodes), beside Model::contacts; empty if the model has
/// no contact that can have them. The model has its own coordinates again at the end.
[[nodiscard]] std::vector<Untreated> find_untreated(model::Model& model, std::vector<Vector> x);

/// "12 penetrations of segments are not corrected: …"; empty if nothing is left.
[[nodiscard]] std::string words(const Untreated& untreated);

}  // namespace gapcheck::audit
