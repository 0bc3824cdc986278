#include "audit/repair/deck_edits.hpp"

#include <algorithm>

namespace gapcheck::audit {
namespace {

/// Adds whole lines to those that are there.
void add_lines(std::string& to, std::string_view text) {
  if (!to.empty()) to += '\n';
  to += text;
}

/// True if a line of a file ends with CR LF. A last line without an end is as the others.
bool ends_with_return(std::string_view bytes, std::string_view line) {
  if (line.data() == nullptr) return false;
  const std::string_view behind = bytes.substr(static_cast<std::size_t>(line.data() - bytes.data()) + line.size());
  return behind.starts_with('\r') || (behind.empty() && bytes.find("\r\n") != std::string_view::npos);
}

}  // namespace

Status DeckEdits::check(FileIndex file) const {
  const auto files = deck_.files();
  const std::string_view bytes = files[file.value].bytes;
  const auto same = std::count_if(files.begin(), files.end(), [&](const keyword::SourceFile& other) {
    return other.bytes.data() == bytes.data() || other.path == files[file.value].path;
  });
  return same > 1 ? plain_error("its file is included more than once") : Status();
}

const keyword::LineIndex& DeckEdits::index(FileIndex file) {
  const auto known = index_.find(file.value);
  return known != index_.end() ? known->second : index_.emplace(file.value, deck_.file(file).bytes).first->second;
}

DeckEdits::Change& DeckEdits::change(FileIndex file, std::uint32_t number) {
  auto& lines = files_[file.value];
  const auto known = lines.find(number);
  if (known != lines.end()) return known->second;
  return lines.emplace(number, Change{"", std::string(index(file).line(number)), ""}).first->second;
}

std::string_view DeckEdits::line(FileIndex file, std::uint32_t number) {
  const auto changed = files_.find(file.value);
  if (changed != files_.end())
    if (const auto known = changed->second.find(number); known != changed->second.end()) return known->second.text;
  return index(file).line(number);
}

void DeckEdits::replace(FileIndex file, std::uint32_t number, std::string text) {
  change(file, number).text = std::move(text);
}

void DeckEdits::insert_before(FileIndex file, std::uint32_t number, std::string_view text) {
  add_lines(change(file, number).before, text);
}

void DeckEdits::insert_behind(FileIndex file, std::uint32_t number, std::string_view text) {
  add_lines(change(file, number).behind, text);
}

std::vector<ChangedLines> DeckEdits::changed() const {
  std::vector<ChangedLines> all;
  for (const auto& [file, lines] : files_) {
    ChangedLines changed{FileIndex{file}, {}};
    for (const auto& [number, change] : lines) {
      std::string text = change.before;
      add_lines(text, change.text);
      if (!change.behind.empty()) text += '\n' + change.behind;
      changed.edits.push_back({number, std::move(text)});
    }
    all.push_back(std::move(changed));
  }
  return all;
}

std::vector<RepairLine> DeckEdits::listed() {
  std::vector<RepairLine> all;
  for (const ChangedLines& file : changed())
    for (const keyword::LineEdit& edit : file.edits)
      all.push_back({deck_.file(file.file).path, edit.line, std::string(index(file.file).line(edit.line)), edit.text});
  return all;
}

std::map<std::string, std::string> changed_texts(const keyword::Deck& deck, std::span<const ChangedLines> files) {
  std::map<std::string, std::string> texts;
  for (const ChangedLines& file : files) {
    const std::string_view bytes = deck.file(file.file).bytes;
    texts[deck.file(file.file).path] = keyword::with_lines(bytes, keyword::LineIndex(bytes), file.edits);
  }
  return texts;
}

void take_line_ends(const keyword::Deck& deck, RepairPlan& plan) {
  std::map<std::string, keyword::LineIndex> indices;  // by path
  const auto take = [&](RepairLine& line) {
    std::string& text = line.after;
    const auto file = std::ranges::find(deck.files(), line.file, &keyword::SourceFile::path);
    if (text.find('\n') == std::string::npos || file == deck.files().end()) return;
    const keyword::LineIndex& index = indices.try_emplace(line.file, file->bytes).first->second;
    if (!ends_with_return(file->bytes, index.line(line.line))) return;
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2))
      text.insert(at, 1, '\r');
  };
  for (RepairPair& pair : plan.pairs)
    for (Repair& repair : pair.repairs) std::ranges::for_each(repair.lines, take);
}

}  // namespace gapcheck::audit
