#include "base/file_bytes.hpp"

#include <algorithm>
#include <cerrno>
#include <mutex>
#include <system_error>
#include <utility>

#include "base/parallel.hpp"
#include "base/system/files.hpp"
#include "base/system/memory.hpp"

namespace gapcheck {
namespace {

/// What load() reads at least, and one thread of several at once.
constexpr std::size_t load_step = std::size_t{4} << 20;

Diagnostic read_failure(const std::string& path, const std::string& what) { return {Severity::error, path, 0, what}; }

FileStamp stamp_of(const system::FileState& state) {
  return {state.device, state.inode, state.size, state.seconds, state.nanoseconds};
}

}  // namespace

Result<FileBytes> FileBytes::begin(const std::string& path) {
  FileBytes file;
  file.path_ = path;
  file.fd_ = system::open_to_read(path);
  if (file.fd_ < 0)
    return read_failure(path, std::string("cannot be opened: ") + std::generic_category().message(errno));
  system::FileState state;
  if (!system::state_of(file.fd_, state))
    return read_failure(path, std::string("cannot be examined: ") + std::generic_category().message(errno));
  if (state.kind == system::FileKind::folder) return read_failure(path, "is a directory; give a file inside it");
  if (state.kind != system::FileKind::regular) return read_failure(path, "is not a regular file");
  file.stamp_ = stamp_of(state);
  if (state.size == 0) return file;
  file.data_ = system::take_memory(file.size());
  if (file.data_ == nullptr)
    return read_failure(path, std::string("there is no memory for it: ") + std::generic_category().message(errno));
  return file;
}

Result<FileBytes> FileBytes::open(const std::string& path) {
  auto file = begin(path);
  if (!file) return file;
  if (const Status read = file.value().load(file.value().size()); !read.ok()) return read.error();
  return file;
}

Status FileBytes::read_piece(std::size_t begin, std::size_t end) const {
  while (begin < end) {
    const std::ptrdiff_t got = system::read_at(fd_, data_ + begin, end - begin, begin);
    if (got < 0) return read_failure(path_, std::string("cannot be read: ") + std::generic_category().message(errno));
    if (got == 0) return read_failure(path_, "became shorter while it was read; wait until it is complete");
    begin += static_cast<std::size_t>(got);
  }
  return {};
}

Status FileBytes::load(std::size_t end) {
  if (end <= loaded_ || loaded_ == size()) return {};
  const std::size_t first = loaded_, until = std::min(size(), std::max(end, first + load_step));
  const std::size_t pieces = (until - first + load_step - 1) / load_step;
  std::mutex mutex;
  Status status;
  parallel_for(pieces, 1, [&](std::size_t from, std::size_t to) {
    const Status read = read_piece(first + from * load_step, std::min(until, first + to * load_step));
    const std::lock_guard lock(mutex);
    if (status.ok()) status = read;
  });
  if (!status.ok()) return status;
  loaded_ = until;
  if (loaded_ == size()) system::close(std::exchange(fd_, -1));
  return {};
}

void FileBytes::release(std::size_t begin, std::size_t end) {
  end = std::min(end, loaded_);
  if (begin < end) system::give_back_pages(data_ + begin, data_ + end);
}

Status FileBytes::unchanged() const {
  system::FileState state;
  if (system::state_of(path_, state) && stamp_of(state) == stamp_) return {};
  return read_failure(path_, "was changed while gapcheck worked on it; run it again");
}

FileBytes::FileBytes(FileBytes&& other) noexcept
    : path_(std::move(other.path_)),
      stamp_(std::exchange(other.stamp_, {})),
      fd_(std::exchange(other.fd_, -1)),
      data_(std::exchange(other.data_, nullptr)),
      loaded_(std::exchange(other.loaded_, 0)) {}

FileBytes& FileBytes::operator=(FileBytes&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(stamp_, other.stamp_);
  std::swap(fd_, other.fd_);
  std::swap(data_, other.data_);
  std::swap(loaded_, other.loaded_);
  return *this;
}

FileBytes::~FileBytes() {
  if (fd_ >= 0) system::close(fd_);
  if (data_ != nullptr) system::give_back_memory(data_, size());
}

}  // namespace gapcheck
