#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "audit/fix/wall_hits.hpp"
#include "contact/initial.hpp"
#include "records/fix.hpp"

namespace gapcheck::audit {

/// What the contacts find at some coordinates.
struct Judgement {
  contact::InitialState state;            ///< without its summaries of contacts, of which these are enough:
  std::vector<FixContact::State> counts;  ///< by contact
  std::vector<std::uint64_t> edges;       ///< by contact: edges that penetrate, in types 26
  std::vector<WallHit> walls;             ///< nodes in rigid walls
  std::map<ContactIndex, std::string> not_checked;
  std::uint64_t penetrating = 0;  ///< nodes that a correction has to free
  double depth = 0;               ///< sum of their penetrations
  double deepest = 0;             ///< the largest of them
  std::uint64_t crossings = 0;    ///< pairs of elements; 0 where they are not to be undone
  std::uint64_t work = 0;         ///< pairs of nodes and segments that were decided, and nodes
};

/// Searches the contacts of a model at different coordinates, which the model has from then on. It must outlive this.
class ContactJudge {
 public:
  /// The model has its first coordinates.
  explicit ContactJudge(model::Model& model);
  [[nodiscard]] Judgement at(const std::vector<Vector>& x);
  /// On the coordinates judged last.
  [[nodiscard]] contact::SurfaceStore& surfaces() { return *surfaces_; }

 private:
  /// Lines that cross where no thickness of edges counts (GC104, SOFT = 2): as penetrations of edges.
  void add_crossed_edges(Judgement& now);
  void count(Judgement& now) const;
  /// Drops the overlaps that mortar contacts are to press out over time (IGNORE = 3, 4).
  void leave_fits(Judgement& now) const;

  model::Model& model_;
  WallSearch walls_;
  std::vector<std::uint8_t> fits_;  ///< by contact
  std::optional<contact::SurfaceStore> surfaces_;
};

/// The best coordinates of a search so far.
struct BestMove {
  std::vector<Vector> target;   ///< as found
  std::vector<Vector> written;  ///< as the deck's lines can express it
  Judgement judgement;          ///< of `written`
  std::uint64_t crossings = 0;  ///< of `written`, once they are counted
  [[nodiscard]] bool crosses_less(const BestMove& other) const {
    return crossings < other.crossings ||
           (crossings == other.crossings && judgement.penetrating < other.judgement.penetrating);
  }
  double movement = 0;  ///< how much has moved for it
  /// Takes other coordinates that are better: fewer crossings, then fewer penetrations, then less `moved`. True if they
  /// are better without counting the movement.
  bool take(const std::vector<Vector>& x, const std::vector<Vector>& as_written, Judgement&& now, double moved);
};

}  // namespace gapcheck::audit
