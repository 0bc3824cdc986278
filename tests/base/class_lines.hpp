#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "source_text.hpp"

// How long classes are: a scanner of braces and names that is good enough for code in the style of the project.
namespace gapcheck::architecture_test {

/// A definition at namespace level, or of a class inside another: lines `first` to `last` from 1.
struct Definition {
  enum class Kind { class_, member } kind = Kind::class_;
  std::string
      of;  ///< the class, or the class that the member function belongs to; without namespaces and outer classes
  std::size_t first = 0, last = 0;
  [[nodiscard]] std::size_t lines() const { return last - first + 1; }
  bool operator==(const Definition&) const = default;
};

/// Definitions of classes and, outside them, of their member functions; `code` without comments (see code_only).
[[nodiscard]] std::vector<Definition> definitions(const std::string& code);

/// A class with the lines of its definition and of all its member functions.
struct ClassLength {
  std::string name, path;
  std::size_t lines = 0;
};

/// Of all classes that the sources define. A member function belongs to the class of its name in its own file, else in
/// a header of its floor, else in a header of its room.
[[nodiscard]] std::vector<ClassLength> class_lengths(const std::vector<Source>& sources);

}  // namespace gapcheck::architecture_test
