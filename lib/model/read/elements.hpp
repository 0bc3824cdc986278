#pragma once
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "model/read/context.hpp"

namespace gapcheck::model {

/// Elements as written: element, part and node ids, row by row; zero = blank.
struct ElementRows {
  std::size_t nodes = 0;             ///< per element
  std::vector<std::int64_t> values;  ///< count x (2 + nodes)
  std::vector<std::uint32_t> lines;  ///< count
  [[nodiscard]] std::size_t size() const { return lines.size(); }
  [[nodiscard]] const std::int64_t* row(std::size_t i) const { return &values[i * (2 + nodes)]; }
};

/// The words for one kind of element, and how many nodes it must have.
struct ElementTraits {
  std::string_view what;       ///< "shell"
  std::size_t required_nodes;  ///< blank nodes after these are fine
  bool needs_part = true;
};

/// Appends one element's line to the rows.
void append_row(ElementRows& rows, const Card& card, std::size_t nodes);

/// Looks up nodes and parts and appends the elements to the existing ones. Blank nodes after the required ones repeat
/// the last node given (with N = 2: stay none). Elements with unknown nodes or without a positive id are reported and
/// left out. Returns the rows left out, ascending.
template <std::size_t N>
std::vector<std::uint32_t> append_elements(Context& context, const Block& block, const ElementTraits& traits,
                                           const ElementRows& rows, Elements<N>& elements);

/// The same for a whole block of rows `eid pid n1 … nN`, in parallel and straight from the text.
template <std::size_t N>
void read_elements(Context& context, const Block& block, const ElementTraits& traits, Elements<N>& elements);

extern template std::vector<std::uint32_t> append_elements<1>(Context&, const Block&, const ElementTraits&,
                                                              const ElementRows&, Elements<1>&);
extern template std::vector<std::uint32_t> append_elements<2>(Context&, const Block&, const ElementTraits&,
                                                              const ElementRows&, Elements<2>&);
extern template std::vector<std::uint32_t> append_elements<4>(Context&, const Block&, const ElementTraits&,
                                                              const ElementRows&, Elements<4>&);
extern template std::vector<std::uint32_t> append_elements<8>(Context&, const Block&, const ElementTraits&,
                                                              const ElementRows&, Elements<8>&);
extern template void read_elements<4>(Context&, const Block&, const ElementTraits&, Elements<4>&);
extern template void read_elements<8>(Context&, const Block&, const ElementTraits&, Elements<8>&);

}  // namespace gapcheck::model
