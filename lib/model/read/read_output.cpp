#include <fmt/format.h>

#include <cmath>
#include <set>

#include "model/read/cards.hpp"
#include "model/read/context.hpp"

namespace gapcheck::model {
namespace {

/// Where the interval of a keyword is kept.
double& interval_of(std::string_view keyword, Output& output) {
  if (keyword.starts_with("DATABASE_GLSTAT")) return output.glstat;
  if (keyword.starts_with("DATABASE_MATSUM")) return output.matsum;
  if (keyword.starts_with("DATABASE_NODOUT")) return output.nodout;
  if (keyword.starts_with("DATABASE_RCFORC")) return output.rcforc;
  if (keyword.starts_with("DATABASE_SLEOUT")) return output.sleout;
  if (keyword.starts_with("DATABASE_NCFORC")) return output.ncforc;
  return output.d3plot;
}

/// "elout" of DATABASE_ELOUT, "intfor" of DATABASE_BINARY_INTFOR_FILE.
std::string file_of(std::string_view keyword) {
  for (const std::string_view word : {"DATABASE_", "BINARY_"})
    if (keyword.starts_with(word)) keyword.remove_prefix(word.size());
  std::string name(keyword.substr(0, keyword.find('_')));
  for (char& letter : name)
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  return name;
}

class HistoryNodes {
 public:
  explicit HistoryNodes(Context& context) : context_(context) {
    for (const HistoryNode& entry : list()) known_.insert(entry.node);
  }

  void add_node(std::int64_t id, std::string_view title, Place place) {
    if (id == 0) return;
    if (const auto found = context_.model.mesh.nodes.lookup.find(id))
      add(NodeIndex{*found}, title);
    else
      note(fmt::format("*DATABASE_HISTORY_NODE names node {}, which does not exist", id), place);
  }
  void add_set(std::int64_t id, Place place) {
    if (id == 0) return;
    const auto& sets = context_.model.sets.nodes;
    const auto found = sets.find(id);
    if (found == sets.end())
      return note(fmt::format("*DATABASE_HISTORY_NODE_SET names node set {}, which does not exist", id), place);
    for (const NodeIndex node : found->second.members) add(node, "");
  }

 private:
  std::vector<HistoryNode>& list() { return context_.model.output.history_nodes; }
  void note(std::string text, Place place) { context_.model.output.notes.push_back({place, std::move(text)}); }
  void add(NodeIndex node, std::string_view title) {
    if (known_.insert(node).second) list().push_back({node, std::string(title)});
  }

  Context& context_;
  std::set<NodeIndex> known_;
};

}  // namespace

void read_title(Context& context, const Block& block, const Options&) {
  CardReader reader(context.deck, block, context.diagnostics);
  if (!reader.at_end() && context.model.title.empty())
    context.model.title = reader.next(text_line()).text(std::size_t{0});
}

void read_database(Context& context, const Block& block, const Options&) {
  CardReader reader(context.deck, block, context.diagnostics);
  if (reader.at_end()) return;
  const bool plot = block.name == "DATABASE_BINARY_D3PLOT";
  const Card card = reader.next(keyword::card_layout(plot ? "DATABASE_BINARY_D3PLOT" : "DATABASE_GLSTAT", "card1"));
  const double interval = card.real("dt") * context.transform(block).time_factor;
  const Place place = Context::place(block, card.line());
  Output& output = context.model.output;
  if (card.integer(plot ? "lcdt" : "lcur") != 0)
    output.notes.push_back({place, fmt::format("*{}: the curve of intervals is not used, only DT", block.name)});
  if (interval > 0 && std::isfinite(interval))
    interval_of(block.name, output) = interval;
  else if (interval != 0)
    output.notes.push_back({place, fmt::format("*{}: DT = {:g} is not an interval", block.name, interval)});
}

void read_unwritten_database(Context& context, const Block& block, const Options& options) {
  CardReader reader(context.deck, block, context.diagnostics);
  if (options.has("FILE") && !reader.at_end()) static_cast<void>(reader.next(text_line()));
  if (reader.at_end()) return;
  const Card card = reader.next(keyword::card_layout("DATABASE_GLSTAT", "card1"));
  if (!(card.real("dt") > 0) && card.integer("lcur") == 0) return;
  context.model.output.unwritten.push_back({Context::place(block, card.line()), file_of(block.name)});
}

void read_history_nodes(Context& context, const Block& block, const Options& options) {
  CardReader reader(context.deck, block, context.diagnostics);
  const bool set = options.has("SET"), titled = options.has("ID");
  const auto& layout = keyword::card_layout(set      ? "DATABASE_HISTORY_NODE_SET"
                                            : titled ? "DATABASE_HISTORY_NODE_ID"
                                                     : "DATABASE_HISTORY_NODE",
                                            "card1");
  HistoryNodes nodes(context);
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    const Card card = reader.next(layout);
    const Place place = Context::place(block, card.line());
    if (titled && !set) {
      nodes.add_node(card.integer("id1"), card.text("heading"), place);
      continue;
    }
    for (std::size_t i = 0; i < card.size(); ++i)
      set ? nodes.add_set(card.integer(i), place) : nodes.add_node(card.integer(i), "", place);
  }
}

}  // namespace gapcheck::model
