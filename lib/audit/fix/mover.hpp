#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "audit/fix/crossing_pairs.hpp"
#include "audit/fix/fix.hpp"
#include "audit/fix/gaps.hpp"
#include "audit/fix/held_ties.hpp"
#include "audit/fix/node_lines.hpp"
#include "audit/fix/shape_conditions.hpp"
#include "contact/initial.hpp"

namespace gapcheck::audit {

/// What the contacts find at some coordinates.
struct Judgement {
  contact::InitialState state;
  std::uint64_t penetrating = 0;  ///< nodes that a correction has to free
  double depth = 0;               ///< sum of their penetrations
};

/// Finds where the nodes go: searches the contacts, solves for the least movement that opens all gaps found so far, and
/// repeats until nothing penetrates or improves. Changes the model's coordinates on the way. All references must
/// outlive it.
class Mover {
 public:
  /// `lines`: of the deck that the model was read from.
  Mover(model::Model& model, NodeLines& lines, ElementBounds& bounds, const std::vector<Vector>& deck_x,
        Freedoms freedoms, const std::vector<model::HangingNode>& hanging, const FixOptions& options);
  void run();

  [[nodiscard]] const Judgement& before() const { return before_; }
  /// At the best coordinates found, which the model now has.
  [[nodiscard]] const Judgement& after() const { return after_; }
  /// Nodes that have moved from their place in the deck, ascending.
  [[nodiscard]] std::vector<NodeIndex> moved() const;
  /// The target of a moved node; the model has the nearest position that its line can express.
  [[nodiscard]] const Vector& target(NodeIndex node) const { return target_[node.value]; }
  [[nodiscard]] bool onto_tie(NodeIndex node) const { return base_[node.value] != deck_[node.value]; }
  /// Why a record of after() is still there.
  [[nodiscard]] HoldReason reason(const Penetration& record);
  [[nodiscard]] std::uint32_t rounds() const { return rounds_; }
  /// True if the search ended because it took too much work, not because nothing was left to gain.
  [[nodiscard]] bool cut_short() const { return cut_short_; }
  /// Pairs of elements that cross.
  [[nodiscard]] std::uint64_t crossings_before() const { return crossings_before_.size(); }
  [[nodiscard]] std::uint64_t crossings_after() const { return crossings_after_; }

  /// The first node whose line cannot be rewritten, for one reason, and the number of such nodes.
  struct Unwritable {
    NodeIndex first;
    std::uint64_t count = 0;
  };
  [[nodiscard]] const std::map<std::string, Unwritable>& unwritable() const { return unwritable_; }

 private:
  void search(std::uint64_t work);
  void start_again();
  bool hold_crossing();
  Judgement judge(const std::vector<Vector>& x);
  void tie_first();
  bool take_best(const std::vector<Vector>& x, const std::vector<Vector>& written, Judgement&& now);
  [[nodiscard]] bool open_gaps(const Judgement& now);
  std::vector<Vector> solve(const std::vector<Vector>& at);
  std::vector<MoveCondition> conditions(const std::vector<Vector>& at, std::vector<std::size_t>& gap_of);
  bool give_up(std::span<const MoveCondition> conditions, std::span<const std::size_t> gap_of,
               std::span<const Vector> moves, std::span<const Vector> mobility, bool converged);
  [[nodiscard]] bool keep_shapes(std::span<const ElementOfKind> broken);
  void keep_multipliers(std::span<const MoveCondition> list, std::span<const std::size_t> gap_of);
  void number_nodes();
  void bring_along(std::vector<std::uint8_t>& moving);
  void hold_unwritable();
  [[nodiscard]] std::vector<Vector> as_written(const std::vector<Vector>& x);

  model::Model& model_;
  NodeLines& lines_;
  ElementBounds& bounds_;
  const std::vector<Vector>& deck_;
  Freedoms freedoms_;
  const std::vector<model::HangingNode>& hanging_;
  const FixOptions& options_;
  std::optional<contact::SurfaceStore> surfaces_;  ///< on the coordinates judged last
  std::vector<Vector> base_;   ///< the deck's coordinates with tied nodes on their segments
  std::vector<Vector> target_, best_;  ///< the best so far: as found, and as the deck's lines can express it
  Judgement before_, after_;
  std::set<ElementPair> crossings_before_;
  std::uint64_t crossings_after_ = 0;
  Gaps gaps_;
  std::vector<HeldTie> all_ties_, ties_;
  std::set<ElementOfKind> shaped_;       ///< elements that have shape conditions
  std::vector<ShapeCondition> shapes_;
  std::vector<NodeIndex> nodes_;       ///< that some condition names, and those joined to them; ascending
  std::vector<NodeIndex> leaders_;     ///< of nodes_, ascending: each moves on its own, with all that follow it
  std::vector<std::uint32_t> slot_;    ///< by node: position of its leader in leaders_
  std::vector<std::uint8_t> looked_at_;  ///< by node: whether its line can be rewritten was asked
  std::vector<double> tie_multipliers_;
  std::map<std::string, Unwritable> unwritable_;
  std::uint32_t rounds_ = 0;
  std::uint64_t work_ = 0, most_work_ = 0;  ///< done so far, and where the present search ends; FixOptions::work
  bool cut_short_ = false;
};

}  // namespace gapcheck::audit
