#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "contact/initial.hpp"
#include "solver/contact/segment_axes.hpp"
#include "solver/interface/contact_source.hpp"
#include "solver/state/failure.hpp"
#include "solver/state/force.hpp"
#include "solver/structure/structure.hpp"

namespace gapcheck::solver {

/// What turns directions with a segment.
enum class Turning : std::uint8_t {
  none,   ///< nothing: they stay fixed in space
  axes,   ///< the segment's axes
  nodes,  ///< the mean angular velocity of the segment's nodes
  drill,  ///< the same, but about the normal the segment's axes: nodes of shells turn freely about it
};

/// One node that is tied to a point of a segment.
struct Tie {
  ContactIndex contact;
  SegmentIndex segment;  ///< of the reference side
  PartIndex segment_part = none<PartIndex>;
  model::ElementKind element_kind = model::ElementKind::shell;
  std::uint32_t element = no_position;  ///< of the segment; or no_position
  NodeIndex node;
  ContactPoint point;                ///< of the segment
  Turning offset = Turning::none;    ///< what turns the offset from the point to the node
  bool carries = false;              ///< the moment of the offset acts on the segment
  bool rotations = false;            ///< the node's rotations are tied too
  Turning rotation = Turning::none;  ///< to what
};

/// The element of the segment has failed: there is nothing left to tie to.
[[nodiscard]] bool segment_gone(const Tie& tie, const FailedElements& failed);

/// Called for every tie that has ended: the node, and the part of its segment.
using Released = std::function<void(NodeIndex, PartIndex)>;

/// What the message file says about nodes whose ties have failed.
[[nodiscard]] std::string failed_ties(const std::vector<std::int64_t>& nodes);

/// The angular velocity of a segment as `turning` defines it.
[[nodiscard]] Vector segment_spin(Turning turning, const ContactPoint& point, const SegmentAxes& axes,
                                  const std::vector<Vector>& v, const std::vector<Vector>& w);

/// Motion of the node and of the point it is tied to.
struct TieMotion {
  Vector velocity = Vector::Zero();  ///< of the node relative to the point
  Vector spin = Vector::Zero();      ///< of the offset
  Vector turn = Vector::Zero();      ///< angular velocity of the node relative to the segment
};
[[nodiscard]] TieMotion motion(const Tie& tie, const SegmentAxes& axes, const std::vector<Vector>& v,
                               const std::vector<Vector>& w);

/// The offset of a tied node from its point, as it turns with the segment.
class TieOffset {
 public:
  void start(const Tie& tie, const SegmentAxes& axes, const std::vector<Vector>& x);
  /// With another value than the present distance.
  void start(const SegmentAxes& axes, const Vector& value);
  /// At the end of a step over dt in which the segment turned with `spin`.
  void move(const Tie& tie, const SegmentAxes& axes, const Vector& spin, double dt);
  /// Makes a part of the elongation permanent.
  void shift(const SegmentAxes& axes, const Vector& by);
  [[nodiscard]] const Vector& value() const { return value_; }
  /// In the segment's axes, if these turn it.
  [[nodiscard]] const Vector& local() const { return local_; }

 private:
  Vector value_ = Vector::Zero(), local_ = Vector::Zero();
};

/// The action of a tie at its node and at the corners of its segment: forces and moments, opposite in sum.
struct TieLoads {
  Vector force = Vector::Zero(), moment = Vector::Zero();  ///< on the node
  std::array<Vector, 4> forces{Vector::Zero(), Vector::Zero(), Vector::Zero(), Vector::Zero()}, moments = forces;
  /// Force and moment on the node; what acts on the segment follows. `arm`: from the point to the node.
  void set(const Tie& tie, const SegmentAxes& axes, const Vector& arm, const Vector& force, const Vector& moment);
  void add_to(const Tie& tie, Forces& forces) const;
  /// Power on the node and on the segment.
  [[nodiscard]] double on_node(const Tie& tie, const State& state) const;
  [[nodiscard]] double on_segment(const Tie& tie, const State& state) const;
  /// Adds to the sums of the contact.
  void add_to(const Tie& tie, const State& state, ContactState& result) const;
};

/// One contact's ties among those of all, [first, last), and when they act.
struct TieRange {
  ContactIndex contact;
  std::size_t first = 0, last = 0;
  double start = 0, end = 0;
  [[nodiscard]] bool active(double time) const { return time >= start && time < end; }
  /// They no longer act, or never will.
  [[nodiscard]] bool over(double time) const { return time >= end || end <= start; }
};
/// Of the contacts that tie by constraints, or by springs, and of other contacts with ties in the list.
[[nodiscard]] std::vector<TieRange> tie_ranges(const model::Model& model, const std::vector<Tie>& ties,
                                               bool by_constraint);

/// The parts whose nodes tie to each other's segments in one tiebreak of a single surface, if its ties may fail: how
/// the nodes of both faces share a strength is not published. Also of a part that ties to itself.
[[nodiscard]] SolverStatus check_tied_faces(const model::Model& model, const contact::InitialState& initial);

/// A tie of a calculated contact at a point. `constraint`: it is no spring. What the segment belongs to is still to be
/// set.
[[nodiscard]] Tie tie_at(const model::Contact& contact, const contact::ContactType& type, bool constraint,
                         NodeIndex node, const ContactPoint& point, const std::vector<Vector>& x,
                         const Structure& structure);

/// The ties of all calculated contacts, by contact, then node: those by constraints, or those by springs. The ties are
/// those that the initialisation found.
[[nodiscard]] std::vector<Tie> tie_list(const model::Model& model, contact::SurfaceStore& surfaces,
                                        const contact::InitialState& initial, const Structure& structure,
                                        bool by_constraint);

}  // namespace gapcheck::solver
