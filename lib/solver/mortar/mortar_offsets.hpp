#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "solver/mortar/mortar_pair.hpp"

namespace gapcheck::solver {

/// The treatment of penetrations that are there when a mortar contact begins to act: by face and side of the tracked
/// surface a depth without force. Source: meanings of IGNORE as printed in d3hsp.
///
///     1     that depth, smaller as soon as the faces part
///     2     that depth, with the pressure MPAR1 at it; 0 is taken as 2, the default of mortar contact
///     3, 4  that depth, less and less until it is zero after the time MPAR1; 4: MPAR2 is the greatest such depth
class MortarOffsets {
 public:
  MortarOffsets() = default;
  /// `ignore`: with sign; below zero the same, without contact inside parts.
  MortarOffsets(std::int64_t ignore, double mpar1, std::size_t faces);

  /// Sets the depths from the pairs at the beginning.
  void begin(std::span<const MortarPair> pairs, double time);
  /// After each cycle: with IGNORE = 1 depths follow faces that part.
  void follow(std::span<const MortarPair> pairs);
  /// Depth without force of a pair's tracked face.
  [[nodiscard]] double forgiven(const MortarPair& pair, double time, const MortarLaw& law) const;
  /// How much of that depth gives force again since `dt` ago: penetrations that IGNORE = 3 and 4 press out.
  [[nodiscard]] double grown(const MortarPair& pair, double time, double dt) const;
  /// Takes over a depth of the same face on an earlier surface.
  void take(std::uint32_t face, const MortarOffsets& from, std::uint32_t of);
  void continue_from(const MortarOffsets& before) { start_ = before.start_; }

 private:
  static std::size_t place(std::uint32_t face, const MortarPair& pair) {
    return 2 * std::size_t{face} + (pair.side < 0 ? 1 : 0);
  }
  [[nodiscard]] bool presses_out() const { return ignore_ == 3 || ignore_ == 4; }
  /// The share of the depth that MPAR1 leaves without force.
  [[nodiscard]] double share_left(double time) const;
  [[nodiscard]] std::vector<double> deepest(std::span<const MortarPair> pairs) const;

  std::int64_t ignore_ = 2;
  double mpar1_ = 0, start_ = 0;
  std::vector<double> depth_;  ///< by face and side
};

}  // namespace gapcheck::solver
