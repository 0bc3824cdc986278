#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "model/read/context.hpp"
#include "model/selection.hpp"

namespace gapcheck::model {
namespace {

using Source = SetClause::Source;

/// Sets of sets may be nested this deep.
constexpr int max_depth = 100;

/// Members of ids that do not exist, for one message per set.
struct Unknown {
  std::size_t count = 0;
  std::vector<std::int64_t> first;
  void add(std::int64_t id) {
    if (count++ < 5) first.push_back(id);
  }
};

/// One set while its clauses are resolved to members.
struct Job {
  SetKind kind;
  const RawSet& raw;
  int depth = 0;
  Unknown unknown;
};

class Resolver {
 public:
  explicit Resolver(Context& context) : context_(context), selection_(context.model, budget_) {}

  void run() {
    for (std::size_t k = 0; k < set_kinds; ++k)
      for (const auto& [id, raw] : context_.sets.of_kind[k]) resolve(static_cast<SetKind>(k), id, 0);
    Sets& sets = context_.model.sets;
    store(SetKind::node, sets.nodes);
    store(SetKind::part, sets.parts);
    store(SetKind::segment, sets.segments);
    store(SetKind::shell, sets.shells);
    store(SetKind::solid, sets.solids);
    store(SetKind::thick_shell, sets.thick_shells);
    store(SetKind::beam, sets.beams);
    store(SetKind::discrete, sets.discrete);
    store(SetKind::branch, sets.branches);
  }

 private:
  /// A set whose members are known; `open` while they are being resolved.
  struct Entry {
    bool open = true;
    Members members;
  };
  std::map<std::int64_t, Entry>& entries(SetKind kind) { return entries_[static_cast<std::size_t>(kind)]; }

  template <class Member>
  void store(SetKind kind, std::map<std::int64_t, Set<Member>>& table) {
    for (auto& [id, raw] : context_.sets.of(kind)) {
      Members members = std::move(entries(kind)[id].members);
      Set<Member> set{id, std::move(raw.title), {}, raw.defaults, raw.place};
      if constexpr (std::is_same_v<Member, SegmentNodes>)
        set.members = std::move(members.segments);
      else
        set.members.reserve(members.positions.size());
      if constexpr (!std::is_same_v<Member, SegmentNodes>)
        for (const std::uint32_t position : members.positions) set.members.emplace_back(position);
      table.emplace(id, std::move(set));
    }
  }

  /// The members of a set; nullptr if it is not defined.
  const Members* resolve(SetKind kind, std::int64_t id, int depth) {
    static const Members nothing;
    const auto raw = context_.sets.of(kind).find(id);
    if (raw == context_.sets.of(kind).end()) return nullptr;
    const auto [place, is_new] = entries(kind).try_emplace(id);
    Entry& entry = place->second;
    if (!is_new) {
      if (!entry.open) return &entry.members;
      context_.error(raw->second.place,
                     fmt::format("{} {} contains itself; that part is taken as empty", name(kind), id));
      return &nothing;
    }
    if (depth > max_depth)
      context_.error(raw->second.place,
                     fmt::format("{} {} is nested more than {} deep; it is taken as empty", name(kind), id, max_depth));
    else
      entry.members = build({kind, raw->second, depth, {}});
    entry.open = false;
    return &entry.members;
  }

  Members build(Job job) {
    Members members;
    bool unique = true;
    for (const SetClause& clause : job.raw.clauses) {
      const Members found = evaluate(job, clause);
      if (!spend(job, found.cost() + (clause.remove ? members.cost() : 0))) break;
      if (clause.remove)
        members.keep_unique(found);
      else
        members.append(found);
      unique = clause.remove;
    }
    if (!unique) members.keep_unique({});
    report(job);
    return members;
  }

  bool spend(const Job& job, std::uint64_t steps) {
    if (!budget_.spend(steps) && !reported_) {
      context_.error(job.raw.place,
                     "the sets of this deck have too many members in all; they are incomplete from here on");
      reported_ = true;
    }
    return !reported_;
  }

  void report(const Job& job) {
    const Unknown& unknown = job.unknown;
    if (unknown.count == 0) return;
    context_.unknown(
        fmt::format("{} {} names {} not defined ({}{})", name(job.kind), job.raw.id,
                    unknown.count == 1 ? "a member that is" : fmt::format("{} members that are", unknown.count),
                    fmt::join(unknown.first, ", "), unknown.count > unknown.first.size() ? ", …" : ""),
        job.raw.place);
  }

  Members evaluate(Job& job, const SetClause& clause) {
    switch (clause.source) {
      case Source::members:
        return converted(job, clause, clause.of == SetKind::segment ? segments(job, clause) : listed(job, clause));
      case Source::ranges:
        return ranges(job, clause.ids, 2);
      case Source::increments:
        return ranges(job, clause.ids, 3);
      case Source::sets:
        return converted(job, clause, united(job, clause));
      case Source::intersect:
        return intersected(job, clause);
      case Source::boxes:
        return boxed(job, clause);
      case Source::all:
        return selection_.all(job.kind);
    }
    return {};
  }

  Members converted(const Job& job, const SetClause& clause, Members members) {
    if (auto result = selection_.convert(std::move(members), clause.of, job.kind)) return std::move(*result);
    context_.warning(job.raw.place, fmt::format("{} {} asks for members of a {}, which is not supported; the set is "
                                                "incomplete",
                                                name(job.kind), job.raw.id, name(clause.of)));
    return {};
  }

  Members listed(Job& job, const SetClause& clause) {
    Members members;
    members.positions.reserve(clause.ids.size());
    for (const std::int64_t id : clause.ids)
      if (const auto position = selection_.find(clause.of, id))
        members.positions.push_back(*position);
      else
        job.unknown.add(id);
    return members;
  }

  /// Four node ids each; a blank last one makes a triangle.
  Members segments(Job& job, const SetClause& clause) {
    Members members;
    const std::vector<std::int64_t>& ids = clause.ids;
    for (std::size_t i = 0; i + 3 < ids.size(); i += 4) {
      SegmentNodes segment{};
      std::optional<std::int64_t> bad;
      for (std::size_t j = 0; j < 4 && !bad; ++j) {
        const std::int64_t id = j == 3 && ids[i + 3] == 0 ? ids[i + 2] : ids[i + j];
        const auto node = selection_.find(SetKind::node, id);
        if (node)
          segment[j] = NodeIndex(*node);
        else
          bad = id;
      }
      if (bad)
        job.unknown.add(*bad);
      else
        members.segments.push_back(segment);
    }
    return members;
  }

  Members ranges(const Job& job, const std::vector<std::int64_t>& ids, std::size_t stride) {
    Members members;
    for (std::size_t i = 0; i + stride <= ids.size(); i += stride) {
      if (ids[i] == 0 && ids[i + 1] == 0) continue;
      members.append(selection_.range(job.kind, ids[i], ids[i + 1], stride == 3 ? ids[i + 2] : 1));
      if (!spend(job, 1)) break;
    }
    return members;
  }

  /// Sets of one kind together; a negative number means all ids from the one before to it.
  Members united(Job& job, const SetClause& clause) {
    Members members;
    const auto add = [&](std::int64_t id) {
      const Members* set = resolve(clause.of, id, job.depth + 1);
      if (set == nullptr)
        job.unknown.add(id);
      else if (spend(job, set->cost() + 1))
        members.append(*set);
    };
    std::int64_t previous = 0;
    for (const std::int64_t id : clause.ids) {
      if (id >= 0 || previous <= 0) {
        add(id);
      } else {
        const auto& sets = context_.sets.of(clause.of);
        // The lowest number has no opposite.
        const std::int64_t last = -std::max(id, -std::numeric_limits<std::int64_t>::max());
        for (auto set = sets.upper_bound(previous); set != sets.end() && set->first <= last && spend(job, 1); ++set)
          add(set->first);
      }
      previous = id;
    }
    return members;
  }

  Members intersected(Job& job, const SetClause& clause) {
    Members members;
    bool first = true;
    for (const std::int64_t id : clause.ids) {
      const Members* set = resolve(job.kind, id, job.depth + 1);
      if (set == nullptr) {
        job.unknown.add(id);
        continue;
      }
      if (!spend(job, set->cost() + members.cost())) break;
      if (first)
        members = *set;
      else
        members.intersect(*set);
      first = false;
    }
    return members;
  }

  Members boxed(Job& job, const SetClause& clause) {
    Members members;
    for (const std::int64_t id : clause.ids) {
      const auto box = context_.model.boxes.find(id);
      if (box == context_.model.boxes.end()) {
        job.unknown.add(id);
        continue;
      }
      members.append(selection_.in_box(job.kind, box->second));
      if (!spend(job, 1)) break;
    }
    return members;
  }

  Context& context_;
  Budget budget_;
  Selection selection_;
  bool reported_ = false;
  std::array<std::map<std::int64_t, Entry>, set_kinds> entries_;
};

}  // namespace

void resolve_sets(Context& context) { Resolver(context).run(); }

}  // namespace gapcheck::model
