#include "keyword/deck.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "base/number.hpp"
#include "keyword/cases.hpp"
#include "keyword/deck_reader.hpp"
#include "keyword/keyword_line.hpp"
#include "keyword/template_fields.hpp"
#include "keyword/text/line_ends.hpp"
#include "keyword/transformation.hpp"
#include "keyword/upper_case.hpp"

namespace gapcheck::keyword {
namespace {

/// Far beyond any real deck; keeps a file of only stars from filling the memory.
constexpr std::size_t max_blocks = 5'000'000;
constexpr std::size_t max_directives = 1'000'000;
constexpr std::string_view cases_are_one_model =
    "*CASE: the keywords of all cases are read as one model; split the deck to check one case";

/// An error if a file cannot be a keyword file.
Status check_text(std::string_view bytes, const std::string& name) {
  const auto error = [&](const std::string& what) { return Diagnostic{Severity::error, name, 0, what}; };
  if (bytes.empty()) return error("is empty; give a keyword file");
  if (bytes.substr(0, 4096).find('\0') != std::string_view::npos)
    return error("is not a keyword file (it is binary or in a wide encoding); give the text file with the keywords");
  if (const std::string ends = foreign_line_ends(bytes); !ends.empty()) return error(about_line_ends(ends));
  return {};
}

/// A further keyword in the line of one: the line ends are lost.
bool holds_another(std::string_view keyword_line) {
  for (auto at = keyword_line.find(" *"); at != std::string_view::npos; at = keyword_line.find(" *", at + 1))
    if (at + 2 < keyword_line.size() && keyword_line[at + 2] >= 'A' && keyword_line[at + 2] <= 'Z') return true;
  return false;
}

/// An error if the lines that structure a file are not those of a deck.
Status check_keywords(std::string_view bytes, const std::vector<Mark>& marks, const std::string& name) {
  const auto structures = [](const Mark& mark) {
    return mark.kind == Mark::Kind::keyword || mark.kind == Mark::Kind::encrypted_begin;
  };
  const auto first = std::find_if(marks.begin(), marks.end(), structures);
  if (first != marks.end()) {
    std::size_t next = 0;
    if (std::any_of(first + 1, marks.end(), structures) || !holds_another(line_at(bytes, first->offset, next)))
      return {};
    return Diagnostic{Severity::error, name, first->line,
                      "holds all its keywords in one line; its line ends are lost, so give the file that has them"};
  }
  return Diagnostic{Severity::error, name, 0,
                    "holds no keyword (no line of it starts with *); give an LS-DYNA keyword file"};
}

bool is_data(std::string_view line) { return !line.starts_with('$') && !trimmed(line).empty(); }

/// The number of the first line with data in [begin, end), where `number` lines come before it; none without one.
std::optional<std::uint32_t> first_data_line(std::string_view bytes, std::size_t begin, std::size_t end,
                                             std::uint32_t number) {
  for (std::size_t offset = begin; offset < end;) {
    ++number;
    if (is_data(line_at(bytes, offset, offset))) return number;
  }
  return std::nullopt;
}

/// The block of a keyword line, still without its data. *KEYWORD changes the format of the rest of its file.
Block block_of(FileContext& context, std::string_view line) {
  KeywordLine read = read_keyword_line(line, context.format);
  Block block;
  block.name = std::move(read.name);
  block.format = read.format;
  block.file = context.file;
  block.transform = is_node_or_element(block.name) ? context.transforms.mesh : context.transforms.others;
  block.scope = context.scope;
  return block;
}

/// Adds the comments to gapcheck of a file as far as it is read. The line of the first one too many; none if all fit.
std::optional<std::uint32_t> add_directives(const FileContext& context, std::string_view bytes,
                                            const std::vector<Mark>& comments, std::size_t read_to,
                                            std::vector<Directive>& directives) {
  for (const Mark& comment : comments) {
    if (comment.offset >= read_to) break;
    if (comment.kind != Mark::Kind::directive) continue;
    if (directives.size() == max_directives) return comment.line;
    std::size_t next = 0;
    if (const auto text = directive_text(line_at(bytes, comment.offset, next)))
      directives.push_back({std::string(*text), context.file, comment.line, context.transforms.mesh});
  }
  return std::nullopt;
}

/// An error for keywords and comments before `read_to` with line breaks that are no line ends; one for all of them.
void check_breaks(const std::string& path, const std::vector<Mark>& marks, std::size_t read_to,
                  Diagnostics& diagnostics) {
  std::uint32_t first = 0;
  std::size_t count = 0;
  for (const Mark& mark : marks) {
    if (mark.kind != Mark::Kind::foreign_break || mark.offset >= read_to) continue;
    if (count++ == 0) first = mark.line;
  }
  if (count == 0) return;
  const std::string which = count > 1 ? ", the first of " + std::to_string(count) + " such lines" : "";
  diagnostics.error(path, first,
                    "holds a line break that is neither LF nor CR LF (CR, U+0085, U+2028 or U+2029)" + which +
                        "; what follows it is not read; convert the line ends of the file");
}

/// Whether a line in [begin, end) has template fields. `comments`: by offset, with other marks among them.
bool has_template_fields(const std::vector<Mark>& comments, std::size_t begin, std::size_t end) {
  auto mark = std::lower_bound(comments.begin(), comments.end(), begin,
                               [](const Mark& m, std::size_t offset) { return m.offset < offset; });
  for (; mark != comments.end() && mark->offset < end; ++mark)
    if (mark->kind == Mark::Kind::template_field) return true;
  return false;
}

/// An error for data between `begin` and the first keyword at `end`.
void check_before_keywords(const SourceFile& file, std::size_t begin, std::size_t end, Diagnostics& diagnostics) {
  if (const auto line = first_data_line(file.bytes, begin, end, 0))
    diagnostics.error(file.path, *line,
                      "data before the first keyword; start the file with *KEYWORD or remove the line");
}

/// Skips one encrypted block; returns the position of the mark after it.
std::size_t pass_encrypted(const SourceFile& file, const std::vector<Mark>& marks, std::size_t at,
                           Diagnostics& diagnostics) {
  const std::string_view bytes = file.bytes;
  const Mark begin = marks[at];
  while (at < marks.size() && marks[at].kind != Mark::Kind::encrypted_end) ++at;
  if (at == marks.size()) {
    diagnostics.warning(file.path, begin.line, "an encrypted block without end: the rest of the file was not read");
    return at;
  }
  diagnostics.warning(file.path, begin.line, "an encrypted block was passed over; what it holds is unknown");
  const std::uint32_t last = marks[at].line;
  std::size_t offset = 0;
  line_at(bytes, marks[at].offset, offset);
  ++at;
  if (const auto line = first_data_line(bytes, offset, at < marks.size() ? marks[at].offset : bytes.size(), last))
    diagnostics.warning(file.path, *line,
                        "the lines between the encrypted block and the next keyword were passed over: their keyword "
                        "is encrypted");
  return at;
}

/// Takes the values of --param.
void give_parameters(const std::vector<std::string>& texts, Parameters& parameters, Diagnostics& diagnostics) {
  for (const std::string& text : texts) {
    const std::string fault = parameter_fault(text);
    if (!fault.empty()) {
      diagnostics.add(plain_error("--param " + fault));
      continue;
    }
    const std::string_view all = text;
    parameters.give(trimmed(all.substr(0, all.find('='))), trimmed(all.substr(all.find('=') + 1)));
  }
}

}  // namespace

Result<Deck> DeckReader::read_path(const std::string& path) {
  std::error_code error;
  canonical_.push_back(std::filesystem::canonical(path, error).string());
  const auto file = open_file(path, canonical_.back());
  if (!file) return file.error();
  return read_all(path, file.value()->bytes(), file.value()->marks());
}

Result<Deck> DeckReader::read_text(std::string text, const std::string& name) {
  deck_.texts_.push_back(std::make_unique<const std::string>(std::move(text)));
  canonical_.emplace_back();
  const std::string_view bytes = *deck_.texts_.back();
  return read_all(name, bytes, marks_of_file(bytes));
}

Result<Deck> DeckReader::read_all(const std::string& path, std::string_view bytes, const std::vector<Mark>& marks) {
  give_parameters(options_.parameters, deck_.parameters_, diagnostics_);
  if (const Status status = check_text(bytes, path); !status.ok()) return status.error();
  if (const Status status = check_keywords(bytes, marks, path); !status.ok()) return status.error();
  FileContext context;
  context.file = add_file(path, bytes, nullptr, 0);
  context.scope = deck_.parameters_.add_scope(Parameters::global);
  read_file(context, marks);
  return finish();
}

Result<Deck> DeckReader::finish() {
  std::stable_sort(deck_.directives_.begin(), deck_.directives_.end(),
                   [](const Directive& a, const Directive& b) { return a.file.value < b.file.value; });
  transforms_.resolve(deck_.transforms_, deck_, diagnostics_);
  return std::move(deck_);
}

/// The file, which the deck then keeps.
Result<std::shared_ptr<KeywordFile>> DeckReader::open_file(const std::string& path, const std::string& canonical) {
  if (options_.replaced != nullptr && options_.replaced->contains(path))
    return deck_.read_.emplace_back(std::make_shared<KeywordFile>(options_.replaced->at(path)));
  FileCache& cache = options_.cache != nullptr ? *options_.cache : own_;
  const std::uint64_t shared = cache.shared();
  auto file = cache.open(path, canonical, !deck_.files_.empty());
  if (!file) return file;
  if (std::find(deck_.read_.begin(), deck_.read_.end(), file.value()) == deck_.read_.end()) {
    deck_.counters_.shared_files += cache.shared() - shared;
    deck_.read_.push_back(file.value());
  }
  return file;
}

FileIndex DeckReader::add_file(const std::string& path, std::string_view bytes, const FileContext* includer,
                               std::uint32_t line) {
  SourceFile file;
  file.path = path;
  file.bytes = bytes;
  if (includer != nullptr) file.includer = includer->file;
  file.include_line = line;
  deck_.files_.push_back(std::move(file));
  deck_.counters_.bytes += bytes.size();
  ++deck_.counters_.files;
  return FileIndex(static_cast<std::uint32_t>(deck_.files_.size() - 1));
}

void DeckReader::read_file(FileContext context, const std::vector<Mark>& lines) {
  const std::string_view bytes = deck_.files_[context.file.value].bytes;
  deck_.files_[context.file.value].of_mesh = context.transforms.mesh;
  const std::size_t begin = bytes.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  const auto beside = [](const Mark& mark) {
    return mark.kind == Mark::Kind::directive || mark.kind == Mark::Kind::foreign_break ||
           mark.kind == Mark::Kind::template_field;
  };
  std::vector<Mark> structure, comments;
  if (std::any_of(lines.begin(), lines.end(), beside))
    std::partition_copy(lines.begin(), lines.end(), std::back_inserter(comments), std::back_inserter(structure),
                        beside);
  const std::vector<Mark>& marks = comments.empty() ? lines : structure;
  check_before_keywords(deck_.file(context.file), begin, marks.empty() ? bytes.size() : marks.front().offset,
                        diagnostics_);
  std::size_t read_to = bytes.size();
  for (std::size_t at = 0; at < marks.size() && !stopped_;) {
    const Mark& mark = marks[at];
    if (mark.kind == Mark::Kind::encrypted_begin) {
      ++deck_.counters_.encrypted_blocks;
      at = pass_encrypted(deck_.file(context.file), marks, at, diagnostics_);
      continue;
    }
    ++at;
    if (mark.kind != Mark::Kind::keyword) continue;
    // The end of an encrypted block that never began is an ordinary line.
    std::size_t next = at;
    while (next < marks.size() && marks[next].kind == Mark::Kind::encrypted_end) ++next;
    const std::size_t end = next < marks.size() ? marks[next].offset : bytes.size();
    std::size_t body = 0;
    Block block = block_of(context, line_at(bytes, mark.offset, body));
    block.line = mark.line;
    block.body = bytes.substr(body, std::max(end, body) - body);
    if (add_block(std::move(block), context, has_template_fields(comments, mark.offset, end))) continue;
    read_to = mark.offset;
    break;
  }
  check_breaks(path_of(context.file), comments, read_to, diagnostics_);
  if (const auto line = add_directives(context, bytes, comments, read_to, deck_.directives_))
    diagnostics_.error(path_of(context.file), *line,
                       "more than " + std::to_string(max_directives) +
                           " comments that start with \"gapcheck:\"; the rest was not read");
}

/// Adds a block and follows it to other files; false if nothing after it must be read.
bool DeckReader::add_block(Block block, const FileContext& context, bool templated) {
  if (block.name.empty())
    diagnostics_.error(path_of(block.file), block.line, "a keyword line without a name; give the keyword or remove it");
  if (deck_.blocks_.size() == max_blocks) {
    diagnostics_.error(path_of(block.file), block.line,
                       "more than " + std::to_string(max_blocks) + " keywords; the rest was not read");
    stopped_ = true;
    return false;
  }
  block.order = static_cast<std::uint32_t>(deck_.blocks_.size());
  if (templated) {
    deck_.texts_.push_back(std::make_unique<const std::string>(with_template_fields(deck_, block, diagnostics_)));
    block.body = *deck_.texts_.back();
  }
  deck_.blocks_.push_back(block);
  deck_.ended_ = deck_.ended_ || (block.name == "END" && block.file == FileIndex(0));
  dispatch(context, block);
  return block.name != "END" && !stopped_;
}

void DeckReader::dispatch(const FileContext& context, const Block& block) {
  const std::string_view name = block.name;
  if (name.starts_with("INCLUDE")) {
    read_include(context, block);
  } else if (name.starts_with("PARAMETER")) {
    read_parameters(block);
  } else if (is_transformation(name)) {
    transforms_.add_definition(block.order);
  } else if (name.starts_with("CASE_BEGIN")) {
    if (cases_.empty()) diagnostics_.warning(path_of(block.file), block.line, std::string(cases_are_one_model));
    cases_.insert(case_begun(name));
  }
}

std::string parameter_fault(std::string_view text) {
  const std::size_t equals = text.find('=');
  const std::string_view name = trimmed(text.substr(0, equals));
  if (equals == std::string_view::npos || name.empty() || trimmed(text.substr(equals + 1)).empty())
    return "'" + std::string(text.substr(0, 80)) + "' is not of the form NAME=VALUE";
  return "";
}

void warn_of_unused_parameters(const Deck& deck, Diagnostics& diagnostics) {
  for (const std::string& name : deck.parameters().unused())
    diagnostics.warning(deck.file(FileIndex(0)).path, 0,
                        "--param " + name + ": the deck neither defines nor uses this parameter; correct the name");
}

void note_missing_end(const Deck& deck, Diagnostics& diagnostics) {
  if (deck.ended() || deck.counters().encrypted_blocks > 0) return;
  diagnostics.add(
      {Severity::note, deck.file(FileIndex(0)).path, 0, "ends without *END; if it was cut, what followed is missing"});
}

void Deck::drop_text(const std::function<bool(std::string_view name)>& done) {
  constexpr std::size_t worth_it = std::size_t{1} << 16;
  std::map<const char*, KeywordFile*> by_address;
  for (const auto& file : read_)
    if (!file->bytes().empty()) by_address.emplace(file->bytes().data(), file.get());
  for (Block& block : blocks_) {
    if (block.body.size() < worth_it || !done(block.name)) continue;
    auto file = by_address.upper_bound(block.body.data());
    if (file == by_address.begin()) continue;  // of a text in memory, as below
    const auto& [first, of] = *--file;
    if (block.body.data() >= first + of->bytes().size()) continue;
    of->drop(block.body);
    block.body = {};
    files_[block.file.value].bytes = {};
  }
}

std::int64_t Deck::id_in_file(FileIndex file, IdKind kind, std::int64_t id) const {
  if (file.value >= files_.size()) return 0;
  const Transform& transform = transforms_[files_[file.value].of_mesh.value];
  const std::int64_t offset = transform.offset[static_cast<std::size_t>(kind)];
  return transform.automatic && offset != 0 ? id - offset : 0;
}

Status Deck::unchanged() const {
  for (const auto& file : read_)
    if (Status same = file->unchanged(); !same.ok()) return same;
  return {};
}

Result<Deck> read_deck(const std::string& path, const ReadOptions& options, Diagnostics& diagnostics) {
  return DeckReader(options, diagnostics).read_path(path);
}

Result<Deck> read_deck_text(std::string text, const std::string& name, const ReadOptions& options,
                            Diagnostics& diagnostics) {
  return DeckReader(options, diagnostics).read_text(std::move(text), name);
}

}  // namespace gapcheck::keyword
