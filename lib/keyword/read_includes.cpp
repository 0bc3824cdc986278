#include <filesystem>

#include "base/number.hpp"
#include "keyword/cases.hpp"
#include "keyword/deck_reader.hpp"
#include "keyword/text/line_ends.hpp"

namespace gapcheck::keyword {
namespace {

std::string beside(const std::string& file, const std::string& name) {
  return (std::filesystem::path(file).parent_path() / name).string();
}

std::string problem_of(std::string_view bytes) {
  if (bytes.substr(0, 4096).find('\0') != std::string_view::npos) return "is not a keyword file; it is binary";
  const std::string ends = foreign_line_ends(bytes);
  return ends.empty() ? "" : about_line_ends(ends);
}

std::string about_case(std::int64_t number) {
  return "\" was not found: the run of *CASE " + std::to_string(number) +
         " writes it, and what starts from there is read without it";
}

/// What would help if an include is not found. `like`: a file elsewhere that ends as the name does; empty: none.
std::string advice(const std::string& name, const std::string& like) {
  if (!like.empty()) return "\" was not found, but there is \"" + like + "\": correct the name";
  const std::size_t cut = name.find_last_of("/\\:");
  const std::string last = cut == std::string::npos ? name : name.substr(cut + 1);
  if (!last.empty() && may_be_of_another_machine(name))
    return "\" was not found, and neither the folders of the decks nor those of *INCLUDE_PATH and -I have a \"" + last +
           "\" for it; put it beside the deck, or give its folder with -I";
  if (!last.empty() && cut != std::string::npos)
    return "\" was not found; correct the name, or give with -I or *INCLUDE_PATH the folder that \"" + name +
           "\" starts from";
  return "\" was not found; correct the name, or give its directory with -I or *INCLUDE_PATH";
}

/// `file`: which includes it; `like`: see advice().
Diagnostic about_missing(const MissingInclude& include, const std::string& file, const std::string& like,
                         bool skipped) {
  const bool written = include.written_by > 0;
  return {written || skipped ? Severity::warning : Severity::error, file, include.line,
          "include \"" + include.name + (written ? about_case(include.written_by) : advice(include.name, like))};
}

std::string about_found(const IncludeName& include, const FoundInclude& found) {
  std::string text =
      "include \"" + include.name + "\" does not exist here; \"" + found.path + "\" was read in its place";
  if (!found.other.empty()) text += " (not \"" + found.other + "\", which has the same name)";
  return text;
}

IncludeTransform shift_above(const HighestIds& highest) {
  IncludeTransform shift;
  shift.own.automatic = true;
  shift.own.offset[static_cast<std::size_t>(IdKind::node)] = highest.node();
  shift.own.offset[static_cast<std::size_t>(IdKind::element)] = highest.element();
  return shift;
}

std::string about_shift(const IncludeName& include, const HighestIds& highest) {
  return "*INCLUDE_AUTO_OFFSET: in \"" + include.name + "\" the ids of nodes are shifted by " +
         std::to_string(highest.node()) + " and those of elements by " + std::to_string(highest.element()) +
         ", the highest ids read before; ids in its sets and other lists are not";
}

constexpr std::string_view bad_include_name =
    "the name of the include is longer than 236 characters or not a text; shorten it";

std::string too_many_files(std::uint32_t limit) {
  return "the deck has more than " + std::to_string(limit) + " files; the rest was not read";
}

/// Why the file `canonical` cannot be included in the file `at` of `files`; empty: it can. `canonicals`: beside
/// `files`.
std::string reason_against(const std::string& canonical, FileIndex at, std::span<const SourceFile> files,
                           const std::vector<std::string>& canonicals) {
  for (; at != none<FileIndex>; at = files[at.value].includer)
    if (!canonical.empty() && canonicals[at.value] == canonical) return "it includes itself; remove the *INCLUDE";
  return "";
}

}  // namespace

void DeckReader::read_include(const FileContext& context, const Block& block) {
  CardReader reader(deck_, block, diagnostics_);
  if (block.name == "INCLUDE_PATH" || block.name == "INCLUDE_PATH_RELATIVE") {
    read_include_path(reader, block.name == "INCLUDE_PATH_RELATIVE");
    return;
  }
  const bool transforms = block.name == "INCLUDE_TRANSFORM";
  auto include = next_include_name(reader, deck_.parameters_);
  if (block.name == "INCLUDE") {
    for (; include; include = next_include_name(reader, deck_.parameters_))
      open_include(context, block, *include, context.transforms);
  } else if (transforms && !include) {
    diagnostics_.error(path_of(block.file), block.line, "*INCLUDE_TRANSFORM without a file name; give one");
  } else if (transforms || block.name == "INCLUDE_AUTO_OFFSET_USER") {
    if (include) open_transformed(context, reader, *include);
  } else if (block.name == "INCLUDE_AUTO_OFFSET") {
    for (; include; include = next_include_name(reader, deck_.parameters_)) open_shifted(context, reader, *include);
  } else {
    diagnostics_.warning(path_of(block.file), block.line,
                         "*" + block.name + " is not supported: \"" + (include ? include->name : "") +
                             "\" was not read; what it defines is missing from the model");
  }
}

void DeckReader::read_include_path(CardReader& reader, bool relative) {
  const FileIndex file = reader.block().file;
  while (const auto path = next_include_name(reader, deck_.parameters_)) {
    if (paths_.add(relative ? beside(path_of(file), path->name) : path->name)) continue;
    diagnostics_.error(path_of(file), path->line,
                       "more than " + std::to_string(IncludePaths::most) + " include paths; this one is not used");
    return;
  }
}

void DeckReader::open_transformed(const FileContext& context, CardReader& reader, const IncludeName& include) {
  const Block& block = reader.block();
  const bool one_file = block.name == "INCLUDE_TRANSFORM";
  const IncludeTransform given = one_file ? read_include_transform(reader) : read_include_offsets(reader);
  while (one_file && !reader.at_end() && trimmed(reader.peek()).empty()) reader.skip();
  if (one_file && !reader.at_end())
    diagnostics_.error(path_of(block.file), reader.peek_line(),
                       "*INCLUDE_TRANSFORM has more lines than one file needs; give each file its own keyword");
  const auto transformed = [&](TransformIndex parent) {
    return transforms_.add(deck_.transforms_, parent, given, block, path_of(block.file), diagnostics_);
  };
  const FileTransforms& outer = context.transforms;
  FileTransforms inner;
  inner.others = transformed(outer.others);
  inner.mesh = outer.mesh == outer.others ? inner.others : transformed(outer.mesh);
  open_include(context, block, include, inner);
}

/// *INCLUDE_AUTO_OFFSET (contact rules, section 12.5).
void DeckReader::open_shifted(const FileContext& context, CardReader& reader, const IncludeName& include) {
  const Block& block = reader.block();
  highest_.update(deck_);
  const std::string said = about_shift(include, highest_);
  const TransformIndex mesh = transforms_.add(deck_.transforms_, context.transforms.mesh, shift_above(highest_), block,
                                              path_of(block.file), diagnostics_);
  if (open_include(context, block, include, {mesh, context.transforms.others}))
    diagnostics_.add({Severity::note, path_of(block.file), include.line, said});
}

/// An included file that is readable; null: the reason is already reported.
std::shared_ptr<KeywordFile> DeckReader::map_include(const std::string& path, const std::string& canonical,
                                                     const Block& block, std::uint32_t line) {
  auto file = open_file(path, canonical);
  const bool empty = file.ok() && file.value()->bytes().empty();
  const std::string problem = !file ? file.error().message : empty ? "is empty" : problem_of(file.value()->bytes());
  if (problem.empty()) return std::move(file).value();
  diagnostics_.add(
      {empty ? Severity::warning : Severity::error, path_of(block.file), line, "include \"" + path + "\" " + problem});
  return nullptr;
}

/// True if the file was read.
bool DeckReader::open_include(const FileContext& context, const Block& block, const IncludeName& include,
                              FileTransforms transforms) {
  if (stopped_) return false;
  // The main file is one of the files. Missing ones count as well: searching for each takes time.
  if (++includes_ >= options_.max_files) {
    diagnostics_.error(path_of(block.file), include.line, too_many_files(options_.max_files));
    stopped_ = true;
    return false;
  }
  const bool bad_name = include.name.size() > max_include_name || include.name.find('\0') != std::string::npos;
  if (bad_name) {
    diagnostics_.error(path_of(block.file), include.line, std::string(bad_include_name));
    return false;
  }
  const auto open = [&](const std::string& file) {
    return !reason_against(file, context.file, deck_.files_, canonical_).empty();
  };
  const auto found = paths_.find(include.name, path_of(FileIndex(0)), path_of(context.file), open);
  if (!found) {
    const auto like = paths_.find_by_end(include.name, path_of(FileIndex(0)), path_of(context.file), open);
    ++deck_.counters_.missing_includes;
    deck_.missing_includes_.push_back({include.name, block.file, include.line, case_that_writes(include.name, cases_)});
    diagnostics_.add(about_missing(deck_.missing_includes_.back(), path_of(block.file), like ? like->path : "",
                                   options_.skip_missing_includes));
    return false;
  }
  if (found->by_end)
    diagnostics_.add({Severity::note, path_of(block.file), include.line, about_found(include, *found)});
  const std::string& path = found->path;
  std::error_code error;
  const std::string canonical = std::filesystem::canonical(path, error).string();
  std::string reason = context.depth >= options_.max_include_depth
                           ? "includes are nested more than " + std::to_string(options_.max_include_depth) + " deep"
                           : reason_against(canonical, context.file, deck_.files_, canonical_);
  if (reason.empty()) reason = repeats_.reason_against(canonical, deck_.counters_.bytes, options_.max_repeated_bytes);
  if (!reason.empty()) {
    diagnostics_.error(path_of(block.file), include.line, "include \"" + include.name + "\" was not read: " + reason);
    stopped_ = repeats_.exceeded();
    return false;
  }
  const auto file = map_include(path, canonical, block, include.line);
  if (file == nullptr) return false;
  canonical_.push_back(canonical);
  FileContext inner = context;
  inner.file = add_file(path, file->bytes(), &context, include.line);
  deck_.files_.back().kept = file->kept();
  inner.transforms = transforms;
  inner.scope = deck_.parameters_.add_scope(context.scope);
  ++inner.depth;
  read_file(inner, file->marks());
  return true;
}

}  // namespace gapcheck::keyword
