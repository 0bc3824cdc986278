#include <algorithm>
#include <filesystem>

#include "contact/surface/surface.hpp"
#include "family.hpp"
#include "keyword/deck.hpp"
#include "model/model.hpp"

namespace gapcheck::bench {
namespace {

struct Sides {
  contact::Segments segments;
  contact::TrackedNodes nodes;
};

/// The segments of the first side that has some and the nodes of the other one, or of the same.
Sides sides_of(const model::Model& model, const model::Contact& card) {
  const auto type = contact::classify(card);
  const auto settings = contact::settings(card, type, model.controls);
  const auto& x = model.mesh.nodes.x;
  contact::MeshIndex index(model);
  const auto side = [&](bool second) {
    const auto thickness = contact::thickness_side(card, settings, model.controls, second);
    auto selection = contact::select(model, second ? card.b : card.a, type, x, index);
    contact::fill_thickness(selection.segments, model, thickness, x);
    auto nodes = contact::tracked_nodes(selection, model, thickness, x, index);
    return Sides{std::move(selection.segments), std::move(nodes)};
  };
  Sides a = side(false), b = side(true);
  if (b.segments.size() == 0) return a;
  return {std::move(b.segments), std::move(a.nodes)};
}

void add_pairs(PairFamily& family, const model::Model& model, const Sides& sides) {
  const auto& x = model.mesh.nodes.x;
  for (std::size_t s = 0; s < sides.segments.size(); ++s) {
    if (sides.segments.kind[s] == contact::SegmentKind::line) continue;
    const auto& n = sides.segments.nodes[s];
    const geometry::Facet facet{{x[n[0].value], x[n[1].value], x[n[2].value], x[n[3].value]}, n[2] == n[3]};
    contact::Bounds box;
    for (const Vector& corner : facet.x) box.add(corner);
    for (std::size_t i = 0; i < sides.nodes.size(); ++i) {
      const NodeIndex node = sides.nodes.node[i];
      if (std::find(n.begin(), n.end(), node) != n.end()) continue;
      const double bound = sides.segments.half[s] + sides.nodes.half[i];
      contact::Bounds point;
      point.add(x[node.value]);
      if (bound > 0 && contact::grown(box, 2 * bound).meets(point)) add_pair(family, facet, x[node.value], bound);
    }
  }
}

}  // namespace

PairFamily deck_family(const std::string& folder, int& decks) {
  namespace fs = std::filesystem;
  PairFamily family;
  family.name = "decks of data/";
  family.group = groups[4];
  decks = 0;
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".k") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  for (const fs::path& path : paths) {
    Diagnostics diagnostics;
    const auto deck = keyword::read_deck(path.string(), {}, diagnostics);
    if (!deck) continue;
    const auto model = model::read_model(deck.value(), diagnostics);
    if (!model) continue;
    ++decks;
    for (const model::Contact& card : model.value().contacts) {
      add_pairs(family, model.value(), sides_of(model.value(), card));
    }
  }
  return family;
}

}  // namespace gapcheck::bench
