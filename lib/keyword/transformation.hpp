#pragma once
#include <cstdint>
#include <map>
#include <optional>

#include "keyword/card.hpp"

namespace gapcheck::keyword {

/// Maps points: matrix * x + shift.
struct Placement {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  Vector shift = Vector::Zero();
};

/// The id of a *DEFINE_TRANSFORMATION block, with its include's offset; 0 if it has none.
std::int64_t transformation_id(const Deck& deck, const Block& block, Diagnostics& diagnostics);

/// The placement that a *DEFINE_TRANSFORMATION block describes. Its rows act in order, from first to last: SCALE,
/// ROTATE, TRANSL in this order scale first and move last. Rows: TRANSL, TRANSL2ND, SCALE, ROTATE, MIRROR, MATRIX,
/// POS6P, POINT. Points of ROTATE, TRANSL2ND and POS6P must be given by POINT rows of the same block; rows that refer
/// to nodes and rows of any other kind are reported, and the result is not a placement.
std::optional<Placement> read_transformation(const Deck& deck, const Block& block, Diagnostics& diagnostics);

}  // namespace gapcheck::keyword
