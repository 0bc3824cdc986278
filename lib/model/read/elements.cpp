#include "model/read/elements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>

#include "base/large_array.hpp"
#include "base/parallel.hpp"
#include "keyword/rows.hpp"
#include "model/entity/erase.hpp"
#include "model/read/cards.hpp"

namespace gapcheck::model {
namespace {

constexpr std::size_t grain = 8192;

/// Looks up parts; elements of one part are mostly consecutive, so the last answer is kept.
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

/// The nodes of one row; false with the id in `bad` if one is unknown.
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

/// Appends rows to the existing elements, in pieces that may come in any order and from several threads.
template <std::size_t N>
class Appender {
 public:
  Appender(Context& context, const Block& block, const ElementTraits& traits, Elements<N>& elements)
      : context_(context), block_(block), traits_(traits), elements_(elements), first_(elements.size()) {}

  void take_all(const ElementRows& rows) {
    make_room(rows.size());
    parallel_for(rows.size(), grain, [&](std::size_t begin, std::size_t end) {
      take(begin, end - begin, rows.nodes, rows.row(begin), rows.lines.data() + begin);
    });
  }

  /// The rows of the whole block, straight from the text.
  void take_block() {
    keyword::read_rows_in_pieces(
        context_.deck, block_, element_line(N), context_.diagnostics, [&](std::size_t count) { make_room(count); },
        [&](std::size_t first, const keyword::Rows& rows) {
          take(first, rows.count, N, rows.integers.data(), rows.lines.data());
        });
  }

  /// Reports faults and removes the rows left out; returns them, ascending.
  std::vector<std::uint32_t> finish() {
    std::sort(faults_.left_out.begin(), faults_.left_out.end(),
              [](const LeftOut& a, const LeftOut& b) { return a.row < b.row; });
    std::vector<std::uint32_t> dropped, positions;
    for (const LeftOut& out : faults_.left_out) {
      report(out);
      dropped.push_back(out.row);
      positions.push_back(out.row + static_cast<std::uint32_t>(first_));
    }
    if (!dropped.empty()) {
      // All of them belong to the last range of the origins, which may stay as it is.
      erase_column(positions, elements_.id);
      erase_column(positions, elements_.nodes);
      erase_column(positions, elements_.part);
      erase_column(positions, elements_.line);
    }
    for (const auto& [part, use] : faults_.unknown_parts)
      context_.unknown(fmt::format("part {} is not defined, but {} elements use it (first: {} {})", part, use.count,
                                   traits_.what, context_.id_text(block_.file, IdKind::element, use.id)),
                       Context::place(block_, use.line));
    return dropped;
  }

 private:
  struct LeftOut {
    std::uint32_t row, line;
    std::int64_t id, unknown_node;
  };
  /// Of one part: the first element, and how many.
  struct Use {
    std::uint32_t row = 0, line = 0;
    std::int64_t id = 0;
    std::size_t count = 0;
    void add(const Use& other) {
      const std::size_t sum = count + other.count;
      if (count == 0 || other.row < row) *this = other;
      count = sum;
    }
  };
  struct Faults {
    std::vector<LeftOut> left_out;
    std::map<std::int64_t, Use> unknown_parts;
  };

  void make_room(std::size_t count) {
    if (count == 0) return;
    resize_in_parallel(elements_.id, first_ + count);
    resize_in_parallel(elements_.nodes, first_ + count);
    resize_in_parallel(elements_.part, first_ + count);
    resize_in_parallel(elements_.line, first_ + count);
    elements_.origins.add(static_cast<std::uint32_t>(first_), block_.file);
  }

  /// Row `first_row` and the following ones; each has `nodes` ids after the element's and the part's.
  void take(std::size_t first_row, std::size_t count, std::size_t nodes, const std::int64_t* values,
            const std::uint32_t* lines) {
    PartFinder parts(context_);
    Faults faults;
    const std::size_t to = first_ + first_row;
    std::copy_n(lines, count, elements_.line.data() + to);
    for (std::size_t i = 0; i < count; ++i) {
      const std::int64_t* row = values + i * (2 + nodes);
      const auto number = static_cast<std::uint32_t>(first_row + i);
      elements_.id[to + i] = row[0];
      elements_.part[to + i] = parts.find(row[1]);
      std::int64_t unknown_node = 0;
      if (row[0] <= 0 ||
          !find_nodes(context_.model.mesh.nodes, traits_, row + 2, nodes, elements_.nodes[to + i], unknown_node))
        faults.left_out.push_back({number, lines[i], row[0], unknown_node});
      else if (elements_.part[to + i] == none<PartIndex> && (traits_.needs_part || row[1] != 0))
        faults.unknown_parts[row[1]].add({number, lines[i], row[0], 1});
    }
    if (!faults.left_out.empty() || !faults.unknown_parts.empty()) keep(std::move(faults));
  }

  void keep(Faults&& faults) {
    const std::lock_guard lock(mutex_);
    faults_.left_out.insert(faults_.left_out.end(), faults.left_out.begin(), faults.left_out.end());
    for (const auto& [part, use] : faults.unknown_parts) faults_.unknown_parts[part].add(use);
  }

  void report(const LeftOut& out) {
    const Place place = Context::place(block_, out.line);
    if (out.id <= 0)
      context_.bad_id(place, fmt::format("{} id {} is not positive; the element is left out", traits_.what, out.id));
    else
      context_.unknown(fmt::format("{} {} names node {}, which is not defined; the element is left out", traits_.what,
                                   context_.id_text(block_.file, IdKind::element, out.id),
                                   context_.id_text(block_.file, IdKind::node, out.unknown_node)),
                       place);
  }

  Context& context_;
  const Block& block_;
  const ElementTraits& traits_;
  Elements<N>& elements_;
  std::size_t first_;
  std::mutex mutex_;
  Faults faults_;
};

}  // namespace

void append_row(ElementRows& rows, const Card& card, std::size_t nodes) {
  rows.nodes = nodes;
  for (std::size_t i = 0; i < 2 + nodes; ++i) rows.values.push_back(card.integer(i));
  rows.lines.push_back(card.line());
}

template <std::size_t N>
std::vector<std::uint32_t> append_elements(Context& context, const Block& block, const ElementTraits& traits,
                                           const ElementRows& rows, Elements<N>& elements) {
  Appender<N> appender(context, block, traits, elements);
  appender.take_all(rows);
  return appender.finish();
}

template <std::size_t N>
void read_elements(Context& context, const Block& block, const ElementTraits& traits, Elements<N>& elements) {
  Appender<N> appender(context, block, traits, elements);
  appender.take_block();
  appender.finish();
}

template std::vector<std::uint32_t> append_elements<1>(Context&, const Block&, const ElementTraits&, const ElementRows&,
                                                       Elements<1>&);
template std::vector<std::uint32_t> append_elements<2>(Context&, const Block&, const ElementTraits&, const ElementRows&,
                                                       Elements<2>&);
template std::vector<std::uint32_t> append_elements<4>(Context&, const Block&, const ElementTraits&, const ElementRows&,
                                                       Elements<4>&);
template std::vector<std::uint32_t> append_elements<8>(Context&, const Block&, const ElementTraits&, const ElementRows&,
                                                       Elements<8>&);
template void read_elements<4>(Context&, const Block&, const ElementTraits&, Elements<4>&);
template void read_elements<8>(Context&, const Block&, const ElementTraits&, Elements<8>&);

}  // namespace gapcheck::model
