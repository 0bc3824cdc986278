#include "results/curves/lsda.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <type_traits>

#include "base/work_watch.hpp"

namespace gapcheck::results {
namespace {

constexpr std::size_t longest_path = 4096;

std::size_t bytes_of(LsdaArray::Type type) {
  constexpr std::array<std::size_t, 12> sizes{0, 1, 2, 4, 8, 1, 2, 4, 8, 4, 8, 0};
  const auto at = static_cast<std::size_t>(type);
  return at < sizes.size() ? sizes[at] : 0;
}

/// What the first eight bytes say.
struct LsdaHeader {
  std::size_t bytes = 0, length_bytes = 0, command_bytes = 0, type_bytes = 0;
  bool swapped = false;
};

std::optional<LsdaHeader> header_of(std::string_view bytes) {
  if (bytes.size() < 8) return std::nullopt;
  const auto byte = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(bytes[i])); };
  // Order: 0 the highest byte first, 1 the lowest.
  const LsdaHeader header{byte(0), byte(1), byte(3), byte(4),
                          (byte(5) == 1) != (std::endian::native == std::endian::little)};
  const auto is_word = [](std::size_t size) { return size == 1 || size == 2 || size == 4 || size == 8; };
  const bool fits = header.bytes >= 8 && header.bytes <= bytes.size() && is_word(header.length_bytes) &&
                    is_word(header.command_bytes) && is_word(header.type_bytes) && byte(5) <= 1 && byte(6) == 0;
  return fits ? std::optional(header) : std::nullopt;
}

/// Takes fields off the front of a record.
class Fields {
 public:
  Fields(std::string_view bytes, bool swapped) : bytes_(bytes), swapped_(swapped) {}

  /// An unsigned integer of 1 to 8 bytes; nothing if the record ends before.
  std::optional<std::uint64_t> integer(std::size_t size) {
    if (bytes_.size() < size) return std::nullopt;
    const bool little = (std::endian::native == std::endian::little) != swapped_;
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i)
      value = value << 8 | static_cast<unsigned char>(bytes_[little ? size - 1 - i : i]);
    bytes_.remove_prefix(size);
    return value;
  }
  std::optional<std::string_view> text(std::size_t size) {
    if (bytes_.size() < size) return std::nullopt;
    const std::string_view taken = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return taken;
  }
  [[nodiscard]] std::string_view rest() const { return bytes_; }

 private:
  std::string_view bytes_;
  bool swapped_;
};

/// Follows a way from a directory as a shell would; false: it is too long.
bool change_directory(std::string_view way, std::string& path) {
  if (way.starts_with('/')) path.clear();
  while (!way.empty()) {
    const std::size_t end = std::min(way.find('/'), way.size());
    const std::string_view step = way.substr(0, end);
    way.remove_prefix(std::min(end + 1, way.size()));
    if (step.empty() || step == ".") continue;
    if (step == "..")
      path.erase(std::min(path.rfind('/'), path.size()));
    else
      (path += '/') += step;
    if (path.size() > longest_path) return false;
  }
  return true;
}

enum class Command : std::uint8_t { change_directory = 2, data = 3 };

/// Goes through the records.
class LsdaReader {
 public:
  LsdaReader(const LsdaHeader& header, const std::function<void(const LsdaArray&)>& visit)
      : header_(header), visit_(visit) {}

  /// The record without its length; false: it makes no sense.
  bool take(std::string_view record) {
    Fields fields(record, header_.swapped);
    const auto command = fields.integer(header_.command_bytes);
    if (!command) return false;
    if (*command == static_cast<std::uint64_t>(Command::change_directory))
      return change_directory(fields.rest(), path_);
    return *command != static_cast<std::uint64_t>(Command::data) || take_data(fields);
  }

 private:
  bool take_data(Fields& fields) {
    const auto type = fields.integer(header_.type_bytes);
    const auto name_bytes = fields.integer(1);
    const auto name = name_bytes ? fields.text(*name_bytes) : std::nullopt;
    if (!type || !name || *type < 1 || *type > static_cast<std::uint64_t>(LsdaArray::Type::link)) return false;
    visit_({path_, *name, static_cast<LsdaArray::Type>(*type), fields.rest(), header_.swapped});
    return true;
  }

  LsdaHeader header_;
  const std::function<void(const LsdaArray&)>& visit_;
  std::string path_;
};

}  // namespace

std::size_t LsdaArray::size() const {
  const std::size_t each = bytes_of(type_);
  return each > 0 ? bytes_.size() / each : 0;
}

template <class T>
T LsdaArray::value(std::size_t i) const {
  std::array<char, sizeof(T)> raw{};
  std::memcpy(raw.data(), bytes_.data() + i * sizeof(T), sizeof(T));
  if (swapped_) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<T>(raw);
}

template <class To>
To LsdaArray::number(std::size_t i) const {
  const auto real_as = [](double value) -> To {
    if constexpr (std::is_floating_point_v<To>)
      return value;
    else
      return std::abs(value) < 9.2e18 ? static_cast<To>(value) : To{};
  };
  switch (type_) {
    case Type::int8:
      return static_cast<To>(value<std::int8_t>(i));
    case Type::int16:
      return static_cast<To>(value<std::int16_t>(i));
    case Type::int32:
      return static_cast<To>(value<std::int32_t>(i));
    case Type::int64:
      return static_cast<To>(value<std::int64_t>(i));
    case Type::uint8:
      return static_cast<To>(value<std::uint8_t>(i));
    case Type::uint16:
      return static_cast<To>(value<std::uint16_t>(i));
    case Type::uint32:
      return static_cast<To>(value<std::uint32_t>(i));
    case Type::uint64:
      return static_cast<To>(value<std::uint64_t>(i));
    case Type::float32:
      return real_as(static_cast<double>(value<float>(i)));
    case Type::float64:
      return real_as(value<double>(i));
    case Type::link:
      break;
  }
  return To{};
}

double LsdaArray::real(std::size_t i) const { return number<double>(i); }

std::int64_t LsdaArray::integer(std::size_t i) const { return number<std::int64_t>(i); }

Status read_lsda(std::string_view bytes, const std::string& name, const std::function<void(const LsdaArray&)>& visit,
                 Diagnostics& diagnostics) {
  const auto header = header_of(bytes);
  if (!header) return Diagnostic{Severity::error, name, 0, "not a binout: it lacks the header of an LSDA file"};
  LsdaReader reader(*header, visit);
  std::string_view rest = bytes.substr(header->bytes);
  while (!rest.empty() && !work_stopped()) {
    const std::size_t at = bytes.size() - rest.size();
    Fields fields(rest, header->swapped);
    const auto length = fields.integer(header->length_bytes);
    const bool whole = length && *length > header->length_bytes && *length <= rest.size();
    if (!whole || !reader.take(rest.substr(header->length_bytes, *length - header->length_bytes))) {
      diagnostics.warning(name, 0,
                          fmt::format("the record at byte {} is {}; what follows is not read", at,
                                      whole ? "damaged" : "cut off or damaged"));
      break;
    }
    rest.remove_prefix(*length);
  }
  return {};
}

}  // namespace gapcheck::results
