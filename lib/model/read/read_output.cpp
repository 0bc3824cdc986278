#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "model/read/cards.hpp"
#include "model/read/context.hpp"

namespace gapcheck::model {
namespace {

/// Where the interval of a keyword is kept.
double& interval_of(std::string_view keyword, Output& output) {
  constexpr std::array<std::pair<std::string_view, double Output::*>, 16> files{{
      {"DATABASE_GLSTAT", &Output::glstat},
      {"DATABASE_MATSUM", &Output::matsum},
      {"DATABASE_NODOUT", &Output::nodout},
      {"DATABASE_RCFORC", &Output::rcforc},
      {"DATABASE_SLEOUT", &Output::sleout},
      {"DATABASE_NCFORC", &Output::ncforc},
      {"DATABASE_SECFORC", &Output::secforc},
      {"DATABASE_SPCFORC", &Output::spcforc},
      {"DATABASE_BNDOUT", &Output::bndout},
      {"DATABASE_RWFORC", &Output::rwforc},
      {"DATABASE_RBDOUT", &Output::rbdout},
      {"DATABASE_SWFORC", &Output::swforc},
      {"DATABASE_ELOUT", &Output::elout},
      {"DATABASE_DEFORC", &Output::deforc},
      {"DATABASE_JNTFORC", &Output::jntforc},
      {"DATABASE_ABSTAT", &Output::abstat},
  }};
  for (const auto& [name, interval] : files)
    if (keyword.starts_with(name)) return output.*interval;
  return output.d3plot;
}

/// "elout" of DATABASE_ELOUT, "intfor" of DATABASE_BINARY_INTFOR_FILE.
std::string file_of(std::string_view keyword) {
  for (const std::string_view word : {"DATABASE_", "BINARY_"})
    if (keyword.starts_with(word)) keyword.remove_prefix(word.size());
  if (keyword == "NODOUT_HF") return "the second nodout of the nodes with HFO (*DATABASE_NODOUT_HF)";
  std::string name(keyword.substr(0, keyword.find('_')));
  for (char& letter : name)
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  return name;
}

/// Where a file is written: as text, in the binout, or both.
void read_binary(const Card& card, const Block& block, Place place, Output& output) {
  const std::int64_t binary = card.integer("binary");
  const std::string file = file_of(block.name);
  const auto note = [&](const char* why) {
    output.notes.push_back(
        {place, fmt::format("*{}: BINARY = {} {}; {} is written as text", block.name, binary, why, file)});
  };
  const bool branch = std::find(binout_branches.begin(), binout_branches.end(), file) != binout_branches.end();
  if (binary < 0 || binary > 3)
    note("is none of 0, 1, 2, 3");
  else if (branch)
    output.binary.insert_or_assign(file, static_cast<int>(binary));
  else if (binary > 1)
    note("asks for a binout, which does not hold it");
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

/// The elements of one kind that elout has.
class ElementHistory {
 public:
  ElementHistory(Context& context, std::string_view keyword) : context_(context), keyword_(keyword) {
    Model& model = context.model;
    if (keyword.starts_with("DATABASE_HISTORY_SOLID"))
      choose(model.mesh.solids.lookup, model.sets.solids, model.output.history_solids, "solid");
    else if (keyword.starts_with("DATABASE_HISTORY_BEAM"))
      choose(model.mesh.beams.lookup, model.sets.beams, model.output.history_beams, "beam");
    else
      choose(model.mesh.shells.lookup, model.sets.shells, model.output.history_shells, "shell");
    for (const HistoryElement& entry : *list_) known_.insert(entry.element);
  }

  void add_id(std::int64_t id, std::string_view title, Place place) {
    if (id == 0) return;
    if (const auto found = lookup_->find(id))
      add(*found, title);
    else
      note(fmt::format("*{} names {} {}, which does not exist", keyword_, what_, id), place);
  }
  void add_set(std::int64_t id, Place place) {
    if (id == 0) return;
    const auto found = sets_->find(id);
    if (found == sets_->end())
      return note(fmt::format("*{} names {} set {}, which does not exist", keyword_, what_, id), place);
    for (const std::uint32_t element : found->second.members) add(element, "");
  }

 private:
  using ElementSets = std::map<std::int64_t, Set<std::uint32_t>>;
  void choose(const IdLookup& lookup, const ElementSets& sets, std::vector<HistoryElement>& list,
              std::string_view what) {
    lookup_ = &lookup;
    sets_ = &sets;
    list_ = &list;
    what_ = what;
  }
  void note(std::string text, Place place) { context_.model.output.notes.push_back({place, std::move(text)}); }
  void add(std::uint32_t element, std::string_view title) {
    if (known_.insert(element).second) list_->push_back({element, std::string(title)});
  }

  Context& context_;
  std::string_view keyword_, what_;
  const IdLookup* lookup_ = nullptr;
  const ElementSets* sets_ = nullptr;
  std::vector<HistoryElement>* list_ = nullptr;
  std::set<std::uint32_t> known_;
};

}  // namespace

void read_title(Context& context, const Block& block, const Options&) {
  CardReader reader(context.deck, block, context.diagnostics);
  if (!reader.at_end() && context.model.title.empty())
    context.model.title = reader.next(text_line()).text(std::size_t{0});
}

void read_database(Context& context, const Block& block, const Options& options) {
  CardReader reader(context.deck, block, context.diagnostics);
  if (reader.at_end()) return;
  const bool plot = block.name == "DATABASE_BINARY_D3PLOT";
  const Card card = reader.next(keyword::card_layout(plot ? "DATABASE_BINARY_D3PLOT" : "DATABASE_GLSTAT", "card1"));
  const double interval = card.real("dt") * context.transform(block).time_factor;
  const Place place = Context::place(block, card.line());
  Output& output = context.model.output;
  if (card.integer(plot ? "lcdt" : "lcur") != 0)
    output.notes.push_back({place, fmt::format("*{}: the curve of intervals is not used, only DT", block.name)});
  if (options.has("FILTER")) output.notes.push_back({place, fmt::format("*{}: forces are not filtered", block.name)});
  if (!plot) read_binary(card, block, place, output);
  if (interval > 0 && std::isfinite(interval))
    interval_of(block.name, output) = interval;
  else if (interval != 0)
    output.notes.push_back({place, fmt::format("*{}: DT = {:g} is not an interval", block.name, interval)});
}

void read_intfor(Context& context, const Block& block, const Options& options) {
  CardReader reader(context.deck, block, context.diagnostics);
  const bool named = options.has("FILE");
  if (named && !reader.at_end()) static_cast<void>(reader.next(text_line()));
  if (reader.at_end()) return;
  const Card card = reader.next(keyword::card_layout("DATABASE_BINARY_D3PLOT", "card1"));
  const double interval = card.real("dt") * context.transform(block).time_factor;
  Output& output = context.model.output;
  const Place place = Context::place(block, card.line());
  const auto note = [&](const std::string& text) {
    output.notes.push_back({place, fmt::format("*{}: {}", block.name, text)});
  };
  if (card.integer("lcdt") != 0) note("the curve of intervals is not used, only DT");
  if (named) note("the file is called intfor, whatever the card says");
  if (interval > 0 && std::isfinite(interval)) {
    output.intfor = interval;
    output.intfor_place = place;
  } else if (interval != 0) {
    note(fmt::format("DT = {:g} is not an interval", interval));
  }
}

void read_unwritten_database(Context& context, const Block& block, const Options& options) {
  CardReader reader(context.deck, block, context.diagnostics);
  if (options.has("FILE") && !reader.at_end()) static_cast<void>(reader.next(text_line()));
  if (reader.at_end()) return;
  const Card card = reader.next(keyword::card_layout("DATABASE_GLSTAT", "card1"));
  if (!(card.real("dt") > 0) && card.integer("lcur") == 0) return;
  context.model.output.unwritten.push_back({Context::place(block, card.line()), file_of(block.name)});
}

void read_history_elements(Context& context, const Block& block, const Options& options) {
  ElementHistory history(context, block.name);
  const auto& layout = keyword::card_layout(options.has("SET")  ? "DATABASE_HISTORY_SOLID_SET"
                                            : options.has("ID") ? "DATABASE_HISTORY_SOLID_ID"
                                                                : "DATABASE_HISTORY_SOLID",
                                            "card1");
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    const Card card = reader.next(layout);
    const Place place = Context::place(block, card.line());
    if (options.has("ID") && !options.has("SET")) {
      history.add_id(card.integer("id1"), card.text("heading"), place);
      continue;
    }
    for (std::size_t i = 0; i < card.size(); ++i)
      options.has("SET") ? history.add_set(card.integer(i), place) : history.add_id(card.integer(i), "", place);
  }
}

void read_unwritten_history(Context& context, const Block& block, const Options&) {
  context.model.output.notes.push_back({Context::place(block, block.line),
                                        fmt::format("*{}: elout has no thick shells and other elements", block.name)});
}

void read_intfor_values(Context& context, const Block& block, const Options&) {
  context.model.output.notes.push_back(
      {Context::place(block, block.line),
       fmt::format("*{}: intfor has pressure, shear stress and forces of each segment, whatever is asked for; gaps, "
                   "energies and wear are not written, since their places are not published",
                   block.name)});
}

void read_control_output(Context& context, const Block& block, const Options&) {
  CardReader reader(context.deck, block, context.diagnostics);
  if (!reader.at_end()) static_cast<void>(reader.next(keyword::card_layout("CONTROL_OUTPUT", "card1")));
  if (!reader.at_end())
    context.model.output.local_shells =
        reader.next(keyword::card_layout("CONTROL_OUTPUT", "card2")).integer("eocs") == 1;
}

void read_history_nodes(Context& context, const Block& block, const Options& options) {
  CardReader reader(context.deck, block, context.diagnostics);
  if (options.has("LOCAL")) {
    context.model.output.notes.push_back(
        {Context::place(block, block.line),
         fmt::format("*{}: motion in local axes is not written; request the nodes without _LOCAL", block.name)});
    return;
  }
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
