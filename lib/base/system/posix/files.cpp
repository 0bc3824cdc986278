#include "base/system/files.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

namespace gapcheck::system {
namespace {

void copy_state(const struct stat& info, FileState& state) {
  state.kind = S_ISREG(info.st_mode) ? FileKind::regular : S_ISDIR(info.st_mode) ? FileKind::folder : FileKind::other;
  state.device = info.st_dev;
  state.inode = info.st_ino;
  state.size = static_cast<std::uint64_t>(info.st_size);
  state.seconds = info.st_mtim.tv_sec;
  state.nanoseconds = info.st_mtim.tv_nsec;
  state.owner = info.st_uid;
  state.group = info.st_gid;
  state.mode = info.st_mode & 07777;
}

}  // namespace

bool state_of(int descriptor, FileState& state) {
  struct stat info {};
  if (::fstat(descriptor, &info) != 0) return false;
  copy_state(info, state);
  return true;
}

bool state_of(const std::string& path, FileState& state) {
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0) return false;
  copy_state(info, state);
  return true;
}

int open_to_read(const std::string& path) { return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK); }

void close(int descriptor) noexcept { ::close(descriptor); }

std::ptrdiff_t read_at(int descriptor, char* to, std::size_t most, std::uint64_t position) {
  ssize_t got = 0;
  do {
    got = ::pread(descriptor, to, most, static_cast<off_t>(position));
  } while (got < 0 && errno == EINTR);
  return got;
}

std::ptrdiff_t read_some(int descriptor, char* to, std::size_t most) {
  ssize_t got = 0;
  do {
    got = ::read(descriptor, to, most);
  } while (got < 0 && errno == EINTR);
  return got;
}

std::ptrdiff_t write_some(int descriptor, std::string_view bytes) {
  ssize_t written = 0;
  do {
    written = ::write(descriptor, bytes.data(), bytes.size());
  } while (written < 0 && errno == EINTR);
  return written;
}

void enlarge_pipe(int descriptor, int bytes) {
#ifdef F_SETPIPE_SZ
  static_cast<void>(::fcntl(descriptor, F_SETPIPE_SZ, bytes));
#else
  static_cast<void>(descriptor), static_cast<void>(bytes);
#endif
}

std::FILE* open_stream(const std::string& path, const char* mode) {
  return std::fopen(path.c_str(), (std::string(mode) + 'e').c_str());
}

std::FILE* stream_of(int descriptor) { return ::fdopen(descriptor, "wb"); }

int descriptor_of(std::FILE* stream) { return ::fileno(stream); }

bool seek(std::FILE* stream, std::uint64_t position) {
  return ::fseeko(stream, static_cast<off_t>(position), SEEK_SET) == 0;
}

int open_folder(const std::string& path) {
  return ::open(path.empty() ? "." : path.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
}

int create_in(int folder, const char* name) {
  return ::openat(folder, name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0666);
}

void remove_in(int folder, const char* name) noexcept { ::unlinkat(folder, name, 0); }

bool may_write(const std::string& path) { return ::access(path.c_str(), W_OK) == 0; }

void give_permissions(int descriptor, const FileState& as) {
  if (::fchown(descriptor, as.owner, as.group) != 0) errno = 0;  // only some may
  ::fchmod(descriptor, as.mode);
}

bool flush_to_disk(int descriptor) { return ::fsync(descriptor) == 0; }

bool rename_over(const std::string& from, const std::string& to) { return ::rename(from.c_str(), to.c_str()) == 0; }

bool lock(int descriptor) { return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0; }

bool shorten(int descriptor, std::uint64_t size) { return ::ftruncate(descriptor, static_cast<off_t>(size)) == 0; }

bool names_stream(std::string_view path) { return path.starts_with("/dev/") || path.starts_with("/proc/"); }

}  // namespace gapcheck::system
