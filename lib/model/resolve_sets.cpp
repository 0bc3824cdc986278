#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>

#include "model/context.hpp"
#include "model/faces.hpp"

namespace gapcheck::model {
namespace {

using Source = SetClause::Source;

/// Sets of sets may be nested this deep.
constexpr int max_depth = 100;
/// Steps that all sets of a deck together may cost: one per member that is looked at, four bytes each. Sets of sets can
/// ask for much more than a deck of their size has; the largest models stay far below.
constexpr std::uint64_t max_steps = 300'000'000;

/// Members of a set: positions in the arrays of the model, or segments.
struct Members {
  std::vector<std::uint32_t> positions;
  std::vector<SegmentNodes> segments;
  [[nodiscard]] std::uint64_t cost() const { return positions.size() + 4 * segments.size(); }
  void append(const Members& other) {
    positions.insert(positions.end(), other.positions.begin(), other.positions.end());
    segments.insert(segments.end(), other.segments.begin(), other.segments.end());
  }
};

struct SegmentHash {
  std::size_t operator()(const SegmentNodes& nodes) const noexcept {
    std::uint64_t hash = 0;
    for (const NodeIndex node : nodes) {
      hash = (hash ^ node.value) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash);
  }
};

/// Keeps the first of equal entries and the order; drops what is in `removed`.
template <class Value, class Hash>
void keep_unique(std::vector<Value>& values, const std::vector<Value>& removed, Hash) {
  std::unordered_set<Value, Hash> seen(removed.begin(), removed.end());
  std::erase_if(values, [&](const Value& value) { return !seen.insert(value).second; });
}

void keep_unique(Members& members, const Members& removed) {
  // Positions that rise all the way, as most do, have no equals.
  const bool rising = std::adjacent_find(members.positions.begin(), members.positions.end(), std::greater_equal<>()) ==
                      members.positions.end();
  if (!rising || !removed.positions.empty())
    keep_unique(members.positions, removed.positions, std::hash<std::uint32_t>{});
  if (!members.segments.empty()) keep_unique(members.segments, removed.segments, SegmentHash{});
}

/// Members of ids that do not exist, for one message per set.
struct Unknown {
  std::size_t count = 0;
  std::vector<std::int64_t> first;
  void add(std::int64_t id) {
    if (count++ < 5) first.push_back(id);
  }
};

/// Finds elements, nodes and parts that belong to one another.
class MeshIndex {
 public:
  explicit MeshIndex(const Model& model) : model_(model) {}

  [[nodiscard]] std::size_t count(SetKind kind) const {
    if (kind == SetKind::part) return model_.parts.size();
    std::size_t size = 0;
    visit(kind, [&](const auto& table) { size = table.size(); });
    return size;
  }
  [[nodiscard]] std::optional<std::uint32_t> find(SetKind kind, std::int64_t id) const {
    if (kind == SetKind::part) {
      const auto part = model_.part_of_id.find(id);
      return part == model_.part_of_id.end() ? std::nullopt : std::optional(part->second.value);
    }
    std::optional<std::uint32_t> found;
    visit(kind, [&](const auto& table) { found = table.lookup.find(id); });
    return found;
  }
  /// visit(id, position) for all that exist in a range of ids, until it returns false.
  template <class Visit>
  void for_each_in(SetKind kind, std::int64_t first, std::int64_t last, const Visit& visitor) const {
    if (kind == SetKind::part) {
      for (auto part = model_.part_of_id.lower_bound(first); part != model_.part_of_id.end(); ++part)
        if (part->first > last || !visitor(part->first, part->second.value)) return;
      return;
    }
    visit(kind, [&](const auto& table) { table.lookup.for_each_in(first, last, visitor); });
  }
  /// Calls visitor(table) with the table of nodes or of elements of a kind.
  template <class Visitor>
  void visit(SetKind kind, const Visitor& visitor) const {
    const Mesh& mesh = model_.mesh;
    switch (kind) {
      case SetKind::node:
        return visitor(mesh.nodes);
      case SetKind::shell:
        return visitor(static_cast<const Elements<4>&>(mesh.shells));
      case SetKind::solid:
        return visitor(mesh.solids);
      case SetKind::thick_shell:
        return visitor(mesh.thick_shells);
      case SetKind::beam:
        return visitor(mesh.beams);
      case SetKind::discrete:
        return visitor(mesh.discrete);
      case SetKind::part:
      case SetKind::segment:
        return;
    }
  }

 private:
  const Model& model_;
};

constexpr SetKind element_kinds[] = {SetKind::shell, SetKind::solid, SetKind::thick_shell, SetKind::beam,
                                     SetKind::discrete};

bool is_element(SetKind kind) {
  return std::find(std::begin(element_kinds), std::end(element_kinds), kind) != std::end(element_kinds);
}

class Resolver {
 public:
  explicit Resolver(Context& context) : context_(context), index_(context.model) {}

  void run() {
    for (std::size_t k = 0; k < set_kinds; ++k)
      for (const auto& [id, raw] : context_.sets.of_kind[k]) resolve(static_cast<SetKind>(k), id, 0);
    Sets& sets = context_.model.sets;
    store<NodeIndex>(SetKind::node, sets.nodes);
    store<PartIndex>(SetKind::part, sets.parts);
    store<std::uint32_t>(SetKind::shell, sets.shells);
    store<std::uint32_t>(SetKind::solid, sets.solids);
    store<std::uint32_t>(SetKind::thick_shell, sets.thick_shells);
    store<std::uint32_t>(SetKind::beam, sets.beams);
    store<std::uint32_t>(SetKind::discrete, sets.discrete);
    for (auto& [id, raw] : context_.sets.of(SetKind::segment)) {
      auto& set = sets.segments[id];
      fill(set, id, raw);
      set.members = std::move(done(SetKind::segment)[id].segments);
    }
  }

 private:
  enum class State : std::uint8_t { open, done };

  std::map<std::int64_t, Members>& done(SetKind kind) { return done_[static_cast<std::size_t>(kind)]; }
  std::map<std::int64_t, State>& state(SetKind kind) { return state_[static_cast<std::size_t>(kind)]; }

  template <class Member>
  static void fill(Set<Member>& set, std::int64_t id, RawSet& raw) {
    set.id = id;
    set.title = std::move(raw.title);
    set.defaults = raw.defaults;
    set.place = raw.place;
  }
  template <class Member>
  void store(SetKind kind, std::map<std::int64_t, Set<Member>>& table) {
    for (auto& [id, raw] : context_.sets.of(kind)) {
      Set<Member>& set = table[id];
      fill(set, id, raw);
      Members& members = done(kind)[id];
      set.members.reserve(members.positions.size());
      for (const std::uint32_t position : members.positions) set.members.emplace_back(position);
      members = {};
    }
  }

  bool spend(std::uint64_t steps) {
    if (steps <= steps_left_) {
      steps_left_ -= steps;
      return true;
    }
    if (!exhausted_)
      context_.error(current_, "the sets of this deck have too many members in all; they are incomplete from here on");
    exhausted_ = true;
    steps_left_ = 0;
    return false;
  }

  /// The members of a set; nullptr where it is not defined.
  const Members* resolve(SetKind kind, std::int64_t id, int depth) {
    static const Members nothing;
    const auto raw = context_.sets.of(kind).find(id);
    if (raw == context_.sets.of(kind).end()) return nullptr;
    const auto [entry, is_new] = state(kind).try_emplace(id, State::open);
    if (!is_new) {
      if (entry->second == State::done) return &done(kind)[id];
      context_.error(raw->second.place,
                     fmt::format("{} {} contains itself; that part is taken as empty", name(kind), id));
      return &nothing;
    }
    if (depth > max_depth) {
      context_.error(raw->second.place,
                     fmt::format("{} {} is nested more than {} deep; it is taken as empty", name(kind), id, max_depth));
    } else {
      Members members = build(kind, raw->second, depth);
      done(kind)[id] = std::move(members);
    }
    entry->second = State::done;
    return &done(kind)[id];
  }

  Members build(SetKind kind, const RawSet& raw, int depth) {
    Members members;
    Unknown unknown;
    bool tidy = true;
    for (const SetClause& clause : raw.clauses) {
      current_ = raw.place;
      Members found = evaluate(kind, raw, clause, depth, unknown);
      if (!spend(found.cost())) break;
      if (clause.remove) {
        if (!spend(members.cost())) break;
        keep_unique(members, found);
        tidy = true;
      } else {
        members.append(found);
        tidy = false;
      }
    }
    if (!tidy) keep_unique(members, {});
    report(kind, raw, unknown);
    return members;
  }

  void report(SetKind kind, const RawSet& raw, const Unknown& unknown) {
    if (unknown.count == 0) return;
    context_.unknown(fmt::format("{} {} names {} {} not defined ({}{})", name(kind), raw.id, unknown.count,
                                 unknown.count == 1 ? "member that is" : "members that are",
                                 fmt::join(unknown.first, ", "), unknown.count > unknown.first.size() ? ", …" : ""),
                     raw.place);
  }

  Members evaluate(SetKind own, const RawSet& raw, const SetClause& clause, int depth, Unknown& unknown) {
    switch (clause.source) {
      case Source::members:
        return convert(members_of(clause, unknown), clause.of, own, raw);
      case Source::ranges:
        return ranges(own, clause.ids, 2);
      case Source::increments:
        return ranges(own, clause.ids, 3);
      case Source::sets:
        return convert(united(clause, raw, depth, unknown), clause.of, own, raw);
      case Source::intersect:
        return intersected(own, clause, depth, unknown);
      case Source::boxes:
        return in_boxes(own, clause.ids, unknown);
      case Source::all:
        return all(own);
    }
    return {};
  }

  Members members_of(const SetClause& clause, Unknown& unknown) {
    Members members;
    if (clause.of == SetKind::segment) return segments_of(clause.ids, unknown);
    members.positions.reserve(clause.ids.size());
    for (const std::int64_t id : clause.ids)
      if (const auto position = index_.find(clause.of, id))
        members.positions.push_back(*position);
      else
        unknown.add(id);
    return members;
  }

  /// Four node ids each; a blank or repeated last one makes a triangle.
  Members segments_of(const std::vector<std::int64_t>& ids, Unknown& unknown) {
    Members members;
    const IdLookup& nodes = context_.model.mesh.nodes.lookup;
    for (std::size_t i = 0; i + 3 < ids.size(); i += 4) {
      SegmentNodes segment{};
      std::int64_t bad = -1;
      for (std::size_t j = 0; j < 4 && bad < 0; ++j) {
        const std::int64_t id = j == 3 && ids[i + 3] == 0 ? ids[i + 2] : ids[i + j];
        const auto node = nodes.find(id);
        if (node)
          segment[j] = NodeIndex(*node);
        else
          bad = std::max<std::int64_t>(id, 0);
      }
      if (bad < 0)
        members.segments.push_back(segment);
      else
        unknown.add(bad);
    }
    return members;
  }

  Members ranges(SetKind kind, const std::vector<std::int64_t>& ids, std::size_t stride) {
    Members members;
    for (std::size_t i = 0; i + stride <= ids.size(); i += stride) {
      const std::int64_t first = ids[i], last = ids[i + 1],
                         step = stride == 3 ? std::max<std::int64_t>(1, ids[i + 2]) : 1;
      if (first == 0 && last == 0) continue;
      // Every range may run over all entities, so each costs at least one step and stops when nothing is left.
      if (!spend(1)) break;
      index_.for_each_in(kind, first, last, [&](std::int64_t id, std::uint32_t position) {
        if (!spend(1)) return false;
        if ((id - first) % step == 0) members.positions.push_back(position);
        return true;
      });
    }
    return members;
  }

  /// Sets of one kind together; a negative number means all ids from the one before to it.
  Members united(const SetClause& clause, const RawSet& raw, int depth, Unknown& unknown) {
    Members members;
    const auto add = [&](std::int64_t id) {
      const Members* part = resolve(clause.of, id, depth + 1);
      current_ = raw.place;
      if (part == nullptr) return unknown.add(id);
      if (spend(part->cost())) members.append(*part);
    };
    std::int64_t previous = 0;
    for (const std::int64_t id : clause.ids) {
      if (id >= 0 || previous <= 0) {
        add(id);
      } else {
        const auto& sets = context_.sets.of(clause.of);
        // -id of the lowest number would not exist.
        const std::int64_t last = id == std::numeric_limits<std::int64_t>::min() ? previous : -id;
        for (auto set = sets.upper_bound(previous); set != sets.end() && set->first <= last && spend(1); ++set)
          add(set->first);
      }
      previous = id;
    }
    return members;
  }

  Members intersected(SetKind kind, const SetClause& clause, int depth, Unknown& unknown) {
    Members members;
    bool first = true;
    for (const std::int64_t id : clause.ids) {
      const Members* set = resolve(kind, id, depth + 1);
      if (set == nullptr) {
        unknown.add(id);
        continue;
      }
      if (!spend(set->cost() + members.cost())) break;
      if (first) {
        members = *set;
      } else {
        const std::unordered_set<std::uint32_t> positions(set->positions.begin(), set->positions.end());
        const std::unordered_set<SegmentNodes, SegmentHash> segments(set->segments.begin(), set->segments.end());
        std::erase_if(members.positions, [&](std::uint32_t p) { return !positions.contains(p); });
        std::erase_if(members.segments, [&](const SegmentNodes& s) { return !segments.contains(s); });
      }
      first = false;
    }
    return members;
  }

  [[nodiscard]] Members all(SetKind kind) {
    Members members;
    if (kind == SetKind::segment) return surface([](const auto&, std::uint32_t) { return true; });
    const std::size_t count = index_.count(kind);
    if (!spend(count)) return members;
    members.positions.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) members.positions[i] = i;
    return members;
  }

  /// What lies in one of the boxes with all its nodes.
  Members in_boxes(SetKind kind, const std::vector<std::int64_t>& ids, Unknown& unknown) {
    Members members;
    for (const std::int64_t id : ids) {
      const auto box = context_.model.boxes.find(id);
      if (box == context_.model.boxes.end()) {
        unknown.add(id);
        continue;
      }
      const auto& x = context_.model.mesh.nodes.x;
      if (!spend(x.size())) break;
      const auto inside = [&](NodeIndex node) {
        return node == none<NodeIndex> || box->second.contains(x[node.value]);
      };
      const auto element_inside = [&](const auto& table, std::uint32_t i) {
        return std::all_of(table.nodes[i].begin(), table.nodes[i].end(), inside);
      };
      if (kind == SetKind::node) {
        for (std::uint32_t i = 0; i < x.size(); ++i)
          if (inside(NodeIndex(i))) members.positions.push_back(i);
      } else if (kind == SetKind::segment) {
        members.append(surface(element_inside));
      } else if (kind == SetKind::part) {
        parts_inside(inside, members);
      } else {
        for_each_element(kind, element_inside, members);
      }
    }
    return members;
  }

  template <class Select>
  void for_each_element(SetKind kind, const Select& select, Members& members) {
    if (!is_element(kind) || !spend(index_.count(kind))) return;
    index_.visit(kind, [&](const auto& table) {
      if constexpr (requires { table.part; })
        for (std::uint32_t i = 0; i < table.size(); ++i)
          if (select(table, i)) members.positions.push_back(i);
    });
  }

  /// Parts with elements, all of them inside.
  template <class Inside>
  void parts_inside(const Inside& inside, Members& members) {
    std::vector<std::uint8_t> has(context_.model.parts.size()), out(context_.model.parts.size());
    for (const SetKind kind : element_kinds)
      index_.visit(kind, [&](const auto& table) {
        if constexpr (requires { table.part; })
          for (std::uint32_t i = 0; i < table.size(); ++i) {
            if (table.part[i] == none<PartIndex>) continue;
            has[table.part[i].value] = 1;
            if (!std::all_of(table.nodes[i].begin(), table.nodes[i].end(), inside)) out[table.part[i].value] = 1;
          }
      });
    for (std::uint32_t i = 0; i < has.size(); ++i)
      if (has[i] != 0 && out[i] == 0) members.positions.push_back(i);
  }

  /// Shells, and the faces of solids and thick shells that no second selected element has.
  template <class Select>
  Members surface(const Select& select) {
    Members result, shells, solids, thick_shells;
    for_each_element(SetKind::shell, select, shells);
    for_each_element(SetKind::solid, select, solids);
    for_each_element(SetKind::thick_shell, select, thick_shells);
    result.append(as_segments(SetKind::shell, shells));
    result.append(as_segments(SetKind::solid, solids));
    result.append(as_segments(SetKind::thick_shell, thick_shells));
    return result;
  }

  [[nodiscard]] Members as_segments(SetKind kind, const Members& elements) const {
    const Mesh& mesh = context_.model.mesh;
    Members result;
    if (kind == SetKind::shell)
      for (const std::uint32_t i : elements.positions) result.segments.push_back(mesh.shells.nodes[i]);
    else
      result.segments = exterior_faces(kind == SetKind::solid ? mesh.solids : mesh.thick_shells, elements.positions);
    return result;
  }

  /// Turns things of one kind into those of another: elements into their nodes or faces, parts into their elements.
  Members convert(Members members, SetKind from, SetKind to, const RawSet& raw) {
    if (from == to) return members;
    if (to == SetKind::node) return nodes_of(from, members);
    if (from == SetKind::part && (is_element(to) || to == SetKind::segment)) {
      std::vector<std::uint8_t> wanted(context_.model.parts.size());
      for (const std::uint32_t part : members.positions) wanted[part] = 1;
      const auto select = [&](const auto& table, std::uint32_t i) {
        return table.part[i] != none<PartIndex> && wanted[table.part[i].value] != 0;
      };
      if (to == SetKind::segment) return surface(select);
      Members result;
      for_each_element(to, select, result);
      return result;
    }
    if (to == SetKind::segment && (from == SetKind::shell || from == SetKind::solid || from == SetKind::thick_shell))
      return as_segments(from, members);
    context_.warning(raw.place, fmt::format("{} {} asks for members by way of a {}, which is not supported; the set is "
                                            "incomplete",
                                            name(to), raw.id, name(from)));
    return {};
  }

  Members nodes_of(SetKind from, const Members& members) {
    Members result;
    std::vector<std::uint8_t> seen(context_.model.mesh.nodes.size());
    if (!spend(seen.size() / 64 + 1)) return result;
    const auto add = [&](const auto& nodes) {
      for (const NodeIndex node : nodes) {
        if (node == none<NodeIndex> || seen[node.value] != 0) continue;
        seen[node.value] = 1;
        result.positions.push_back(node.value);
      }
    };
    if (from == SetKind::segment) {
      for (const SegmentNodes& segment : members.segments) add(segment);
    } else if (from == SetKind::part) {
      std::vector<std::uint8_t> wanted(context_.model.parts.size());
      for (const std::uint32_t part : members.positions) wanted[part] = 1;
      const auto add_table = [&](const auto& table) {
        if (!spend(table.size())) return;
        for (std::size_t i = 0; i < table.size(); ++i)
          if (table.part[i] != none<PartIndex> && wanted[table.part[i].value] != 0) add(table.nodes[i]);
      };
      for (const SetKind kind : element_kinds)
        index_.visit(kind, [&](const auto& table) {
          if constexpr (requires { table.part; }) add_table(table);
        });
      add_table(context_.model.mesh.particles);
    } else {
      index_.visit(from, [&](const auto& table) {
        if constexpr (requires { table.part; })
          for (const std::uint32_t i : members.positions) add(table.nodes[i]);
      });
    }
    return result;
  }

  Context& context_;
  MeshIndex index_;
  std::array<std::map<std::int64_t, Members>, set_kinds> done_;
  std::array<std::map<std::int64_t, State>, set_kinds> state_;
  std::uint64_t steps_left_ = max_steps;
  bool exhausted_ = false;
  Place current_;
};

}  // namespace

void resolve_sets(Context& context) { Resolver(context).run(); }

}  // namespace gapcheck::model
