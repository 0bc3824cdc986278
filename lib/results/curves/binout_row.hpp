#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/vector.hpp"
#include "results/curves/lsda.hpp"

namespace gapcheck::results {

/// A value for each id; zeros if the file has no such array.
class BinoutColumn {
 public:
  BinoutColumn(const LsdaArray* array, std::size_t count)
      : array_(array != nullptr && array->size() == count ? array : nullptr) {}
  [[nodiscard]] double at(std::size_t i) const { return array_ != nullptr ? array_->real(i) : 0; }

 private:
  const LsdaArray* array_;
};

struct BinoutVectors {
  BinoutColumn x, y, z;
  [[nodiscard]] Vector at(std::size_t i) const { return {x.at(i), y.at(i), z.at(i)}; }
};

/// The arrays in one directory of a file: a state, or the metadata of all states. Views into the file.
class BinoutRow {
 public:
  void add(const LsdaArray& array) { arrays_.insert_or_assign(std::string(array.name()), array); }
  void clear() { arrays_.clear(); }
  [[nodiscard]] std::size_t size() const { return arrays_.size(); }
  [[nodiscard]] bool empty() const { return arrays_.empty(); }
  [[nodiscard]] bool has(std::string_view name) const { return find(name) != nullptr; }
  /// Numbers of an array; 0 if there is none.
  [[nodiscard]] std::size_t size_of(std::string_view name) const {
    const LsdaArray* array = find(name);
    return array != nullptr ? array->size() : 0;
  }
  /// All of these have `count` floating point numbers: a state cannot ask for more memory than the file gives it.
  [[nodiscard]] bool has_columns(std::initializer_list<std::string_view> names, std::size_t count) const {
    return std::all_of(names.begin(), names.end(), [&](std::string_view name) {
      const LsdaArray* array = find(name);
      return array != nullptr && array->is_real() && array->size() == count;
    });
  }

  /// One number; `other` if there is none.
  [[nodiscard]] double number(std::string_view name, double other = 0) const {
    const LsdaArray* array = find(name);
    return array != nullptr && array->size() > 0 ? array->real(0) : other;
  }
  [[nodiscard]] BinoutColumn column(std::string_view name, std::size_t count) const { return {find(name), count}; }
  /// The columns "x_force", "y_force", "z_force"; with `prefix` "r" "rx_force", …
  [[nodiscard]] BinoutVectors vectors(std::string_view word, std::size_t count, std::string_view prefix = "") const {
    const auto of = [&](char axis) { return column(fmt::format("{}{}_{}", prefix, axis, word), count); };
    return {of('x'), of('y'), of('z')};
  }
  [[nodiscard]] std::vector<double> reals(std::string_view name) const {
    std::vector<double> values;
    if (const LsdaArray* array = find(name))
      for (std::size_t i = 0; i < array->size(); ++i) values.push_back(array->real(i));
    return values;
  }
  [[nodiscard]] std::vector<std::int64_t> integers(std::string_view name) const {
    std::vector<std::int64_t> values;
    if (const LsdaArray* array = find(name))
      for (std::size_t i = 0; i < array->size(); ++i) values.push_back(array->integer(i));
    return values;
  }

 private:
  [[nodiscard]] const LsdaArray* find(std::string_view name) const {
    const auto found = arrays_.find(name);
    return found == arrays_.end() ? nullptr : &found->second;
  }
  std::map<std::string, LsdaArray, std::less<>> arrays_;
};

/// What the metadata of one branch say, also for the files that continue it.
struct BinoutMeta {
  std::map<std::string, std::vector<std::int64_t>, std::less<>> lists;  ///< "ids", "force_ids", "side", "single"
  std::size_t arrays = 0;                                               ///< of the last state
  [[nodiscard]] bool has(std::string_view name) const { return lists.find(name) != lists.end(); }
  /// Empty if there is none.
  [[nodiscard]] const std::vector<std::int64_t>& list(std::string_view name) const {
    static const std::vector<std::int64_t> none;
    const auto found = lists.find(name);
    return found == lists.end() ? none : found->second;
  }
  [[nodiscard]] const std::vector<std::int64_t>& ids() const { return list("ids"); }
  /// Row i belongs to a single surface.
  [[nodiscard]] bool is_single(std::size_t i) const {
    const auto& flags = has("single") ? list("single") : list("single_sided");
    return i < flags.size() && flags[i] != 0;
  }
};

}  // namespace gapcheck::results
