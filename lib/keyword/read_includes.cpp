#include <algorithm>
#include <filesystem>
#include <set>

#include "base/number.hpp"
#include "keyword/deck_reader.hpp"
#include "keyword/transformation.hpp"

namespace gapcheck::keyword {
namespace {

constexpr std::size_t max_name = 236;
constexpr std::size_t max_include_paths = 200;

bool is_file(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error);
}

std::filesystem::path directory_of(const std::string& file) { return std::filesystem::path(file).parent_path(); }

double factor(const Card& card, std::string_view field) {
  const double value = card.real(field);
  return value == 0 ? 1 : value;
}

}  // namespace

/// The next file name of the block; a line that ends in " +" continues in the next. Nothing at the end of the block.
std::optional<DeckReader::IncludeName> DeckReader::next_name(CardReader& reader) {
  while (!reader.at_end() && trimmed(reader.peek()).empty()) reader.skip();
  if (reader.at_end()) return std::nullopt;
  IncludeName include{{}, reader.peek_line()};
  for (bool goes_on = true; goes_on && !reader.at_end();) {
    auto part = trimmed(reader.peek());
    goes_on = part.ends_with(" +");
    if (goes_on) part = trimmed(part.substr(0, part.size() - 2));
    if (include.name.size() <= max_name) include.name += part.substr(0, max_name + 1);
    reader.skip();
  }
  if (include.name.starts_with('&')) {
    const Block& block = reader.block();
    const auto* value = deck_.parameters_.find(include.name.substr(1), block.scope, block.order);
    if (const auto* text = value == nullptr ? nullptr : std::get_if<std::string>(value)) include.name = *text;
  }
  return include;
}

void DeckReader::read_include(const FileContext& context, const Block& block) {
  CardReader reader(deck_, block, diagnostics_);
  if (block.name == "INCLUDE") {
    while (const auto include = next_name(reader)) open_include(context, block, *include, context.transform);
  } else if (block.name == "INCLUDE_PATH" || block.name == "INCLUDE_PATH_RELATIVE") {
    read_include_path(block, block.name == "INCLUDE_PATH_RELATIVE");
  } else if (block.name == "INCLUDE_TRANSFORM") {
    read_include_transform(context, block);
  } else if (block.name == "INCLUDE_AUTO_OFFSET" || block.name == "INCLUDE_AUTO_OFFSET_USER") {
    read_include_auto_offset(context, block);
  } else {
    const auto include = next_name(reader);
    diagnostics_.warning(path_of(block.file), block.line,
                         "*" + block.name + " is not supported: \"" + (include ? include->name : "") +
                             "\" was not read; what it defines is missing from the model");
  }
}

void DeckReader::read_include_path(const Block& block, bool relative) {
  CardReader reader(deck_, block, diagnostics_);
  while (const auto path = next_name(reader)) {
    const auto base = relative ? directory_of(path_of(block.file)) : std::filesystem::path();
    const std::string full = (base / path->name).string();
    if (std::find(include_paths_.begin(), include_paths_.end(), full) != include_paths_.end()) continue;
    if (include_paths_.size() == max_include_paths) {
      diagnostics_.error(path_of(block.file), path->line,
                         "more than " + std::to_string(max_include_paths) + " include paths; this one is not used");
      return;
    }
    include_paths_.push_back(full);
  }
}

void DeckReader::read_include_transform(const FileContext& context, const Block& block) {
  CardReader reader(deck_, block, diagnostics_);
  const auto include = next_name(reader);
  if (!include) {
    diagnostics_.error(path_of(block.file), block.line, "*INCLUDE_TRANSFORM without a file name; give one");
    return;
  }
  Transform own;
  const auto offset = [&](const Card& card, IdKind kind, std::string_view field) {
    own.offset[static_cast<std::size_t>(kind)] = card.integer(field);
  };
  const Card ids = reader.next(card_layout("INCLUDE_TRANSFORM", "card2"));
  offset(ids, IdKind::node, "idnoff");
  offset(ids, IdKind::element, "ideoff");
  offset(ids, IdKind::part, "idpoff");
  offset(ids, IdKind::material, "idmoff");
  offset(ids, IdKind::set, "idsoff");
  offset(ids, IdKind::function, "idfoff");
  offset(ids, IdKind::define, "iddoff");
  offset(reader.next(card_layout("INCLUDE_TRANSFORM", "card3")), IdKind::other, "idroff");
  const Card factors = reader.next(card_layout("INCLUDE_TRANSFORM", "card4"));
  own.mass_factor = factor(factors, "fctmas");
  own.time_factor = factor(factors, "fcttim");
  own.length_factor = factor(factors, "fctlen");
  const Card last = reader.next(card_layout("INCLUDE_TRANSFORM", "card5"));
  const std::int64_t transformation = last.integer("tranid");
  while (!reader.at_end() && trimmed(reader.peek()).empty()) reader.skip();
  if (!reader.at_end())
    diagnostics_.error(path_of(block.file), reader.peek_line(),
                       "*INCLUDE_TRANSFORM has more lines than one file needs; give each file its own keyword");
  open_include(context, block, *include, add_transform(context, block, own, transformation, last.line()));
}

void DeckReader::read_include_auto_offset(const FileContext& context, const Block& block) {
  CardReader reader(deck_, block, diagnostics_);
  const auto include = next_name(reader);
  if (!include) return;
  if (block.name == "INCLUDE_AUTO_OFFSET") {
    diagnostics_.warning(path_of(block.file), block.line,
                         "*INCLUDE_AUTO_OFFSET: the ids of \"" + include->name +
                             "\" are read as they stand; use *INCLUDE_TRANSFORM to shift them");
    open_include(context, block, *include, context.transform);
    return;
  }
  Transform own;
  const Card ids = reader.next(card_layout("INCLUDE_AUTO_OFFSET_USER", "card2"));
  own.offset[static_cast<std::size_t>(IdKind::node)] = ids.integer("noffset");
  own.offset[static_cast<std::size_t>(IdKind::element)] = ids.integer("neoffset");
  open_include(context, block, *include, add_transform(context, block, own, 0, block.line));
}

/// The first place that has the file: working directory, directory of the main file, of the including file, the paths
/// of the deck so far, the paths of the options.
std::optional<std::string> DeckReader::find_include(const FileContext& context, const std::string& name) const {
  std::string slashes = name;
  std::replace(slashes.begin(), slashes.end(), '\\', '/');
  for (const std::string& written : std::set<std::string>{name, slashes}) {
    const std::filesystem::path file(written);
    if (file.is_absolute()) {
      if (is_file(file)) return file.string();
      continue;
    }
    std::vector<std::filesystem::path> directories{
        {}, directory_of(path_of(FileIndex(0))), directory_of(path_of(context.file))};
    directories.insert(directories.end(), include_paths_.begin(), include_paths_.end());
    directories.insert(directories.end(), options_.include_directories.begin(), options_.include_directories.end());
    for (const auto& directory : directories)
      if (const auto candidate = directory / file; is_file(candidate)) return candidate.string();
  }
  return std::nullopt;
}

bool DeckReader::may_include(const FileContext& context, const std::string& canonical, const Block& block,
                             const IncludeName& include) {
  const auto refuse = [&](const std::string& reason) {
    diagnostics_.error(path_of(block.file), include.line, "include \"" + include.name + "\" was not read: " + reason);
    return false;
  };
  if (context.depth >= options_.max_include_depth)
    return refuse("includes are nested more than " + std::to_string(options_.max_include_depth) + " deep");
  for (FileIndex file = context.file; file != none<FileIndex>; file = deck_.files_[file.value].includer)
    if (!canonical.empty() && canonical_[file.value] == canonical)
      return refuse("it includes itself; remove the *INCLUDE");
  return true;
}

/// An included file that is readable; null: the reason is already reported.
std::shared_ptr<KeywordFile> DeckReader::map_include(const std::string& path, const std::string& canonical,
                                                     const Block& block, std::uint32_t line) {
  auto file = open_file(path, canonical);
  if (!file) {
    diagnostics_.error(path_of(block.file), line, "include \"" + path + "\" " + file.error().message);
    return nullptr;
  }
  const std::string_view bytes = file.value()->bytes();
  if (bytes.empty()) {
    diagnostics_.warning(path_of(block.file), line, "include \"" + path + "\" is empty");
    return nullptr;
  }
  if (bytes.substr(0, 4096).find('\0') != std::string_view::npos) {
    diagnostics_.error(path_of(block.file), line, "include \"" + path + "\" is not a keyword file; it is binary");
    return nullptr;
  }
  return std::move(file).value();
}

void DeckReader::open_include(const FileContext& context, const Block& block, const IncludeName& include,
                              TransformIndex transform) {
  if (stopped_) return;
  // The main file is one of the files. Missing ones count as well: searching for each takes time.
  if (++includes_ >= options_.max_files) {
    diagnostics_.error(
        path_of(block.file), include.line,
        "the deck has more than " + std::to_string(options_.max_files) + " files; the rest was not read");
    stopped_ = true;
    return;
  }
  const bool bad_name = include.name.size() > max_name || include.name.find('\0') != std::string::npos;
  if (bad_name) {
    diagnostics_.error(path_of(block.file), include.line,
                       "the name of the include is longer than 236 characters or not a text; shorten it");
    return;
  }
  const auto path = find_include(context, include.name);
  if (!path) {
    ++deck_.counters_.missing_includes;
    diagnostics_.add({options_.skip_missing_includes ? Severity::warning : Severity::error, path_of(block.file),
                      include.line,
                      "include \"" + include.name +
                          "\" was not found; correct the name, or give its directory with -I or *INCLUDE_PATH"});
    return;
  }
  std::error_code error;
  const std::string canonical = std::filesystem::canonical(*path, error).string();
  if (!may_include(context, canonical, block, include)) return;
  const auto file = map_include(*path, canonical, block, include.line);
  if (file == nullptr) return;
  canonical_.push_back(canonical);
  FileContext inner = context;
  inner.file = add_file(*path, file->bytes(), &context, include.line);
  inner.transform = transform;
  inner.scope = deck_.parameters_.add_scope(context.scope);
  ++inner.depth;
  read_file(inner, file->marks());
}

TransformIndex DeckReader::add_transform(const FileContext& context, const Block& block, const Transform& own,
                                         std::int64_t transformation, std::uint32_t line) {
  Transform total = deck_.transforms_[context.transform.value];
  for (std::size_t i = 0; i < total.offset.size(); ++i)
    if (__builtin_add_overflow(total.offset[i], own.offset[i], &total.offset[i])) {
      diagnostics_.error(path_of(block.file), block.line, "*INCLUDE_TRANSFORM: the id offset is too large");
      total.offset[i] = 0;
    }
  total.length_factor *= own.length_factor;
  total.mass_factor *= own.mass_factor;
  total.time_factor *= own.time_factor;
  const TransformIndex index(static_cast<std::uint32_t>(deck_.transforms_.size()));
  deck_.transforms_.push_back(total);
  pending_.push_back({index, context.transform, transformation, block.file, line});
  return index;
}

/// A point x of the included file lies at Mp (fp (Mo fo x + so)) + sp, with the placement o of the include itself and
/// p of what encloses it.
void DeckReader::resolve_transforms() {
  if (std::none_of(pending_.begin(), pending_.end(), [](const auto& p) { return p.transformation != 0; })) return;
  std::map<std::int64_t, const Block*> definitions;
  for (const std::uint32_t position : transformations_) {
    const Block& block = deck_.blocks_[position];
    const std::int64_t id = transformation_id(deck_, block, diagnostics_);
    if (!definitions.emplace(id, &block).second)
      diagnostics_.error(path_of(block.file), block.line,
                         "*DEFINE_TRANSFORMATION " + std::to_string(id) + " is defined again; remove one of them");
  }
  std::map<std::int64_t, std::optional<Placement>> placements;
  for (const PendingTransform& pending : pending_) {
    Placement own;
    if (pending.transformation != 0) {
      const auto definition = definitions.find(pending.transformation);
      if (definition == definitions.end()) {
        diagnostics_.error(path_of(pending.file), pending.line,
                           "*INCLUDE_TRANSFORM refers to transformation " + std::to_string(pending.transformation) +
                               ", which is not defined; add *DEFINE_TRANSFORMATION or clear TRANID");
      } else {
        const auto [entry, is_new] = placements.try_emplace(pending.transformation);
        if (is_new) entry->second = read_transformation(deck_, *definition->second, diagnostics_);
        own = entry->second.value_or(Placement{});
      }
    }
    const Transform& parent = deck_.transforms_[pending.parent.value];
    Transform& total = deck_.transforms_[pending.own.value];
    total.places = pending.transformation != 0 || parent.places;
    total.matrix = parent.matrix * own.matrix;
    total.shift = parent.length_factor * (parent.matrix * own.shift) + parent.shift;
  }
}

}  // namespace gapcheck::keyword
