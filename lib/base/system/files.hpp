#pragma once
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

/// What operating systems do differently, each thing once: posix/NAME.cpp and windows/NAME.cpp define what NAME.hpp
/// declares. Nothing else includes their headers. Paths are UTF-8 on Windows. Functions that fail set errno, as POSIX
/// says which.
namespace gapcheck::system {

enum class FileKind : std::uint8_t { regular, folder, other };

struct FileState {
  FileKind kind = FileKind::other;
  std::uint64_t device = 0, inode = 0, size = 0;
  std::int64_t seconds = 0, nanoseconds = 0;     ///< of the last change of its content
  std::uint32_t owner = 0, group = 0, mode = 0;  ///< 0 on Windows
};
/// Of an open file, or of what a path leads to. False: errno says why.
[[nodiscard]] bool state_of(int descriptor, FileState& state);
[[nodiscard]] bool state_of(const std::string& path, FileState& state);

/// For reading, and a named pipe is not waited for. -1: errno says why.
[[nodiscard]] int open_to_read(const std::string& path);
void close(int descriptor) noexcept;
/// How many bytes from a position on were read, 0 at the end; they may be fewer than asked for. -1: errno says why.
[[nodiscard]] std::ptrdiff_t read_at(int descriptor, char* to, std::size_t most, std::uint64_t position);
/// The same at the present position, of a pipe too: waits for at least one byte.
[[nodiscard]] std::ptrdiff_t read_some(int descriptor, char* to, std::size_t most);
/// How many bytes were written, at least one. -1: errno says why.
[[nodiscard]] std::ptrdiff_t write_some(int descriptor, std::string_view bytes);
/// Gives a pipe about this much room; nothing for anything else.
void enlarge_pipe(int descriptor, int bytes);

/// `mode`: "rb", "wb" or "ab". Programs that are started do not get it. Null: errno says why.
[[nodiscard]] std::FILE* open_stream(const std::string& path, const char* mode);
/// A stream that writes to a descriptor and closes it. Null: errno says why.
[[nodiscard]] std::FILE* stream_of(int descriptor);
[[nodiscard]] int descriptor_of(std::FILE* stream);
/// To a position from the beginning.
[[nodiscard]] bool seek(std::FILE* stream, std::uint64_t position);

/// A folder that keeps its descriptor when it is moved; empty: the working directory. -1: errno says why.
[[nodiscard]] int open_folder(const std::string& path);
/// A new file for writing. -1: errno says why, EEXIST if there is one.
[[nodiscard]] int create_in(int folder, const char* name);
/// Async-signal-safe.
void remove_in(int folder, const char* name) noexcept;

/// Whether the file, which exists, may be written.
[[nodiscard]] bool may_write(const std::string& path);
/// Owner and permissions of another file, as far as that is allowed.
void give_permissions(int descriptor, const FileState& as);
/// What was written is on the disk.
[[nodiscard]] bool flush_to_disk(int descriptor);
/// The file gets a name that another file may have had.
[[nodiscard]] bool rename_over(const std::string& from, const std::string& to);
/// Nobody else can have it until it is closed. False: somebody has it.
[[nodiscard]] bool lock(int descriptor);
[[nodiscard]] bool shorten(int descriptor, std::uint64_t size);
/// Whether the name is that of a stream that somebody else opened: /dev/stdout, /dev/fd/3.
[[nodiscard]] bool names_stream(std::string_view path);

}  // namespace gapcheck::system
