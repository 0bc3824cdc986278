#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "pair.hpp"

namespace gapcheck::bench {

/// The same pairs in both precisions; in float everything is rounded, the contact distance too.
struct Pairs {
  std::vector<ContactPair<double>> in_double;
  std::vector<ContactPair<float>> in_float;
  void add(const ContactPair<double>& pair);
  [[nodiscard]] std::size_t size() const { return in_double.size(); }
};

/// For which pairs a method gives a distance.
enum class Distances : std::uint8_t { all, nearer, none };

/// One way of finding the distance of a point from a facet and of comparing it with the contact distance.
struct Method {
  std::string name, precision;
  Distances distances = Distances::all;
  /// Answers all pairs, one answer each, in one loop that the compiler sees through.
  void (*run)(const Pairs& pairs, std::span<Answer<double>> answers) = nullptr;
};

/// All methods, the proven ones last. A new one is a header of its own and a line in methods.cpp.
[[nodiscard]] const std::vector<Method>& methods();

}  // namespace gapcheck::bench
