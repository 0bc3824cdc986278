#pragma once
#include <cstdint>
#include <vector>

#include "results/history/body_motion.hpp"
#include "results/history/wall_forces.hpp"
#include "solver/run.hpp"

namespace gapcheck::solver {

/// A rigid body under the id that files give it.
struct ListedBody {
  std::size_t body = 0;
  std::int64_t id = 0;
  bool nodal = false;
};

/// Each rigid body of parts once, under its first part in the order of the deck, then the nodal ones; welds are none.
[[nodiscard]] std::vector<ListedBody> listed_bodies(const Run& run);

/// What rbdout needs of all steps so far.
class BodyTurns {
 public:
  BodyTurns() = default;
  explicit BodyTurns(const Run& run);
  /// Once per step.
  void advance(const Run& run);
  /// The motion of all listed bodies. Velocities are those of the middle of the next step.
  [[nodiscard]] std::vector<results::BodyMotion> states(const Run& run) const;

 private:
  struct Body {
    ListedBody listed;
    Vector start = Vector::Zero();                            ///< of the centre
    Matrix axes = Matrix::Identity();                         ///< principal ones at the start
    Vector spin = Vector::Zero(), rotation = Vector::Zero();  ///< ∫ ω dt
  };
  std::vector<Body> bodies_;
};

/// Of the walls that are calculated, in deck order.
[[nodiscard]] std::vector<results::WallForce> wall_states(const Run& run);

}  // namespace gapcheck::solver
