#include "contact/definition/same_surface.hpp"

#include <algorithm>
#include <optional>

namespace gapcheck::contact {
namespace {

using model::SurfaceType;

/// The parts that a side names, ascending; nothing where it is not given by parts or names none.
std::optional<std::vector<PartIndex>> named_parts(const model::Model& model, const model::SurfaceInput& side) {
  std::vector<PartIndex> parts;
  const auto type = static_cast<SurfaceType>(side.type);
  if (type == SurfaceType::part) {
    if (const auto part = model.part_of_id.find(side.id); part != model.part_of_id.end()) parts.push_back(part->second);
  } else if (type == SurfaceType::all) {
    for (std::uint32_t i = 0; i < model.parts.size(); ++i) parts.emplace_back(i);
  } else if (type == SurfaceType::part_set || type == SurfaceType::exempted_part_set || type == SurfaceType::branch) {
    const auto& sets = type == SurfaceType::branch ? model.sets.branches : model.sets.parts;
    const auto set = sets.find(side.id);
    if (set == sets.end()) return std::nullopt;
    std::vector<bool> named(model.parts.size());
    for (const PartIndex part : set->second.members) named[part.value] = true;
    if (type == SurfaceType::exempted_part_set) named.flip();
    for (std::uint32_t i = 0; i < named.size(); ++i)
      if (named[i]) parts.emplace_back(i);
  }
  if (parts.empty()) return std::nullopt;
  return parts;
}

template <class Member>
bool same_members(const std::map<std::int64_t, model::Set<Member>>& sets, std::int64_t a, std::int64_t b) {
  const auto first = sets.find(a), second = sets.find(b);
  if (first == sets.end() || second == sets.end() || first->second.members.empty()) return false;
  if (a == b) return true;
  if (first->second.members.size() != second->second.members.size()) return false;
  std::vector<Member> x = first->second.members, y = second->second.members;
  std::sort(x.begin(), x.end());
  std::sort(y.begin(), y.end());
  return x == y;
}

}  // namespace

bool same_surface(const model::Model& model, const model::SurfaceInput& a, const model::SurfaceInput& b) {
  if (a.box != b.box) return false;
  if (a.type == b.type) {
    switch (static_cast<SurfaceType>(a.type)) {
      case SurfaceType::segment_set:
        return same_members(model.sets.segments, a.id, b.id);
      case SurfaceType::shell_set:
        return same_members(model.sets.shells, a.id, b.id);
      case SurfaceType::node_set:
        return same_members(model.sets.nodes, a.id, b.id);
      default:
        break;
    }
  }
  const auto parts = named_parts(model, a);
  return parts && parts == named_parts(model, b);
}

}  // namespace gapcheck::contact
