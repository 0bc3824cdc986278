#pragma once
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "contact/definition/contact_type.hpp"
#include "contact/pair/closest_segment.hpp"
#include "contact/search/choose_search.hpp"
#include "contact/search/nearest_boxes.hpp"
#include "contact/surface/contact_surfaces.hpp"
#include "contact/tie/ties.hpp"
#include "geometry/decide.hpp"
#include "model/model.hpp"
#include "records/report.hpp"

namespace gapcheck::contact {

struct InitialOptions {
  std::vector<std::int64_t> contacts;  ///< ids; empty = all. Contacts left out do not move nodes either
  double tolerance = -1;               ///< replaces the default tolerance of a penetration; negative: default
  geometry::Mode mode = geometry::Mode::filtered;
  bool brute_force = false;
  /// How near to a face's plane a node lies in it, as a share of the face's shorter diagonal (PairScene::flush): what
  /// coordinates with some eight digits leave open.
  double flush = 1e-6;
  double most_pairs = crowd_pairs_of_decks;  ///< of one search; beyond, only the nearest segments of each node
  std::optional<SearchKind> search;          ///< nothing: chosen for each search by its scene
  bool nodes_stay = false;                   ///< penetrating nodes are not moved, whatever the settings
  bool repeated = true;  ///< false, with nodes_stay: contacts that repeat an earlier one are left out
  // Penetrations that move no nodes are searched only on request.
  bool segments = false;  ///< contacts with SOFT = 2
  bool mortar = false;
  bool edges = false;       ///< edges against edges in types 26
  bool moved_into = false;  ///< searches again for the nodes that a contact has moved, once it has moved them all
  bool overlaps = false;    ///< the intended overlaps of INTERFERENCE contacts
  /// Penetrations that are listed; those beyond are only counted (ContactSummary::reported_penetrations).
  std::size_t most_listed = std::numeric_limits<std::size_t>::max();
};

struct InitialCounters {
  geometry::DecisionCounters decisions;
  SweepCounters sweep;
  SearchTally searches_by_kind;  ///< ties and orientation included
  std::uint64_t tied_nodes = 0, tied_pairs = 0, excluded_pairs = 0, surfaces_built = 0;
  std::uint64_t contacts_searched = 0;  ///< whose nodes and segments were searched at all
  std::uint64_t contacts_culled = 0;    ///< of these: all searches ended by boxes
  std::uint64_t edges = 0;              ///< that were checked
  double surface_s = 0, search_s = 0;
};

/// A node that the solver moves out of one segment and into another, which shares no node with the first.
struct MovedInto {
  NodeIndex node;
  std::int64_t element = 0, element_part = 0;  ///< ids of the element that it left and of its part; 0: unknown
  double moved = 0;                            ///< by how much
  Penetration into;                            ///< where it lands, `original` being where it was moved to
};

struct InitialState {
  std::vector<ContactSummary> contacts;   ///< beside Model::contacts; those not chosen have `not_checked` set
  std::vector<Penetration> penetrations;  ///< by contact, deepest first, then node id
  std::vector<MovedInto> moved_into;      ///< only on request; by contact
  std::vector<Penetration> overlaps;      ///< only on request; intended, so no penetrations: INTERFERENCE contacts
  std::vector<JudgedNode> judged;         ///< nodes meant to tie; by contact, then node
  std::vector<std::string> notes;         ///< input that is not supported
  std::vector<Vector> x;                  ///< coordinates after the initialisation
};

/// What the solver finds when it initialises the contacts: one by one in deck order, side A before side B, each on the
/// coordinates left by the earlier ones; within one side all nodes are judged on the same coordinates. `surfaces`: of
/// this model. Source: contact rules, sections 3 to 5, 7 and 12.
[[nodiscard]] InitialState initialise_contacts(const model::Model& model, SurfaceStore& surfaces,
                                               const InitialOptions& options, InitialCounters& counters);

}  // namespace gapcheck::contact
