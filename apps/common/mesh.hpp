#pragma once
#include <optional>
#include <string>

#include "base/diagnostic.hpp"
#include "base/result.hpp"
#include "keyword/deck.hpp"
#include "model/model.hpp"
#include "records/report.hpp"
#include "report/export/exports.hpp"
#include "results/d3plot/mesh_source.hpp"

namespace gapcheck::app {

/// Coordinates and parts of a deck's nodes. A node of several elements belongs to the part of the first one, in the
/// order shells, solids, thick shells, beams, discrete elements, masses, particles. Errors: the deck cannot be read at
/// all; others are in `diagnostics`. The whole model goes to `model` if that is not null.
Result<results::MeshSource> read_deck_mesh(const std::string& path, const keyword::ReadOptions& options,
                                           Diagnostics& diagnostics, std::optional<model::Model>* model = nullptr);

/// Where a mesh may be: empty names are not given.
struct MeshPlaces {
  std::string deck;
  keyword::ReadOptions deck_options = {};
  std::string d3plot, beside;  ///< of results::find_mesh()
};

/// The mesh of the deck, else as results::find_mesh() finds it. Errors: a named file cannot be read. `model`: as above.
Result<results::MeshSource> find_mesh(const MeshPlaces& places, Diagnostics& diagnostics,
                                      std::optional<model::Model>* model = nullptr);

/// Lives as long as the mesh.
[[nodiscard]] report::NodePosition positions(const results::MeshSource& mesh);

}  // namespace gapcheck::app
