#include "model/elements.hpp"

#include <fmt/format.h>

#include <atomic>
#include <map>

#include "base/parallel.hpp"
#include "keyword/rows.hpp"
#include "model/cards.hpp"
#include "model/erase.hpp"

namespace gapcheck::model {
namespace {

constexpr std::size_t grain = 8192;

/// Looks parts up; elements of one part mostly stand together, so the last answer is kept.
class PartFinder {
 public:
  explicit PartFinder(const Context& context) : context_(context) {}
  PartIndex find(std::int64_t id) {
    if (id != id_) part_ = context_.part(id_ = id);
    return part_;
  }

 private:
  const Context& context_;
  std::int64_t id_ = 0;
  PartIndex part_ = none<PartIndex>;
};

/// The nodes of one row; false with the id in `bad` where one is not known.
template <std::size_t N>
bool find_nodes(const Nodes& nodes, const ElementTraits& traits, const std::int64_t* ids, std::size_t given,
                std::array<NodeIndex, N>& out, std::int64_t& bad) {
  NodeIndex last = none<NodeIndex>;
  for (std::size_t i = 0; i < N; ++i) {
    const std::int64_t id = i < given ? ids[i] : 0;
    if (id == 0 && i >= traits.required_nodes) {
      out[i] = N == 2 ? none<NodeIndex> : last;
      continue;
    }
    const auto found = nodes.lookup.find(id);
    if (!found) {
      bad = id;
      return false;
    }
    out[i] = last = NodeIndex(*found);
  }
  return true;
}

void report_unknown_parts(Context& context, const Block& block, const ElementTraits& traits, const ElementRows& rows,
                          const std::vector<std::uint32_t>& dropped) {
  struct Use {
    std::size_t first = 0, count = 0;
  };
  std::map<std::int64_t, Use> uses;
  std::size_t next = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (next < dropped.size() && dropped[next] == i) {
      ++next;
      continue;
    }
    const std::int64_t part = rows.row(i)[1];
    if (!traits.needs_part && part == 0) continue;
    if (context.part(part) != none<PartIndex>) continue;
    Use& use = uses[part];
    if (use.count++ == 0) use.first = i;
  }
  for (const auto& [part, use] : uses)
    context.unknown(fmt::format("part {} is not defined, but {} elements use it (first: {} {})", part, use.count,
                                traits.what, rows.row(use.first)[0]),
                    Context::place(block, rows.lines[use.first]));
}

}  // namespace

ElementRows read_element_rows(Context& context, const Block& block, std::size_t nodes) {
  keyword::Rows rows = keyword::read_rows(context.deck, block, element_line(nodes), context.diagnostics);
  return {nodes, std::move(rows.integers), std::move(rows.lines)};
}

void append_row(ElementRows& rows, const Card& card, std::size_t nodes) {
  rows.nodes = nodes;
  for (std::size_t i = 0; i < 2 + nodes; ++i) rows.values.push_back(card.integer(i));
  rows.lines.push_back(card.line());
}

template <std::size_t N>
std::vector<std::uint32_t> append_elements(Context& context, const Block& block, const ElementTraits& traits,
                                           const ElementRows& rows, Elements<N>& elements) {
  if (rows.size() == 0) return {};
  const Nodes& nodes = context.model.mesh.nodes;
  const std::size_t first = elements.size(), count = rows.size();
  elements.id.resize(first + count);
  elements.nodes.resize(first + count);
  elements.part.resize(first + count);
  elements.line.insert(elements.line.end(), rows.lines.begin(), rows.lines.end());
  std::atomic<bool> some_bad = false, some_partless = false;
  parallel_for(count, grain, [&](std::size_t begin, std::size_t end) {
    PartFinder parts(context);
    std::int64_t bad = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const std::int64_t* row = rows.row(i);
      elements.id[first + i] = row[0];
      const PartIndex part = elements.part[first + i] = parts.find(row[1]);
      if (part == none<PartIndex>) some_partless = true;
      if (row[0] <= 0 || !find_nodes(nodes, traits, row + 2, rows.nodes, elements.nodes[first + i], bad))
        some_bad = true;
    }
  });
  elements.origins.add(static_cast<std::uint32_t>(first), block.file);

  std::vector<std::uint32_t> dropped;
  for (std::size_t i = 0; some_bad && i < count; ++i) {
    const std::int64_t* row = rows.row(i);
    std::int64_t bad = 0;
    const Place place = Context::place(block, rows.lines[i]);
    if (row[0] <= 0)
      context.error(place, fmt::format("{} id {} is not positive; the element is left out", traits.what, row[0]));
    else if (std::array<NodeIndex, N> unused; !find_nodes(nodes, traits, row + 2, rows.nodes, unused, bad))
      context.unknown(
          fmt::format("{} {} names node {}, which is not defined; the element is left out", traits.what, row[0], bad),
          place);
    else
      continue;
    dropped.push_back(static_cast<std::uint32_t>(i));
  }
  if (!dropped.empty()) {
    std::vector<std::uint32_t> positions = dropped;
    for (std::uint32_t& position : positions) position += static_cast<std::uint32_t>(first);
    // All dropped entries belong to the last range of the origins, which may stay as it is.
    erase_column(positions, elements.id);
    erase_column(positions, elements.nodes);
    erase_column(positions, elements.part);
    erase_column(positions, elements.line);
  }
  if (some_partless) report_unknown_parts(context, block, traits, rows, dropped);
  return dropped;
}

template std::vector<std::uint32_t> append_elements<1>(Context&, const Block&, const ElementTraits&, const ElementRows&,
                                                       Elements<1>&);
template std::vector<std::uint32_t> append_elements<2>(Context&, const Block&, const ElementTraits&, const ElementRows&,
                                                       Elements<2>&);
template std::vector<std::uint32_t> append_elements<4>(Context&, const Block&, const ElementTraits&, const ElementRows&,
                                                       Elements<4>&);
template std::vector<std::uint32_t> append_elements<8>(Context&, const Block&, const ElementTraits&, const ElementRows&,
                                                       Elements<8>&);

}  // namespace gapcheck::model
