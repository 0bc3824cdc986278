#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "base/number.hpp"
#include "keyword/upper_case.hpp"
#include "model/read/cards.hpp"
#include "model/read/context.hpp"

namespace gapcheck::model {
namespace {

using Source = SetClause::Source;

struct KindTraits {
  SetKind kind;
  std::string_view keyword;  ///< "SET_NODE"
  std::string_view words;    ///< in messages
  IdKind member;
  bool has_defaults;  ///< DA1 … DA4 after the id
};

constexpr std::array<KindTraits, set_kinds> kinds{{
    {SetKind::node, "SET_NODE", "node set", IdKind::node, true},
    {SetKind::part, "SET_PART", "part set", IdKind::part, true},
    {SetKind::segment, "SET_SEGMENT", "segment set", IdKind::node, true},
    {SetKind::shell, "SET_SHELL", "shell set", IdKind::element, true},
    {SetKind::solid, "SET_SOLID", "solid set", IdKind::element, false},
    {SetKind::thick_shell, "SET_TSHELL", "thick shell set", IdKind::element, false},
    {SetKind::beam, "SET_BEAM", "beam set", IdKind::element, false},
    {SetKind::discrete, "SET_DISCRETE", "discrete set", IdKind::element, false},
    {SetKind::branch, "SET_PART_TREE", "branch", IdKind::set, false},
}};

const KindTraits& traits_of(SetKind kind) { return kinds[static_cast<std::size_t>(kind)]; }

const KindTraits& traits_of(const Block& block) {
  const auto matches = [&](const KindTraits& traits) {
    return block.name == traits.keyword || block.name.starts_with(std::string(traits.keyword) + '_');
  };
  return *std::find_if(kinds.begin(), kinds.end(), matches);
}

/// The ids of all lines to the end of the block, `per_line` in each; zeros are left out.
std::vector<std::int64_t> read_ids(CardReader& reader, IdKind kind, std::size_t per_line) {
  const CardLayout layout = id_line(per_line, 10, kind);
  std::vector<std::int64_t> ids;
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    const Card card = reader.next(layout);
    for (std::size_t i = 0; i < per_line; ++i)
      if (const std::int64_t id = card.integer(i); id != 0) ids.push_back(id);
  }
  return ids;
}

/// The same with zeros kept, for rows in which the position of a number matters.
std::vector<std::int64_t> read_rows_of_ids(CardReader& reader, const CardLayout& layout) {
  std::vector<std::int64_t> ids;
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    const Card card = reader.next(layout);
    for (std::size_t i = 0; i < card.size(); ++i) ids.push_back(card.integer(i));
  }
  return ids;
}

CardLayout increment_line(IdKind kind) {
  CardLayout layout = id_line(3, 10, kind);
  layout.fields[2].id = IdKind::plain;
  return layout;
}

/// Pairs of set id and kind of set.
void read_advanced(Context& context, CardReader& reader, RawSet& set) {
  constexpr SetKind types[] = {SetKind::node,    SetKind::shell,    SetKind::beam,       SetKind::solid,
                               SetKind::segment, SetKind::discrete, SetKind::thick_shell};
  CardLayout layout = id_line(8, 10, IdKind::set);
  for (std::size_t i = 1; i < 8; i += 2) layout.fields[i].id = IdKind::plain;
  const std::vector<std::int64_t> ids = read_rows_of_ids(reader, layout);
  for (std::size_t i = 0; i + 1 < ids.size(); i += 2) {
    if (ids[i] == 0) continue;
    const std::int64_t type = ids[i + 1] == 0 ? 1 : ids[i + 1];
    if (type < 1 || type > 7) {
      context.error(set.place, fmt::format("set {}: {} is not a type of set (1 to 7)", set.id, type));
      continue;
    }
    set.clauses.push_back({Source::sets, types[type - 1], false, {ids[i]}});
  }
}

/// One word of the first field of a general set's line.
struct GeneralOption {
  std::string_view word;
  Source source;
  SetKind of;
};
constexpr GeneralOption general_options[] = {
    {"ALL", Source::all, SetKind::node},
    {"BOX", Source::boxes, SetKind::node},
    {"NODE", Source::members, SetKind::node},
    {"PART", Source::members, SetKind::part},
    {"SEG", Source::members, SetKind::segment},
    {"SHELL", Source::members, SetKind::shell},
    {"SOLID", Source::members, SetKind::solid},
    {"TSHELL", Source::members, SetKind::thick_shell},
    {"BEAM", Source::members, SetKind::beam},
    {"DISCRETE", Source::members, SetKind::discrete},
    {"SET_NODE", Source::sets, SetKind::node},
    {"SET_PART", Source::sets, SetKind::part},
    {"SET_SEGM", Source::sets, SetKind::segment},
    {"SET_SEGMEN", Source::sets, SetKind::segment},
    {"SET_SHELL", Source::sets, SetKind::shell},
    {"SET_SOLID", Source::sets, SetKind::solid},
    {"SET_TSHELL", Source::sets, SetKind::thick_shell},
    {"SET_BEAM", Source::sets, SetKind::beam},
    {"SET_DISCR", Source::sets, SetKind::discrete},
    {"SET_DISCRE", Source::sets, SetKind::discrete},
    {"SET_SPRING", Source::sets, SetKind::discrete},
};

/// What a word requests; a `D` before it means removal. `ELEM` is an element of the set's own kind.
std::optional<SetClause> clause_of(std::string_view word, SetKind own) {
  for (const bool remove : {false, true}) {
    if (remove) {
      if (!word.starts_with('D')) break;
      word.remove_prefix(1);
    }
    if (word == "ELEM") return SetClause{Source::members, own, remove, {}};
    for (const GeneralOption& option : general_options)
      if (word == option.word) return SetClause{option.source, option.of, remove, {}};
  }
  return std::nullopt;
}

IdKind id_kind(const SetClause& clause) {
  switch (clause.source) {
    case Source::sets:
      return IdKind::set;
    case Source::boxes:
      return IdKind::define;
    default:
      return traits_of(clause.of).member;
  }
}

void read_general(Context& context, CardReader& reader, SetKind own, RawSet& set) {
  static const CardLayout layout = [] {
    CardLayout line = id_line(8, 10, IdKind::plain);
    line.fields[0].type = FieldType::text;
    return line;
  }();
  std::optional<SetClause> open;  // a line without a word continues the one before
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    const Card card = reader.next(layout);
    const std::string word = keyword::upper_case(card.text(std::size_t{0}));
    if (!word.empty()) {
      open = clause_of(word, own);
      if (!open)
        context.warning(
            Context::place(reader.block(), card.line()),
            fmt::format("{} {}: the option {} is not supported; the set is incomplete", name(own), set.id, word));
    }
    if (!open) continue;
    // In general segment sets the last four numbers are attributes of the new segments.
    const bool attributes = own == SetKind::segment && !open->remove && open->of != SetKind::segment;
    const std::size_t last = open->source == Source::members && open->of == SetKind::segment ? 4 : attributes ? 3 : 7;
    SetClause clause{open->source, open->of, open->remove, {}};
    for (std::size_t i = 1; i <= last; ++i) {
      const std::int64_t id = context.with_offset(reader.block(), id_kind(clause), card.integer(i));
      if (id != 0 || clause.of == SetKind::segment) clause.ids.push_back(id);
    }
    // Lines of the same word are one step: otherwise a million lines would be a million passes over the set.
    if (!set.clauses.empty() && set.clauses.back().source == clause.source && set.clauses.back().of == clause.of &&
        set.clauses.back().remove == clause.remove)
      set.clauses.back().ids.insert(set.clauses.back().ids.end(), clause.ids.begin(), clause.ids.end());
    else
      set.clauses.push_back(std::move(clause));
  }
}

void read_members(CardReader& reader, const KindTraits& traits, const Options& options, RawSet& set) {
  const auto add = [&](Source source, std::vector<std::int64_t> ids) {
    set.clauses.push_back({source, traits.kind, false, std::move(ids)});
  };
  if (options.has("INCREMENT"))
    add(Source::increments, read_rows_of_ids(reader, increment_line(traits.member)));
  else if (options.has("GENERATE"))
    add(Source::ranges, read_rows_of_ids(reader, id_line(8, 10, traits.member)));
  else if (options.has("INTERSECT"))
    add(Source::intersect, read_ids(reader, IdKind::set, 8));
  else if (options.has("ADD"))
    add(Source::sets, read_ids(reader, IdKind::set, 8));
  else if (traits.kind == SetKind::segment)
    add(Source::members, read_rows_of_ids(reader, id_line(4, 10, IdKind::node)));
  else
    add(Source::members, read_ids(reader, traits.member, options.has("COLUMN") ? 1 : 8));
}

void add_set(Context& context, const KindTraits& traits, RawSet set) {
  auto& table = context.sets.of(traits.kind);
  const auto [entry, is_new] = table.try_emplace(set.id, RawSet{});
  RawSet& stored = entry->second;
  if (is_new) {
    stored = std::move(set);
  } else if (stored.collect && set.collect) {
    for (SetClause& clause : set.clauses) stored.clauses.push_back(std::move(clause));
  } else {
    context.duplicate(traits.words, set.id, stored.place, set.place);
  }
}

/// The components of a branch: positive numbers are branches, negative ones parts.
void read_components(Context& context, CardReader& reader, RawSet& set) {
  SetClause parts{Source::members, SetKind::part, false, {}}, branches{Source::sets, SetKind::branch, false, {}};
  for (const std::int64_t id : read_ids(reader, IdKind::plain, 8))
    if (id > 0)
      branches.ids.push_back(context.with_offset(reader.block(), IdKind::set, id));
    else  // the lowest number has no opposite
      parts.ids.push_back(
          context.with_offset(reader.block(), IdKind::part, -std::max(id, -std::numeric_limits<std::int64_t>::max())));
  set.clauses = {std::move(parts), std::move(branches)};
}

}  // namespace

std::string_view name(SetKind kind) { return traits_of(kind).words; }

void read_part_tree(Context& context, const Block& block, const Options& options) {
  static const CardLayout header = id_line(1, 10, IdKind::set);  // its card looks into it
  const KindTraits& traits = traits_of(SetKind::branch);
  CardReader reader(context.deck, block, context.diagnostics);
  RawSet set;
  set.place = Context::place(block, block.line);
  if (options.has("TITLE")) reader.skip();
  if (reader.at_end()) {
    context.error(set.place, fmt::format("*{} ends before the card with the branch's id", block.name));
    return;
  }
  const Card card = reader.next(header);
  set.id = card.integer(std::size_t{0});
  set.place.line = card.line();
  if (!reader.at_end()) set.title = reader.next(text_line()).text(std::size_t{0});
  if (set.id <= 0) {
    context.bad_id(set.place, fmt::format("{} id {} is not positive; the branch is left out", traits.words, set.id));
    return;
  }
  read_components(context, reader, set);
  add_set(context, traits, std::move(set));
}

void read_set(Context& context, const Block& block, const Options& options) {
  static const CardLayout header = id_and_reals(IdKind::set, 4);
  const KindTraits& traits = traits_of(block);
  CardReader reader(context.deck, block, context.diagnostics);
  RawSet set;
  set.place = Context::place(block, block.line);
  if (options.has("TITLE")) set.title = reader.next(text_line()).text(std::size_t{0});
  if (reader.at_end()) {
    context.error(set.place, fmt::format("*{} ends before the card with the set's id", block.name));
    return;
  }
  const Card card = reader.next(header);
  set.id = card.integer(std::size_t{0});
  set.place.line = card.line();
  set.collect = options.has("COLLECT");
  if (set.id <= 0) {
    context.bad_id(set.place, fmt::format("{} id {} is not positive; the set is left out", traits.words, set.id));
    return;
  }
  const bool list = !options.any({"ADD", "INTERSECT"});
  if (traits.has_defaults && list)
    for (std::size_t i = 0; i < 4; ++i) set.defaults[i] = card.real(i + 1);
  if (options.has("GENERAL"))
    read_general(context, reader, traits.kind, set);
  else if (options.has("ADVANCED"))
    read_advanced(context, reader, set);
  else
    read_members(reader, traits, options, set);
  add_set(context, traits, std::move(set));
}

}  // namespace gapcheck::model
