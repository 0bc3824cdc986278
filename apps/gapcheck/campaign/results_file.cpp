#include "campaign/results_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "base/system/files.hpp"
#include "report/archive/archive.hpp"

// The overloads that archives look for are in the namespace of the archive.
namespace gapcheck::report {

template <class Archive>
void members(Archive& archive, Archived<Archive, app::ContentHash>& record) {
  archive(record.low, record.high);
}

template <class Archive>
void members(Archive& archive, Archived<Archive, app::DeckListId>& record) {
  archive(record.hash, record.count);
}

template <class Archive>
void members(Archive& archive, Archived<Archive, Diagnostic>& record) {
  auto& [severity, file, line, message, excerpt] = record;
  archive(severity, file, line, message, excerpt);
}

template <class Archive>
void members(Archive& archive, Archived<Archive, app::DeckResult>& record) {
  auto& [version, call, position, deck, key, contacts, parts, failed, unread, diagnostics, left_out, stored] = record;
  archive(version, call, position, deck, key, contacts, parts, failed, unread, diagnostics, left_out, stored);
}

}  // namespace gapcheck::report

namespace gapcheck::app {
namespace {

constexpr std::string_view magic = "gapcheck results 1\n";

/// Before the bytes of an entry: their number and hash.
struct EntryHead {
  std::uint64_t length = 0;
  ContentHash hash;
};

Diagnostic fault(const std::string& path, std::string message) {
  return {Severity::error, path, 0, std::move(message)};
}

Diagnostic system_fault(const std::string& path, const char* what, int error) {
  return fault(path, fmt::format("{}: {}", what, std::generic_category().message(error)));
}

/// Takes the next entry off the text; nothing: what is left is not a whole entry.
std::optional<std::string_view> take_entry(std::string_view& left) {
  EntryHead head;
  if (left.size() < sizeof head) return std::nullopt;
  std::memcpy(&head, left.data(), sizeof head);
  if (head.length > left.size() - sizeof head) return std::nullopt;
  const std::string_view entry = left.substr(sizeof head, static_cast<std::size_t>(head.length));
  if (hash_of(entry) != head.hash) return std::nullopt;
  left.remove_prefix(sizeof head + entry.size());
  return entry;
}

std::optional<DeckResult> result_of(std::string_view entry) {
  report::ArchiveReader reader(entry);
  DeckResult result;
  reader(result);
  if (!reader.complete()) return std::nullopt;
  return result;
}

/// The part of a file's bytes that holds entries. An error if they are of something else.
Result<std::string_view> entries_in(std::string_view bytes, const std::string& path) {
  // A program that was killed at once may have left a part of the first line.
  if (bytes.size() < magic.size() && magic.starts_with(bytes)) return std::string_view();
  if (!bytes.starts_with(magic)) return fault(path, "is not a file of --results; give another name");
  return bytes.substr(magic.size());
}

}  // namespace

Result<ResultsFile> ResultsFile::open(const std::string& path) {
  ResultsFile results(path);
  results.file_.reset(system::open_stream(path, "ab"));
  if (!results.file_) return system_fault(path, "cannot be written", errno);
  const int descriptor = system::descriptor_of(results.file_.get());
  if (!system::lock(descriptor))
    return fault(path, "another call of gapcheck has it open; give each call a file of its own");
  auto bytes = FileBytes::open(path);
  if (!bytes) return bytes.error();
  results.old_ = std::move(bytes).value();
  const std::string_view all = results.old_.bytes();
  const auto entries = entries_in(all, path);
  if (!entries) return entries.error();
  std::string_view left = entries.value();
  while (const auto entry = take_entry(left))
    if (auto result = result_of(*entry)) results.entries_[std::move(result->deck)] = *entry;
  const bool has_head = all.size() >= magic.size();
  results.cut_off_ = has_head ? left.size() : 0;
  if (left.empty() && has_head) return results;
  if (!system::shorten(descriptor, has_head ? all.size() - left.size() : 0))
    return system_fault(path, "cannot be shortened", errno);
  if (!has_head && std::fwrite(magic.data(), 1, magic.size(), results.file_.get()) != magic.size())
    return system_fault(path, "cannot be written", errno);
  return results;
}

Result<std::vector<DeckResult>> ResultsFile::read(const std::string& path) {
  const auto bytes = FileBytes::open(path);
  if (!bytes) return bytes.error();
  const auto entries = entries_in(bytes.value().bytes(), path);
  if (!entries) return entries.error();
  std::vector<DeckResult> results;
  std::map<std::string, std::size_t> known;
  std::string_view left = entries.value();
  while (const auto entry = take_entry(left)) {
    auto result = result_of(*entry);
    if (!result) return fault(path, "holds an entry that is not understood; another version of gapcheck wrote it");
    const auto [at, is_new] = known.try_emplace(result->deck, results.size());
    if (is_new)
      results.push_back(std::move(*result));
    else
      results[at->second] = std::move(*result);
  }
  return results;
}

std::optional<DeckResult> ResultsFile::find(const std::string& deck) const {
  const auto entry = entries_.find(deck);
  return entry == entries_.end() ? std::nullopt : result_of(entry->second);
}

Status ResultsFile::add(const DeckResult& result) {
  report::ArchiveWriter writer;
  writer(result);
  const std::string entry = writer.take();
  const EntryHead head{entry.size(), hash_of(entry)};
  std::FILE* file = file_.get();
  const bool written = std::fwrite(&head, sizeof head, 1, file) == 1 &&
                       std::fwrite(entry.data(), 1, entry.size(), file) == entry.size() && std::fflush(file) == 0 &&
                       system::flush_to_disk(system::descriptor_of(file));
  if (!written) return system_fault(path_, "cannot be written", errno);
  return {};
}

}  // namespace gapcheck::app
