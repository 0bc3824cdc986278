#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/vector.hpp"
#include "model/entity/part.hpp"

namespace gapcheck::model {

/// A set with its members resolved to array positions; members that do not exist are left out (and are a Fault).
/// Members are in the order of the deck, each once.
template <class Member>
struct Set {
  std::int64_t id = 0;
  std::string title;
  std::vector<Member> members;
  std::array<double, 4> defaults{};  ///< DA1 … DA4
  Place place;
};

using SegmentNodes = std::array<NodeIndex, 4>;  ///< a triangle repeats its last node

struct Sets {
  std::map<std::int64_t, Set<NodeIndex>> nodes;
  std::map<std::int64_t, Set<PartIndex>> parts, branches;
  std::map<std::int64_t, Set<SegmentNodes>> segments;
  // Positions in the arrays of Mesh.
  std::map<std::int64_t, Set<std::uint32_t>> shells, solids, thick_shells, beams, discrete;
};

/// *DEFINE_BOX (also _LOCAL, then with `axes`).
struct Box {
  std::int64_t id = 0;
  Vector low = Vector::Zero(), high = Vector::Zero();  ///< in the box's own axes
  Vector origin = Vector::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< rows: local x, y, z
  Place place;
  [[nodiscard]] bool contains(const Vector& x) const {
    const Vector local = axes * (x - origin);
    return (local.array() >= low.array()).all() && (local.array() <= high.array()).all();
  }
};

}  // namespace gapcheck::model
