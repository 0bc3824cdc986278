#pragma once
#include <Eigen/Dense>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/interpolation/follower.hpp"

namespace gapcheck::solver {

/// Followers that share nodes, directly or through others: their loads are solved for together.
struct FollowerGroup {
  std::vector<std::size_t> followers;               ///< ascending
  std::vector<std::uint32_t> nodes;                 ///< followed, ascending
  std::vector<std::vector<std::size_t>> positions;  ///< by follower, of its nodes in these
  std::vector<Eigen::Index> first;                  ///< by follower: its first row
  Eigen::Index rows = 0;                            ///< degrees of freedom that follow
};

[[nodiscard]] std::vector<FollowerGroup> group_followers(std::span<const Follower> followers);

}  // namespace gapcheck::solver
