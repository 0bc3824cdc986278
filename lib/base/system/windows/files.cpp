#include "base/system/files.hpp"

#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <string>

// Names of files are UTF-8, and the functions of Windows below take them so, because the manifest of the programs
// (apps/windows/utf8.manifest) says that this is their code page.

namespace gapcheck::system {
namespace {

/// What POSIX would say of an error of Windows.
int error_number(DWORD error) {
  switch (error) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_INVALID_NAME:
    case ERROR_BAD_NETPATH:
    case ERROR_BAD_PATHNAME:
    case ERROR_INVALID_DRIVE:
      return ENOENT;
    case ERROR_ACCESS_DENIED:
    case ERROR_SHARING_VIOLATION:  // another program has it open
    case ERROR_LOCK_VIOLATION:
      return EACCES;
    case ERROR_WRITE_PROTECT:
      return EROFS;
    case ERROR_FILE_EXISTS:
    case ERROR_ALREADY_EXISTS:
      return EEXIST;
    case ERROR_DISK_FULL:
    case ERROR_HANDLE_DISK_FULL:
      return ENOSPC;
    case ERROR_NOT_ENOUGH_MEMORY:
    case ERROR_OUTOFMEMORY:
    case ERROR_COMMITMENT_LIMIT:
      return ENOMEM;
    case ERROR_TOO_MANY_OPEN_FILES:
      return EMFILE;
    case ERROR_BROKEN_PIPE:
    case ERROR_NO_DATA:
      return EPIPE;
    case ERROR_FILENAME_EXCED_RANGE:
      return ENAMETOOLONG;
    case ERROR_INVALID_PARAMETER:
    case ERROR_INVALID_FUNCTION:
      return EINVAL;
    default:
      return EIO;
  }
}

/// False, with errno.
bool fails() {
  errno = error_number(::GetLastError());
  return false;
}

HANDLE handle_of(int descriptor) { return reinterpret_cast<HANDLE>(::_get_osfhandle(descriptor)); }

/// Others may read, write, rename and remove the file meanwhile, as POSIX has it.
HANDLE open_handle(const char* path, DWORD access, DWORD disposition, DWORD flags) {
  constexpr DWORD share = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
  return ::CreateFileA(path, access, share, nullptr, disposition, flags, nullptr);
}

int descriptor_of(HANDLE handle, int flags) {
  if (handle == INVALID_HANDLE_VALUE) {
    fails();
    return -1;
  }
  return ::_open_osfhandle(reinterpret_cast<std::intptr_t>(handle), flags | _O_BINARY | _O_NOINHERIT);
}

bool copy_state(HANDLE handle, FileState& state) {
  state = {};
  if (::GetFileType(handle) != FILE_TYPE_DISK) return true;
  BY_HANDLE_FILE_INFORMATION info{};
  if (::GetFileInformationByHandle(handle, &info) == 0) return fails();
  const auto joined = [](DWORD high, DWORD low) { return std::uint64_t{high} << 32 | low; };
  constexpr std::int64_t ticks_per_second = 10'000'000;
  const auto ticks =
      static_cast<std::int64_t>(joined(info.ftLastWriteTime.dwHighDateTime, info.ftLastWriteTime.dwLowDateTime));
  const bool folder = (info.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0;
  state.kind = folder ? FileKind::folder : FileKind::regular;
  state.device = info.dwVolumeSerialNumber;
  state.inode = joined(info.nFileIndexHigh, info.nFileIndexLow);
  state.size = joined(info.nFileSizeHigh, info.nFileSizeLow);
  state.seconds = ticks / ticks_per_second;
  state.nanoseconds = ticks % ticks_per_second * 100;
  return true;
}

/// The path of a file in an open folder, wherever that is by now. Empty: errno says why.
std::string path_in(int folder, const char* name) {
  std::string path(MAX_PATH, '\0');
  for (;;) {
    const DWORD length =
        ::GetFinalPathNameByHandleA(handle_of(folder), path.data(), static_cast<DWORD>(path.size()), 0);
    if (length == 0) fails();
    if (length == 0) return {};
    const bool whole = length < path.size();
    path.resize(length);
    if (whole) return path + '\\' + name;
  }
}

DWORD at_most(std::size_t bytes) { return static_cast<DWORD>(std::min<std::size_t>(bytes, INT_MAX)); }

}  // namespace

bool state_of(int descriptor, FileState& state) { return copy_state(handle_of(descriptor), state); }

bool state_of(const std::string& path, FileState& state) {
  const HANDLE handle = open_handle(path.c_str(), 0, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS);
  if (handle == INVALID_HANDLE_VALUE) return fails();
  const bool known = copy_state(handle, state);
  ::CloseHandle(handle);
  return known;
}

int open_to_read(const std::string& path) {
  return descriptor_of(open_handle(path.c_str(), GENERIC_READ, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS), _O_RDONLY);
}

void close(int descriptor) noexcept { ::_close(descriptor); }

std::ptrdiff_t read_at(int descriptor, char* to, std::size_t most, std::uint64_t position) {
  OVERLAPPED place{};
  place.Offset = static_cast<DWORD>(position);
  place.OffsetHigh = static_cast<DWORD>(position >> 32);
  DWORD got = 0;
  if (::ReadFile(handle_of(descriptor), to, at_most(most), &got, &place) != 0) return got;
  if (::GetLastError() == ERROR_HANDLE_EOF) return 0;
  fails();
  return -1;
}

std::ptrdiff_t read_some(int descriptor, char* to, std::size_t most) { return ::_read(descriptor, to, at_most(most)); }

std::ptrdiff_t write_some(int descriptor, std::string_view bytes) {
  return ::_write(descriptor, bytes.data(), at_most(bytes.size()));
}

void enlarge_pipe(int, int) {}

std::FILE* open_stream(const std::string& path, const char* mode) {
  return std::fopen(path.c_str(), (std::string(mode) + 'N').c_str());
}

std::FILE* stream_of(int descriptor) { return ::_fdopen(descriptor, "wb"); }

int descriptor_of(std::FILE* stream) { return ::_fileno(stream); }

bool seek(std::FILE* stream, std::uint64_t position) {
  return ::_fseeki64(stream, static_cast<std::int64_t>(position), SEEK_SET) == 0;
}

int open_folder(const std::string& path) {
  return descriptor_of(open_handle(path.empty() ? "." : path.c_str(), 0, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS),
                       _O_RDONLY);
}

int create_in(int folder, const char* name) {
  const std::string path = path_in(folder, name);
  if (path.empty()) return -1;
  return descriptor_of(open_handle(path.c_str(), GENERIC_WRITE, CREATE_NEW, FILE_ATTRIBUTE_NORMAL), _O_WRONLY);
}

void remove_in(int folder, const char* name) noexcept {
  // No string: handlers of signals come here, on a thread of their own.
  std::array<char, 2 * MAX_PATH> path{};
  const DWORD length = ::GetFinalPathNameByHandleA(handle_of(folder), path.data(), MAX_PATH, 0);
  if (length == 0 || length >= MAX_PATH || std::char_traits<char>::length(name) + 2 > MAX_PATH) return;
  path[length] = '\\';
  std::copy_n(name, std::char_traits<char>::length(name), path.data() + length + 1);
  ::DeleteFileA(path.data());
}

bool may_write(const std::string& path) {
  const DWORD attributes = ::GetFileAttributesA(path.c_str());
  if (attributes == INVALID_FILE_ATTRIBUTES) return fails();
  errno = EACCES;
  return (attributes & FILE_ATTRIBUTE_READONLY) == 0;
}

void give_permissions(int, const FileState&) {}

bool flush_to_disk(int descriptor) { return ::_commit(descriptor) == 0; }

bool rename_over(const std::string& from, const std::string& to) {
  return ::MoveFileExA(from.c_str(), to.c_str(), MOVEFILE_REPLACE_EXISTING) != 0 || fails();
}

bool lock(int descriptor) {
  // Locked bytes cannot be read either, so it is one that no file has.
  OVERLAPPED place{};
  place.OffsetHigh = INT_MAX;
  constexpr DWORD how = LOCKFILE_EXCLUSIVE_LOCK | LOCKFILE_FAIL_IMMEDIATELY;
  return ::LockFileEx(handle_of(descriptor), how, 0, 1, 0, &place) != 0 || fails();
}

bool shorten(int descriptor, std::uint64_t size) {
  FILE_END_OF_FILE_INFO end{};
  end.EndOfFile.QuadPart = static_cast<LONGLONG>(size);
  return ::SetFileInformationByHandle(handle_of(descriptor), FileEndOfFileInfo, &end, sizeof end) != 0 || fails();
}

bool names_stream(std::string_view) { return false; }  // NUL and CON are no regular files

}  // namespace gapcheck::system
