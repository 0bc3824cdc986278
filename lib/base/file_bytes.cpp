#include "base/file_bytes.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <mutex>
#include <system_error>
#include <utility>

#include "base/parallel.hpp"

namespace gapcheck {
namespace {

/// What load() reads at least, and one thread of several at once.
constexpr std::size_t load_step = std::size_t{4} << 20;
/// Below this size huge pages would only waste memory.
constexpr std::size_t worth_huge_pages = std::size_t{16} << 20;

Diagnostic read_failure(const std::string& path, const std::string& what) { return {Severity::error, path, 0, what}; }

FileStamp stamp_of(const struct stat& info) {
  return {info.st_dev, info.st_ino, static_cast<std::uint64_t>(info.st_size), info.st_mtim.tv_sec,
          info.st_mtim.tv_nsec};
}

}  // namespace

Result<FileBytes> FileBytes::begin(const std::string& path) {
  FileBytes file;
  file.path_ = path;
  // O_NONBLOCK: opening a named pipe must not wait for a writer.
  file.fd_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file.fd_ < 0)
    return read_failure(path, std::string("cannot be opened: ") + std::generic_category().message(errno));
  struct stat info {};
  if (::fstat(file.fd_, &info) != 0)
    return read_failure(path, std::string("cannot be examined: ") + std::generic_category().message(errno));
  if (S_ISDIR(info.st_mode)) return read_failure(path, "is a directory; give a file inside it");
  if (!S_ISREG(info.st_mode)) return read_failure(path, "is not a regular file");
  file.stamp_ = stamp_of(info);
  if (info.st_size == 0) return file;
  // Addresses only: memory is taken as the bytes come.
  void* address =
      ::mmap(nullptr, file.size(), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (address == MAP_FAILED)
    return read_failure(path, std::string("there is no memory for it: ") + std::generic_category().message(errno));
  if (file.size() >= worth_huge_pages) ::madvise(address, file.size(), MADV_HUGEPAGE);
  file.data_ = static_cast<char*>(address);
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
    const ssize_t got = ::pread(fd_, data_ + begin, end - begin, static_cast<off_t>(begin));
    if (got < 0 && errno == EINTR) continue;
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
  if (loaded_ == size()) ::close(std::exchange(fd_, -1));
  return {};
}

void FileBytes::release(std::size_t begin, std::size_t end) {
  static const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  begin = (begin + page - 1) / page * page;
  end = std::min(end, loaded_) / page * page;
  if (begin < end) ::madvise(data_ + begin, end - begin, MADV_DONTNEED);
}

Status FileBytes::unchanged() const {
  struct stat info {};
  if (::stat(path_.c_str(), &info) == 0 && stamp_of(info) == stamp_) return {};
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
  if (fd_ >= 0) ::close(fd_);
  if (data_ != nullptr) ::munmap(data_, size());
}

}  // namespace gapcheck
