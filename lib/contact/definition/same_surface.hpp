#pragma once
#include "model/model.hpp"

namespace gapcheck::contact {

/// True if two sides of a contact name the same things in the same box: the same part, the same set, or sets (a part
/// and a set) with the same members. False if they name nothing.
[[nodiscard]] bool same_surface(const model::Model& model, const model::SurfaceInput& a, const model::SurfaceInput& b);

}  // namespace gapcheck::contact
