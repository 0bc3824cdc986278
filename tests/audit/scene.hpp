#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/vector.hpp"

namespace gapcheck::audit_test {

/// A deck as data, so that tests can move, scale, renumber and shuffle it before it is written.
struct Scene {
  struct Node {
    std::int64_t id;
    Vector x;
  };
  struct Element {
    std::int64_t id, part;
    std::vector<std::int64_t> nodes;  ///< 3 or 4: shell; 8: brick
    [[nodiscard]] bool solid() const { return nodes.size() == 8; }
  };
  struct Part {
    std::int64_t id;
    bool solid = false;
    double thickness = 0;
  };
  struct PartSet {
    std::int64_t id;
    std::vector<std::int64_t> parts;
  };
  struct Contact {
    std::int64_t id;
    std::string keyword;                ///< without `CONTACT_`
    std::int64_t set_a = 0, set_b = 0;  ///< part sets; 0 on side A = all parts
    double sst = 0, mst = 0, sfst = 1, sfmt = 1;
    std::int64_t ignore = 0, snlog = 0;
  };
  std::vector<Node> nodes;
  std::vector<Element> elements;
  std::vector<Part> parts;
  std::vector<PartSet> sets;
  std::vector<Contact> contacts;
  std::int64_t ssthk = 0;

  /// A deck in free format; numbers read back as the same doubles.
  [[nodiscard]] std::string text() const;
};

}  // namespace gapcheck::audit_test
