#include "base/file_writer.hpp"

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <filesystem>
#include <optional>
#include <random>
#include <system_error>
#include <utility>

#include "base/system/files.hpp"

namespace gapcheck {

/// The name of an uncommitted file. A signal handler may read the list at any time: names never change, entries are
/// never freed, which costs a hundred bytes per file written.
struct ListedName {
  const std::string name;
  std::atomic<int> folder = -1;  ///< a descriptor: the folder keeps it when it is moved
  std::atomic<bool> exists = false;
  ListedName* next = nullptr;
};

namespace {

namespace fs = std::filesystem;

std::atomic<ListedName*> listed_names = nullptr;
std::atomic<bool> ending = false;
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<ListedName*>::is_always_lock_free);

ListedName& list_name(const std::string& text) {
  auto* name = new ListedName{text, -1, false, listed_names.load()};
  while (!listed_names.compare_exchange_weak(name->next, name)) {
  }
  return *name;
}

std::string random_name() {
  std::random_device random;
  return fmt::format(".gapcheck-{:08x}{:08x}", random(), random());
}

/// Where a path leads, even if there is no file yet; none for /dev/stdout and /dev/fd/N, whose target belongs to
/// whoever opened it.
std::optional<fs::path> target_of(fs::path path) {
  constexpr int most_links = 40;
  std::error_code error;
  for (int links = 0; links < most_links; ++links) {
    if (system::names_stream(path.string())) return std::nullopt;
    if (!fs::is_symlink(path, error)) return path;
    const fs::path to = fs::read_symlink(path, error);
    if (error) return path;
    path = to.is_absolute() ? to : path.parent_path() / to;
  }
  return std::nullopt;  // links in a round, which cannot be opened
}

/// The folder takes no new files, but that says nothing about the file itself.
bool closed_folder(int error) { return error == EACCES || error == EPERM || error == EROFS; }

/// Errors of fsync() where there is nothing to bring to a disk.
bool means_no_disk(int error) { return error == EINVAL || error == ENOTSUP || error == ENOSYS || error == EROFS; }

}  // namespace

/// A new file in the folder of the target, deleted unless it was kept, even if the folder has another name by then.
class FileWriter::Temporary {
 public:
  explicit Temporary(const fs::path& target) : listed_(list_name(random_name())), parent_(target.parent_path()) {
    folder_ = system::open_folder(parent_.string());
    if (folder_ < 0) {
      error_ = errno;
      return;
    }
    listed_.folder = folder_;
    listed_.exists = true;
    fd_ = system::create_in(folder_, listed_.name.c_str());
    error_ = errno;
    // A handler that has read the list before this will not delete the file.
    if (fd_ < 0) listed_.exists = false;
    if (fd_ >= 0 && ending) remove();
  }
  ~Temporary() {
    if (listed_.exists) remove();
    listed_.exists = false;
    if (folder_ >= 0) system::close(folder_);
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  /// Leads to the file as long as its folder keeps its name.
  [[nodiscard]] std::string path() const { return (parent_ / listed_.name).string(); }
  /// -1: it could not be made, for this reason.
  [[nodiscard]] int fd() const { return fd_; }
  [[nodiscard]] int error() const { return error_; }
  /// It has another name now.
  void keep() { listed_.exists = false; }

 private:
  void remove() { system::remove_in(folder_, listed_.name.c_str()); }

  ListedName& listed_;
  const fs::path parent_;
  int folder_ = -1, fd_ = -1, error_ = 0;
};

FileWriter::FileWriter(std::string path, std::string target) : path_(std::move(path)), target_(std::move(target)) {}
FileWriter::FileWriter(FileWriter&& other) noexcept = default;
FileWriter::~FileWriter() = default;

Diagnostic FileWriter::failure(int error) const {
  return {Severity::error, path_, 0,
          fmt::format("cannot be written: {}", std::generic_category().message(error != 0 ? error : EIO))};
}

Status FileWriter::open_directly() {
  temporary_.reset();
  errno = 0;
  file_.reset(system::open_stream(path_, "wb"));
  if (!file_) return failure(errno);
  return {};
}

Result<FileWriter> FileWriter::create(const std::string& path) {
  const auto target = target_of(path);
  FileWriter writer(path, target ? target->string() : path);
  system::FileState old;
  const bool exists = system::state_of(path, old);
  writer.replaces_ = exists;
  if (exists && old.kind == system::FileKind::folder) return writer.failure(EISDIR);
  // Write-protected files stay, although their folder would let them be replaced.
  if (exists && !system::may_write(path)) return writer.failure(errno);
  const bool direct = !target || path.empty() || (exists && old.kind != system::FileKind::regular);
  if (!direct) {
    writer.temporary_ = std::make_unique<Temporary>(*target);
    const int fd = writer.temporary_->fd();
    if (fd >= 0) {
      writer.file_.reset(system::stream_of(fd));
      if (!writer.file_) {
        const int error = errno;
        system::close(fd);
        return writer.failure(error);
      }
      if (exists) system::give_permissions(fd, old);
      return {std::move(writer)};
    }
    if (!exists || !closed_folder(writer.temporary_->error())) return writer.failure(writer.temporary_->error());
  }
  if (const Status opened = writer.open_directly(); !opened.ok()) return opened.error();
  return {std::move(writer)};
}

bool FileWriter::write(std::string_view text) {
  errno = 0;
  if (error_ == 0 && std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size())
    error_ = errno != 0 ? errno : EIO;
  return error_ == 0;
}

Status FileWriter::finish() {
  if (file_) {
    errno = 0;
    if (error_ == 0 && std::fflush(file_.get()) != 0) error_ = errno;
    if (error_ == 0 && temporary_ && replaces_ && !system::flush_to_disk(system::descriptor_of(file_.get())) &&
        !means_no_disk(errno))
      error_ = errno;
    if (std::fclose(file_.release()) != 0 && error_ == 0) error_ = errno != 0 ? errno : EIO;
  }
  if (error_ != 0) {
    temporary_.reset();
    return failure(error_);
  }
  return {};
}

/// The text into the old file, for names that cannot be taken over: mount points, as containers have them.
int FileWriter::put_over() {
  const std::unique_ptr<std::FILE, Close> from(system::open_stream(temporary_->path(), "rb"));
  std::unique_ptr<std::FILE, Close> to(system::open_stream(target_, "wb"));
  if (!from || !to) return errno;
  std::array<char, 65536> buffer{};
  for (std::size_t n = 0; (n = std::fread(buffer.data(), 1, buffer.size(), from.get())) > 0;)
    if (std::fwrite(buffer.data(), 1, n, to.get()) != n) return errno;
  if (std::ferror(from.get()) != 0) return EIO;
  return std::fclose(to.release()) != 0 ? errno : 0;
}

Status FileWriter::commit() {
  if (Status finished = finish(); !finished.ok()) return finished;
  if (!temporary_) return {};
  if (system::rename_over(temporary_->path(), target_)) {
    temporary_->keep();
  } else {
    error_ = errno == EBUSY ? put_over() : errno;
  }
  temporary_.reset();
  if (error_ != 0) return failure(error_);
  return {};
}

Status write_file(const std::string& path, std::string_view text) {
  auto writer = FileWriter::create(path);
  if (!writer) return writer.error();
  writer.value().write(text);
  return writer.value().commit();
}

FileId id_of(std::FILE* file) {
  system::FileState state;
  if (file == nullptr || !system::state_of(system::descriptor_of(file), state)) return {};
  return {state.device, state.inode, state.size};
}

Status check_name(const std::string& path, const FileId& file, bool closed) {
  system::FileState state;
  if (system::state_of(path, state) &&
      (closed ? state.size == file.size : state.device == file.device && state.inode == file.inode))
    return {};
  return Diagnostic{Severity::error, path, 0,
                    "was removed, moved or replaced while gapcheck wrote it; write into a folder that stays"};
}

void remove_uncommitted_files() noexcept {
  ending = true;
  for (const ListedName* name = listed_names; name != nullptr; name = name->next)
    if (name->exists) system::remove_in(name->folder, name->name.c_str());
}

}  // namespace gapcheck
