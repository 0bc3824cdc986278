#include <fmt/format.h>

#include <algorithm>

#include "base/large_array.hpp"
#include "keyword/rows.hpp"
#include "model/entity/erase.hpp"
#include "model/read/cards.hpp"
#include "model/read/context.hpp"

namespace gapcheck::model {
namespace {

/// `nid x y z` of *NODE; the rest of the line does not matter here.
CardLayout node_line() {
  CardLayout layout = keyword::card_layout("NODE", "card1");
  layout.fields.resize(4);
  return layout;
}

}  // namespace

void read_nodes(Context& context, const Block& block, const Options&) {
  static const CardLayout layout = node_line();
  Nodes& nodes = context.model.mesh.nodes;
  const std::size_t first = nodes.size();
  const keyword::Transform& transform = context.transform(block);
  const auto make_room = [&](std::size_t count) {
    resize_in_parallel(nodes.id, first + count);
    resize_in_parallel(nodes.x, first + count);
    resize_in_parallel(nodes.line, first + count);
    if (count > 0) nodes.origins.add(static_cast<std::uint32_t>(first), block.file);
  };
  const auto take = [&](std::size_t first_row, const keyword::Rows& rows) {
    const std::size_t to = first + first_row;
    std::copy_n(rows.integers.data(), rows.count, nodes.id.data() + to);
    std::copy_n(rows.lines.data(), rows.count, nodes.line.data() + to);
    for (std::size_t i = 0; i < rows.count; ++i) {
      const double* x = &rows.reals[3 * i];
      nodes.x[to + i] = transform.apply(transform.length_factor * Vector(x[0], x[1], x[2]));
    }
  };
  keyword::read_rows_in_pieces(context.deck, block, layout, context.diagnostics, make_room, take);
}

void finish_nodes(Context& context) {
  Nodes& nodes = context.model.mesh.nodes;
  const auto place = [&](std::uint32_t i) { return Place{nodes.origins.file(i), nodes.line[i]}; };
  std::vector<std::uint32_t> dropped;
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    if (nodes.id[i] > 0) continue;
    context.bad_id(place(i), fmt::format("node id {} is not positive; the node is left out", nodes.id[i]));
    dropped.push_back(i);
  }
  erase_positions(dropped, nodes.origins, nodes.id, nodes.x, nodes.line);
  const std::vector<std::uint32_t> again = nodes.lookup.build(nodes.id);
  for (const std::uint32_t i : again)
    context.duplicate("node", nodes.id[i], place(*nodes.lookup.find(nodes.id[i])), place(i), IdKind::node);
  if (again.empty()) return;
  erase_positions(again, nodes.origins, nodes.id, nodes.x, nodes.line);
  nodes.lookup.build(nodes.id);
}

}  // namespace gapcheck::model
