#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "base/result.hpp"
#include "keyword/card.hpp"

namespace gapcheck::keyword {

/// Maps points: matrix * x + shift.
struct Placement {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  Vector shift = Vector::Zero();
};

/// Where a node lies, in the coordinates that a transformation acts on; the error says why that is not known.
using NodePosition = std::function<Result<Vector>(std::int64_t node)>;

/// True for *DEFINE_TRANSFORMATION and *DEFINE_TRANSFORM, its other name, with or without a title.
[[nodiscard]] bool is_transformation(std::string_view keyword);

/// The id of a *DEFINE_TRANSFORMATION block, with its include's offset; 0 if it has none.
std::int64_t transformation_id(const Deck& deck, const Block& block, Diagnostics& diagnostics);

/// The nodes that the rows of a *DEFINE_TRANSFORMATION block refer to, with its include's offset.
[[nodiscard]] std::vector<std::int64_t> transformation_nodes(const Deck& deck, const Block& block);

/// The placement that a *DEFINE_TRANSFORMATION block describes. Its rows act in order, from first to last: SCALE,
/// ROTATE, TRANSL in this order scale first and move last. Rows: TRANSL, SCALE, ROTATE, MIRROR, MATRIX; POS6P and the
/// short form of ROTATE with POINT rows of the same block, which the rows before the reference move too; TRANSL2ND,
/// ROTATE3NA and POS6N with nodes, which they do not. What is wrong is reported, and the result is not a placement.
std::optional<Placement> read_transformation(const Deck& deck, const Block& block, const NodePosition& node,
                                             Diagnostics& diagnostics);

}  // namespace gapcheck::keyword
