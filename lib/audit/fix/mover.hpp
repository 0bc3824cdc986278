#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "audit/fix/fix.hpp"
#include "audit/fix/judgement.hpp"
#include "audit/fix/move_solver.hpp"
#include "audit/untangle/crossing_pairs.hpp"
#include "audit/untangle/untangling.hpp"

namespace gapcheck::audit {

/// Finds where the nodes go: searches the contacts, solves for the least movement that opens all gaps found so far, and
/// repeats until nothing penetrates or improves. Changes the model's coordinates on the way. All references must
/// outlive it.
class Mover {
 public:
  /// How it treats elements that cross: nodes stay on the side on which they are, or those of wrong pieces change
  /// sides.
  enum class Crossings : std::uint8_t { stay, untangle };

  /// `lines`: of the deck that the model was read from, whose coordinates the model gets at first.
  Mover(model::Model& model, NodeLines& lines, ElementBounds& bounds, const std::vector<Vector>& deck_x,
        Freedoms freedoms, const std::vector<model::HangingNode>& hanging, const FixOptions& options,
        Crossings crossings = Crossings::stay);
  Mover(const Mover&) = delete;
  Mover& operator=(const Mover&) = delete;
  /// Once the work is stopped, it ends somewhere on the way.
  void run();

  /// Gives the model these coordinates again, after it had others.
  void show() { model_.mesh.nodes.x = best_.written; }

  [[nodiscard]] const Judgement& before() const { return before_; }
  /// At the best coordinates found, which the model now has.
  [[nodiscard]] const Judgement& after() const { return best_.judgement; }
  /// Nodes that have moved from their place in the deck, ascending.
  [[nodiscard]] std::vector<NodeIndex> moved() const;
  /// The target of a moved node; the model has the nearest position that its line can express.
  [[nodiscard]] const Vector& target(NodeIndex node) const { return best_.target[node.value]; }
  [[nodiscard]] bool onto_tie(NodeIndex node) const { return start_.x[node.value] != start_.deck[node.value]; }
  /// Why a record of after() is still there.
  [[nodiscard]] HoldReason reason(const Penetration& record);
  [[nodiscard]] HoldReason reason(const WallHit& hit);
  [[nodiscard]] std::uint32_t rounds() const { return rounds_; }
  /// True if the search ended because it took too much work, not because nothing was left to gain.
  [[nodiscard]] bool cut_short() const { return cut_short_; }
  /// True if fewer elements cross than before, none that did not, and no more nodes penetrate.
  [[nodiscard]] bool has_untangled() const {
    return crossings_after_ < crossings_before_.size() && best_.judgement.penetrating <= before_.penetrating;
  }
  /// Why a node is held; `none` if it could move.
  [[nodiscard]] HoldReason reason(NodeIndex node) const { return start_.freedoms.reason[node.value]; }
  /// Pairs of elements that cross.
  [[nodiscard]] std::uint64_t crossings_before() const { return crossings_before_.size(); }
  [[nodiscard]] std::uint64_t crossings_after() const { return crossings_after_; }
  [[nodiscard]] const std::map<std::string, WritableNodes::Unwritable>& unwritable() const {
    return writable_.unwritable();
  }

 private:
  void move_as_recommended();
  void start_on_ties();
  void start_again();
  void search(std::uint64_t work);
  [[nodiscard]] std::optional<Untangling> untangle(Judgement& now, const std::vector<Vector>& x);
  [[nodiscard]] double movement(const std::vector<Vector>& x) const;
  [[nodiscard]] Judgement judge(const std::vector<Vector>& x);
  [[nodiscard]] std::vector<HeldTie> ties_at(const Judgement& now, const std::vector<Vector>& x);
  [[nodiscard]] bool can_open_more(const Judgement& now);
  struct CrossingChange {
    bool none_new = true, left_alone = false;  ///< `left_alone`: crossings are given up from here on
  };
  [[nodiscard]] CrossingChange hold_new_crossings();
  [[nodiscard]] bool leave_crossings_alone(const std::set<ElementPair>& now);

  model::Model& model_;
  ElementBounds& bounds_;
  const std::vector<model::HangingNode>& hanging_;
  const FixOptions& options_;
  ContactJudge judge_;
  MoveStart start_;
  WritableNodes writable_;
  MoveConditions conditions_;
  WorkBudget budget_;
  MoveSolver solver_;
  Judgement before_;
  BestMove best_;
  const Crossings crossings_;
  std::set<ElementPair> crossings_before_, left_alone_;
  std::uint64_t crossings_after_ = 0;
  std::uint32_t rounds_ = 0;
  bool cut_short_ = false;
};

}  // namespace gapcheck::audit
