#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "base/diagnostic.hpp"
#include "base/result.hpp"

namespace gapcheck::results {

/// One named array of an LSDA file, valid while the file's bytes are.
class LsdaArray {
 public:
  /// Types as the file numbers them.
  enum class Type : std::uint8_t {
    int8 = 1,
    int16,
    int32,
    int64,
    uint8,
    uint16,
    uint32,
    uint64,
    float32,
    float64,
    link
  };

  LsdaArray(std::string_view directory, std::string_view own_name, Type type, std::string_view bytes, bool swapped)
      : path_(directory), name_(own_name), type_(type), swapped_(swapped), bytes_(bytes) {}

  [[nodiscard]] std::string_view path() const { return path_; }  ///< of its directory, "/glstat/d000001"
  [[nodiscard]] std::string_view name() const { return name_; }  ///< "time"
  [[nodiscard]] bool is_real() const { return type_ == Type::float32 || type_ == Type::float64; }
  [[nodiscard]] std::size_t size() const;  ///< numbers; 0 for links
  /// Number i < size(); integers beyond 2^53 are rounded.
  [[nodiscard]] double real(std::size_t i) const;
  /// The same as an integer; of a floating point number its integral part, 0 if it has none in 64 bits.
  [[nodiscard]] std::int64_t integer(std::size_t i) const;
  /// An array of bytes is text.
  [[nodiscard]] std::string_view text() const { return bytes_; }

 private:
  template <class T>
  [[nodiscard]] T value(std::size_t i) const;
  template <class To>
  [[nodiscard]] To number(std::size_t i) const;

  std::string_view path_, name_;
  Type type_;
  bool swapped_;
  std::string_view bytes_;
};

/// Calls `visit` for each array of an LSDA file, the solver's container of binout, in their order. The format after
/// LSTC's description of its I/O library: a header with the sizes of the fields, then records of length, command and
/// data; the records of the symbol table at the end repeat what the others say and are skipped. Error: not such a file.
/// A file that ends within a record is read up to there; `diagnostics` say so.
[[nodiscard]] Status read_lsda(std::string_view bytes, const std::string& name,
                               const std::function<void(const LsdaArray&)>& visit, Diagnostics& diagnostics);

}  // namespace gapcheck::results
