#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lsp/line_cards.hpp"
#include "lsp/scope.hpp"

namespace gapcheck::app::lsp {

/// What the ids of a deck count, each on its own.
enum class Kind : std::uint8_t {
  part,
  section,
  material,
  state_equation,
  hourglass,
  contact,
  node_set,
  part_set,
  segment_set,
  shell_set,
  solid_set,
  beam_set,
  thick_shell_set,
  discrete_set,
  any_set,  ///< of a reference that does not say which
  curve,
  box,
  system,
  vector,
  transformation,
  node,
  element,
  parameter,
};

/// "part", "set of nodes".
[[nodiscard]] std::string_view name_of(Kind kind);

struct Symbol {
  Kind kind = Kind::part;
  std::int64_t id = 0;  ///< of the model, with the offsets of the include
  std::string name{};   ///< of parameters, in lower case
  /// Whether both mean the same thing.
  [[nodiscard]] bool same(const Symbol& other) const;
};

/// A field, or a parameter in it, that defines or names something.
struct Occurrence {
  Symbol symbol;
  bool definition = false;
  bool by_parameter = false;  ///< the id is the value of a parameter or an expression
  std::uint32_t line = 0;
  std::size_t begin = 0, end = 0;  ///< bytes of what is written
  /// What is written in the field, and the columns that it has; the same as bytes where there are no tabs. In free
  /// format a width of 0: any.
  std::size_t field_begin = 0, field_end = 0, column = 0, width = 0;
};

/// What the fields of a line define and name, and the parameters in them.
[[nodiscard]] std::vector<Occurrence> occurrences(const FileView& file, const CardLine& card, std::string_view line,
                                                  std::uint32_t number);

/// The one at a byte of a line; parameters first.
[[nodiscard]] std::optional<Occurrence> occurrence_at(const FileView& file, Place place);

/// Which lines are looked at.
enum class Reach : std::uint8_t {
  definitions,  ///< those of keywords that define such things
  cards,        ///< all but nodes and elements
  everything,
};

/// Calls visit for all that mean the symbol, in order, until it returns false.
void for_each_occurrence(const FileView& file, const Symbol& symbol, Reach reach,
                         const std::function<bool(const Occurrence&)>& visit);

/// Something that is defined, with its title: the line before it, or a text beside it.
struct Defined {
  Occurrence at;
  std::string title;  ///< empty: none
};

/// What a keyword defines, without nodes and elements.
[[nodiscard]] std::vector<Defined> definitions_in(const FileView& file, const Keyword& keyword);

/// As names of parameters are compared.
[[nodiscard]] std::string lower_case(std::string_view text);
/// True for what a parameter's name may consist of.
[[nodiscard]] bool in_name(char c);

}  // namespace gapcheck::app::lsp
