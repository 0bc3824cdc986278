#pragma once
#include <array>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/vector.hpp"

namespace gapcheck::report {

// Records as bytes and back. Which members a record has is said once, by an overload
//   template <class Archive> void members(Archive& archive, Archived<Archive, Record>& record) { archive(record.a, …);
//   }
// that both directions call. Bytes are those of the machine's own numbers: for files that the same program reads again.

/// The record as an archive takes it: a writer does not change it.
template <class Archive, class Record>
using Archived = std::conditional_t<Archive::writes, const Record, Record>;

/// The largest value that an enumeration has; anything above is a fault of the bytes. Specialised for each.
template <class Enum>
inline constexpr Enum last_value = Enum::must_be_specialised;
template <>
inline constexpr Severity last_value<Severity> = Severity::error;

template <class T>
concept PlainNumber = std::is_arithmetic_v<T> && !std::same_as<T, bool>;

/// Appends values to a text.
class ArchiveWriter {
 public:
  static constexpr bool writes = true;

  template <class... Values>
  void operator()(const Values&... values) {
    (put(values), ...);
  }
  /// Those written so far; the writer begins anew.
  [[nodiscard]] std::string take() { return std::exchange(bytes_, {}); }

 private:
  template <PlainNumber T>
  void put(const T& value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void put(const bool& value) { bytes_.push_back(value ? 1 : 0); }
  template <class T>
  requires std::is_enum_v<T>
  void put(const T& value) { put(static_cast<std::underlying_type_t<T>>(value)); }
  void put(const std::string& text) {
    put(static_cast<std::uint64_t>(text.size()));
    bytes_ += text;
  }
  void put(const Vector& vector) {
    for (int i = 0; i < 3; ++i) put(vector[i]);
  }
  template <class T, std::size_t N>
  void put(const std::array<T, N>& values) {
    for (const T& value : values) put(value);
  }
  template <class T>
  void put(const std::optional<T>& value) {
    put(value.has_value());
    if (value) put(*value);
  }
  template <class A, class B>
  void put(const std::pair<A, B>& pair) {
    put(pair.first);
    put(pair.second);
  }
  template <class T>
  void put(const std::vector<T>& list) {
    put(static_cast<std::uint64_t>(list.size()));
    for (const T& value : list) put(value);
  }
  template <class K, class V, class Less>
  void put(const std::map<K, V, Less>& map) {
    put(static_cast<std::uint64_t>(map.size()));
    for (const auto& entry : map) put(entry);
  }
  template <class Record>
  requires std::is_class_v<Record>
  void put(const Record& record) { members(*this, record); }

  std::string bytes_;
};

/// Reads values from bytes that may be anything: from the first fault on they are left as they are, and ok() is false.
/// Takes memory only for what the bytes hold.
class ArchiveReader {
 public:
  static constexpr bool writes = false;

  /// The bytes must outlive it.
  explicit ArchiveReader(std::string_view bytes) : left_(bytes) {}

  template <class... Values>
  void operator()(Values&... values) {
    (get(values), ...);
  }
  [[nodiscard]] bool ok() const { return ok_; }
  /// Without a fault, and nothing is left over.
  [[nodiscard]] bool complete() const { return ok_ && left_.empty(); }
  void fault() { ok_ = false; }

 private:
  [[nodiscard]] bool has(std::uint64_t bytes) {
    if (bytes > left_.size()) ok_ = false;
    return ok_;
  }
  template <PlainNumber T>
  void get(T& value) {
    if (!has(sizeof value)) return;
    std::memcpy(&value, left_.data(), sizeof value);
    left_.remove_prefix(sizeof value);
  }
  void get(bool& value) {
    std::uint8_t byte = 0;
    get(byte);
    if (byte > 1) return fault();
    value = byte == 1;
  }
  template <class T>
  requires std::is_enum_v<T>
  void get(T& value) {
    std::underlying_type_t<T> number{};
    get(number);
    if (number > static_cast<std::underlying_type_t<T>>(last_value<T>)) return fault();
    value = static_cast<T>(number);
  }
  void get(std::string& text) {
    std::uint64_t length = 0;
    get(length);
    if (!has(length)) return;
    text.assign(left_.substr(0, static_cast<std::size_t>(length)));
    left_.remove_prefix(static_cast<std::size_t>(length));
  }
  void get(Vector& vector) {
    for (int i = 0; i < 3; ++i) get(vector[i]);
  }
  template <class T, std::size_t N>
  void get(std::array<T, N>& values) {
    for (T& value : values) get(value);
  }
  template <class T>
  void get(std::optional<T>& value) {
    bool present = false;
    get(present);
    if (present && ok_) get(value.emplace());
  }
  template <class A, class B>
  void get(std::pair<A, B>& pair) {
    get(pair.first);
    get(pair.second);
  }
  /// Every entry takes at least a byte, so a wrong number of them ends with the bytes.
  template <class T>
  void get(std::vector<T>& list) {
    std::uint64_t count = 0;
    get(count);
    if (!has(count)) return;
    list.clear();
    for (std::uint64_t i = 0; i < count && ok_; ++i) get(list.emplace_back());
  }
  template <class K, class V, class Less>
  void get(std::map<K, V, Less>& map) {
    std::uint64_t count = 0;
    get(count);
    if (!has(count)) return;
    map.clear();
    for (std::uint64_t i = 0; i < count && ok_; ++i) {
      std::pair<K, V> entry;
      get(entry);
      if (ok_) map.insert(std::move(entry));
    }
  }
  template <class Record>
  requires std::is_class_v<Record>
  void get(Record& record) {
    if (ok_) members(*this, record);
  }

  std::string_view left_;
  bool ok_ = true;
};

}  // namespace gapcheck::report
