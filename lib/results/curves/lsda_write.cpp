#include "results/curves/lsda_write.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <tuple>

#include "base/system/files.hpp"

namespace gapcheck::results {
namespace {

constexpr std::uint64_t length_bytes = 8, offset_bytes = 8, command_bytes = 1, type_bytes = 1;
constexpr std::uint64_t record_head_bytes = length_bytes + command_bytes;  ///< of a record
constexpr std::size_t full_buffer = std::size_t{1} << 20;

enum class Record : char {
  change_directory = 2,
  data = 3,
  symbol = 4,
  table_begin = 5,
  table_end = 6,
  table_offset = 7
};

template <class T>
void put(T value, std::string& text) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  text.append(bytes, sizeof value);
}

/// A record's length and command; `body`: bytes that follow.
void put_head(Record command, std::uint64_t body, std::string& text) {
  put(record_head_bytes + body, text);
  text += static_cast<char>(command);
}

void put_directory(std::string_view path, std::string& text) {
  put_head(Record::change_directory, path.size(), text);
  text += path;
}

std::string file_header() {
  std::string text;
  for (const std::uint64_t byte :
       {std::uint64_t{8}, length_bytes, offset_bytes, command_bytes, type_bytes,
        std::uint64_t{std::endian::native == std::endian::little}, std::uint64_t{0}, std::uint64_t{0}})
    text += static_cast<char>(byte);
  return text;
}

}  // namespace

Result<LsdaWriter> LsdaWriter::create(const std::string& path, const LsdaWriteSettings& settings) {
  LsdaWriter writer;
  writer.path_ = path;
  writer.settings_ = settings;
  if (Status opened = writer.open_member(); !opened.ok()) return opened.error();
  return {std::move(writer)};
}

Diagnostic LsdaWriter::failure() const {
  return {Severity::error, member_path_, 0,
          fmt::format("cannot be written: {}", std::generic_category().message(error_ != 0 ? error_ : EIO))};
}

Status LsdaWriter::open_member() {
  member_path_ = member_ == 0 ? path_ : fmt::format("{}%{:03}", path_, member_);
  ++member_;
  if (file_) files_.back().second = id_of(file_.get());
  errno = 0;
  file_.reset(system::open_stream(member_path_, "wb"));
  error_ = errno;
  if (!file_) return failure();
  error_ = 0;
  files_.emplace_back(member_path_, id_of(file_.get()));
  written_ = 0;
  directory_.clear();
  buffer_ = file_header();
  put_head(Record::table_offset, offset_bytes, buffer_);
  reference_ = buffer_.size();
  put(std::uint64_t{0}, buffer_);
  errno = 0;
  if (write_buffer() && std::fflush(file_.get()) != 0) error_ = errno != 0 ? errno : EIO;
  return error_ == 0 ? Status() : failure();
}

void LsdaWriter::continue_if_full() {
  if (error_ != 0 || written_ <= settings_.member_bytes || !symbols_.empty()) return;
  const std::string directory = directory_;
  if (open_member().ok() && !directory.empty()) change_directory(directory);
}

void LsdaWriter::change_directory(std::string_view path) {
  continue_if_full();
  if (path == directory_) return;
  directory_ = path;
  put_directory(path, buffer_);
}

void LsdaWriter::array(std::string_view name, LsdaArray::Type type, const char* bytes, std::size_t size,
                       std::uint64_t count) {
  continue_if_full();
  name = name.substr(0, 255);
  symbols_.push_back({directory_, std::string(name), type, written_ + buffer_.size(), count});
  put_head(Record::data, type_bytes + 1 + name.size() + size, buffer_);
  buffer_ += static_cast<char>(type);
  buffer_ += static_cast<char>(name.size());
  buffer_ += name;
  buffer_.append(bytes, size);
  if (buffer_.size() >= full_buffer) static_cast<void>(write_buffer());
}

void LsdaWriter::text(std::string_view name, std::string_view value) {
  array(name, LsdaArray::Type::int8, value.data(), value.size(), value.size());
}

void LsdaWriter::integers(std::string_view name, std::span<const std::int64_t> values) {
  array(name, LsdaArray::Type::int64, reinterpret_cast<const char*>(values.data()), values.size_bytes(), values.size());
}

void LsdaWriter::reals(std::string_view name, std::span<const double> values) {
  array(name, LsdaArray::Type::float64, reinterpret_cast<const char*>(values.data()), values.size_bytes(),
        values.size());
}

/// The symbols by directory and name. The length of the first record is that of the whole table.
void LsdaWriter::append_table() {
  std::sort(symbols_.begin(), symbols_.end(), [](const Symbol& a, const Symbol& b) {
    return std::tie(a.directory, a.name, a.record) < std::tie(b.directory, b.name, b.record);
  });
  std::string body, at;
  for (const Symbol& symbol : symbols_) {
    if (symbol.directory != at) put_directory(at = symbol.directory, body);
    put_head(Record::symbol, symbol.name.size() + type_bytes + offset_bytes + length_bytes, body);
    body += symbol.name;
    body += static_cast<char>(symbol.type);
    put(symbol.record, body);
    put(symbol.count, body);
  }
  put_head(Record::table_end, offset_bytes, body);
  put_head(Record::table_begin, body.size() + offset_bytes, buffer_);
  buffer_ += body;
  put(std::uint64_t{0}, buffer_);  // no further table yet
  symbols_.clear();
}

bool LsdaWriter::write_buffer() {
  errno = 0;
  if (error_ == 0 && std::fwrite(buffer_.data(), 1, buffer_.size(), file_.get()) != buffer_.size())
    error_ = errno != 0 ? errno : EIO;
  written_ += buffer_.size();
  buffer_.clear();
  return error_ == 0;
}

bool LsdaWriter::refer_to(std::uint64_t table) {
  std::string offset;
  put(table, offset);
  errno = 0;
  const bool done = system::seek(file_.get(), reference_) &&
                    std::fwrite(offset.data(), 1, offset.size(), file_.get()) == offset.size() &&
                    std::fseek(file_.get(), 0, SEEK_END) == 0 && std::fflush(file_.get()) == 0;
  if (!done) error_ = errno != 0 ? errno : EIO;
  return done;
}

Status LsdaWriter::flush() {
  if (!symbols_.empty()) {
    const std::uint64_t table = written_ + buffer_.size();
    append_table();
    // What a table refers to is in the file before the reference to the table is.
    errno = 0;
    if (write_buffer() && std::fflush(file_.get()) != 0) error_ = errno != 0 ? errno : EIO;
    if (error_ == 0 && refer_to(table)) reference_ = written_ - offset_bytes;
  }
  return error_ == 0 ? Status() : failure();
}

Status LsdaWriter::check_names() const {
  for (std::size_t i = 0; i < files_.size(); ++i)
    if (Status there = check_name(files_[i].first, files_[i].second, i + 1 < files_.size()); !there.ok()) return there;
  return {};
}

}  // namespace gapcheck::results
