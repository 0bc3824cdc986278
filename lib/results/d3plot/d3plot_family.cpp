#include "results/d3plot/d3plot_family.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "base/system/files.hpp"
#include "results/d3plot/d3plot_state.hpp"
#include "results/d3plot/d3plot_words.hpp"

namespace gapcheck::results {
namespace {

constexpr std::uint64_t block_of_words = D3plotWords::block_words;

Diagnostic not_written(const std::string& path) {
  return {Severity::error, path, 0,
          fmt::format("cannot be written: {}", std::generic_category().message(errno != 0 ? errno : EIO))};
}

bool write_bytes(std::FILE* file, std::string_view bytes) {
  return std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size() && std::fflush(file) == 0;
}

}  // namespace

void remove_family(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  fs::remove(path, ignored);
  const fs::path first(path);
  const std::string name = first.filename().string();
  std::vector<fs::path> members;
  const fs::path folder = first.has_parent_path() ? first.parent_path() : fs::path(".");
  for (fs::directory_iterator entry(folder, ignored), end; !ignored && entry != end; entry.increment(ignored)) {
    const std::string other = entry->path().filename().string();
    if (other.size() > name.size() && other.starts_with(name) &&
        other.find_first_not_of("0123456789", name.size()) == std::string::npos)
      members.push_back(entry->path());
  }
  for (const fs::path& member : members) fs::remove(member, ignored);
}

Result<D3plotFamily> D3plotFamily::create(const std::string& path, std::string_view first, int word_bytes,
                                          std::uint64_t member_words) {
  D3plotFamily family;
  family.path_ = path;
  family.word_bytes_ = word_bytes;
  family.member_words_ = member_words;
  remove_family(path);
  errno = 0;
  const std::unique_ptr<std::FILE, Close> file(system::open_stream(path, "wb"));
  if (!file || !write_bytes(file.get(), first)) return not_written(path);
  family.written_.emplace_back(path, id_of(file.get()));
  return {std::move(family)};
}

Status D3plotFamily::open_member() {
  member_path_ = fmt::format("{}{:02}", path_, ++member_);
  position_ = 0;
  if (file_) written_.back().second = id_of(file_.get());
  errno = 0;
  file_.reset(system::open_stream(member_path_, "wb"));
  if (!file_) return not_written(member_path_);
  written_.emplace_back(member_path_, id_of(file_.get()));
  return {};
}

Status D3plotFamily::check_names() const {
  for (std::size_t i = 0; i < written_.size(); ++i) {
    const bool closed = !file_ || i + 1 < written_.size();
    if (Status there = check_name(written_[i].first, written_[i].second, closed); !there.ok()) return there;
  }
  return {};
}

Status D3plotFamily::append(WordBuffer state) {
  const std::uint64_t words = state.words();
  if (!file_ || position_ + words + 1 > member_words_)
    if (Status opened = open_member(); !opened.ok()) return opened;
  state.real(d3plot_end);
  const std::uint64_t end = position_ + state.words();
  if (end % block_of_words != 0) state.zeros(block_of_words - end % block_of_words);
  errno = 0;
  const std::uint64_t offset = position_ * static_cast<std::uint64_t>(word_bytes_);
  if (!system::seek(file_.get(), offset) || !write_bytes(file_.get(), state.bytes())) return not_written(member_path_);
  position_ += words;
  return {};
}

}  // namespace gapcheck::results
