#pragma once
#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/ids.hpp"
#include "base/parallel.hpp"

namespace gapcheck::solver {

/// Steps stay below the bound of stability by this factor. They grow only when they can and stay below their limit by
/// as much.
constexpr double step_slack = 1.01;

/// Results of one pass over elements of a kind besides their forces.
struct Summary {
  double manual_step = std::numeric_limits<double>::infinity();
  double stable_step = std::numeric_limits<double>::infinity();
  double work = 0, hourglass_work = 0;  ///< of the step; work includes the hourglass work
  double dissipated = 0;                ///< by plastic flow and viscosities in the step
  double viscous_work = 0;              ///< of the bulk viscosity in the step; part of work
  double supplied = 0;                  ///< by what imposes a beam's force in the step: external work; part of work
  std::uint64_t failed = 0;             ///< elements that fail now
  std::uint32_t bad = no_position;      ///< first element without a usable shape
  std::uint32_t manual_at = no_position, stable_at = no_position;  ///< the first elements with these steps

  void add(const Summary& other) {
    if (other.manual_step < manual_step) manual_at = other.manual_at;
    if (other.stable_step < stable_step) stable_at = other.stable_at;
    manual_step = std::min(manual_step, other.manual_step);
    stable_step = std::min(stable_step, other.stable_step);
    work += other.work;
    hourglass_work += other.hourglass_work;
    viscous_work += other.viscous_work;
    supplied += other.supplied;
    failed += other.failed;
    bad = std::min(bad, other.bad);
  }
};

/// The work that one element has taken since the start.
struct ElementEnergy {
  double initial = 0;  ///< what its stresses stored at the start; no work has put it in
  double internal = 0, hourglass = 0;
  double viscous = 0;     ///< of the bulk viscosity; part of internal
  double dissipated = 0;  ///< of both, by plastic flow and viscosities: what no state gives back
  void add(const Summary& step) {
    internal += step.work - step.hourglass_work;
    hourglass += step.hourglass_work;
    viscous += step.viscous_work;
    dissipated += step.dissipated;
  }
  [[nodiscard]] double sum() const { return internal + hourglass; }
  /// As LS-DYNA prints it: without the work of the bulk viscosity.
  [[nodiscard]] double printed_internal() const { return internal - viscous; }
};

/// Calls body(begin, end) → Part on fixed blocks of [0, count) in parallel and adds the parts up in the order of the
/// blocks: the sums do not depend on threads.
template <class Part, class Body>
Part sum_over_blocks(std::size_t count, const Body& body) {
  constexpr std::size_t block = 1024;
  const std::size_t blocks = (count + block - 1) / block;
  std::vector<Part> parts(blocks);
  parallel_for(blocks, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) parts[i] = body(i * block, std::min(count, (i + 1) * block));
  });
  Part sum;
  for (const Part& part : parts) sum.add(part);
  return sum;
}

}  // namespace gapcheck::solver
