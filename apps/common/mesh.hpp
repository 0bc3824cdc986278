#pragma once
#include <optional>
#include <string>

#include "base/diagnostic.hpp"
#include "base/result.hpp"
#include "model/model.hpp"
#include "records/report.hpp"
#include "report/export/exports.hpp"
#include "results/d3plot/mesh_source.hpp"

namespace gapcheck::app {

/// Coordinates and parts of a deck's nodes. A node of several elements belongs to the part of the first one in the
/// order shells, solids, thick shells, beams, discrete elements, masses, particles. Errors: the deck cannot be read at
/// all; others are in `diagnostics`. The whole model goes to `model` where that is not null.
Result<results::MeshSource> read_deck_mesh(const std::string& path, Diagnostics& diagnostics,
                                           std::optional<model::Model>* model = nullptr);

/// The mesh of `deck`, else of the d3plot, else of a file named d3plot beside `beside` if there is one that can be read
/// (a warning says why not); else no mesh. Errors: a file that was named cannot be read. `model`: as above.
Result<results::MeshSource> find_mesh(const std::string& deck, const std::string& d3plot, const std::string& beside,
                                      Diagnostics& diagnostics, std::optional<model::Model>* model = nullptr);

/// Fills in the parts of nodes that the report does not know.
void add_parts(Report& report, const results::MeshSource& mesh);

/// Lives as long as the mesh.
[[nodiscard]] report::NodePosition positions(const results::MeshSource& mesh);

}  // namespace gapcheck::app
