#pragma once
#include <vector>

#include "model/model.hpp"
#include "solver/structure/structure.hpp"

namespace gapcheck::solver {

/// Where the elements of the model are in the structure, by kind and position in the model; no_position: nowhere, as
/// those of rigid parts.
struct ElementPlaces {
  std::vector<std::uint32_t> shells, solids, beams;

  ElementPlaces(const model::Model& model, const Structure& structure)
      : shells(places(model.mesh.shells.size(), structure.shells)),
        solids(places(model.mesh.solids.size(), structure.solids)),
        beams(places(model.mesh.beams.size(), structure.beams)) {}

 private:
  template <class Elements>
  static std::vector<std::uint32_t> places(std::size_t count, const Elements& elements) {
    std::vector<std::uint32_t> list(count, no_position);
    for (std::uint32_t i = 0; i < elements.size(); ++i) list[elements.origin(i)] = i;
    return list;
  }
};

}  // namespace gapcheck::solver
