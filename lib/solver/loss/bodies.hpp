#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/union_find.hpp"
#include "contact/initial.hpp"
#include "model/model.hpp"
#include "solver/loss/flight.hpp"
#include "solver/structure/structure.hpp"

namespace gapcheck::solver {

/// What moves together: nodes that elements, rigid bodies, springs, joints, ties and other constraints connect.
class ConnectedBodies {
 public:
  enum class Kind : std::uint8_t {
    fixed,    ///< nothing but its prescribed motion moves it
    point,    ///< one node without elements that deform
    rigid,    ///< one rigid body that nothing is attached to
    elastic,  ///< anything else
  };
  /// All references must outlive it.
  ConnectedBodies(const model::Model& model, const Structure& structure, const contact::InitialState& initial,
                  const StartMotion& start, const Flight& flight);

  /// A number of the body of a node.
  [[nodiscard]] std::uint32_t of(NodeIndex node) const { return root_[node.value]; }
  /// What these nodes of one body belong to. They may be fixed where others of the body are not.
  [[nodiscard]] Kind kind(std::span<const NodeIndex> nodes) const;
  /// What a unit impulse along a direction does to the velocity in it: 1 / mass. Of points and rigid bodies.
  [[nodiscard]] double mobility(NodeIndex node, const Vector& direction) const;
  /// The rigid body of a node; null: none.
  [[nodiscard]] const BodyState* rigid(NodeIndex node) const {
    return structure_.state.in_body(node.value) ? &start_.bodies[structure_.state.body[node.value]] : nullptr;
  }
  /// The mass of a body's nodes and rigid bodies.
  [[nodiscard]] double mass(std::uint32_t body) const { return sums_[body].mass; }
  /// All nodes of it have this velocity at the start, and nothing holds or moves any of them.
  [[nodiscard]] bool flies_freely(std::uint32_t body, const Vector& velocity) const;
  /// The largest kinetic energy that two bodies can bring into each other: that in the frame of what holds or moves
  /// them, else in the frame of their common centre of mass. Nothing: what moves them has no such frame.
  [[nodiscard]] std::optional<double> energy(std::uint32_t a, std::uint32_t b) const;

 private:
  void connect(const model::Model& model, const contact::InitialState& initial);
  void connect_ties(const model::Model& model, const contact::InitialState& initial, UnionFind& sets);
  /// What holds or moves a body, by axis.
  struct Frame {
    std::array<std::optional<double>, 3> imposed;
    bool none = false;  ///< there is no frame in which it rests
    void impose(std::size_t axis, double velocity) {
      if (imposed[axis] && *imposed[axis] != velocity) none = true;
      imposed[axis] = velocity;
    }
  };
  /// Sums over a body at the start.
  struct Sums {
    double mass = 0, kinetic = 0;  ///< with the energy of spins
    Vector momentum = Vector::Zero();
    Frame frame;
    contact::Bounds velocities;
    bool free = true;
    void add(double m, const Vector& v) {
      mass += m;
      kinetic += m * v.squaredNorm() / 2;
      momentum += m * v;
    }
  };
  void sum_up();
  void add_frame(NodeIndex node, Sums& sums) const;

  const Structure& structure_;
  const StartMotion& start_;
  const Flight& flight_;
  std::vector<std::uint32_t> root_;  ///< by node
  std::vector<bool> attached_;       ///< by root: more than a node or a rigid body alone
  std::vector<Sums> sums_;           ///< by root
};

}  // namespace gapcheck::solver
