#include <algorithm>

#include "keyword/rows.hpp"
#include "model/read/cards.hpp"
#include "model/read/elements.hpp"

namespace gapcheck::model {
namespace {

constexpr ElementTraits solid{"solid", 4};
constexpr std::size_t ids_per_line = 10;

/// How a form of *ELEMENT_SOLID with its own lines of nodes is laid out.
struct SolidForm {
  std::string_view option;
  std::size_t node_lines;
  std::size_t corners;  ///< how many of its nodes are corners
};
constexpr SolidForm forms[] = {{"H20", 2, 8}, {"H27", 3, 8}, {"H64", 7, 8}, {"T15", 2, 4}, {"T20", 2, 4}};
constexpr SolidForm plain_form{"", 1, 8};

const SolidForm& form_of(const Options& options) {
  for (const SolidForm& form : forms)
    if (options.has(form.option)) return form;
  return plain_form;
}

/// Collects solids from lines of ten ids. One line `eid pid n1 … n8`, or one line `eid pid` and then lines of nodes,
/// possibly different for each element.
class SolidRows {
 public:
  SolidRows(const Context& context, const Block& block, const SolidForm& form)
      : context_(context), block_(block), form_(form) {
    rows_.nodes = 8;
  }
  [[nodiscard]] bool complete() const { return lines_left_ == 0; }
  void add(const std::int64_t* ids, std::uint32_t line) {
    if (complete())
      begin(ids, line);
    else
      add_nodes(ids);
  }
  [[nodiscard]] ElementRows finish() && { return std::move(rows_); }

 private:
  void begin(const std::int64_t* ids, std::uint32_t line) {
    rows_.values.push_back(context_.with_offset(block_, IdKind::element, ids[0]));
    rows_.values.push_back(context_.with_offset(block_, IdKind::part, ids[1]));
    rows_.lines.push_back(line);
    const bool header_only = std::all_of(ids + 2, ids + ids_per_line, [](std::int64_t id) { return id == 0; });
    if (!header_only) {
      push_nodes(ids + 2, std::min<std::size_t>(8, form_.corners));
      return;
    }
    rows_.values.resize(rows_.values.size() + 8);
    lines_left_ = form_.node_lines;
  }
  void add_nodes(const std::int64_t* ids) {
    if (lines_left_-- != form_.node_lines) return;
    rows_.values.resize(rows_.values.size() - 8);
    const bool ten_node_tetrahedron = form_.node_lines == 1 && (ids[8] != 0 || ids[9] != 0);
    push_nodes(ids, ten_node_tetrahedron ? 4 : form_.corners);
  }
  void push_nodes(const std::int64_t* ids, std::size_t corners) {
    for (std::size_t i = 0; i < 8; ++i)
      rows_.values.push_back(i < corners ? context_.with_offset(block_, IdKind::node, ids[i]) : 0);
  }

  const Context& context_;
  const Block& block_;
  const SolidForm& form_;
  ElementRows rows_;
  std::size_t lines_left_ = 0;
};

/// With extra lines between the elements they are read one by one.
ElementRows read_with_extra_lines(Context& context, const Block& block, const SolidForm& form, std::size_t extra) {
  static const CardLayout ids = id_line(ids_per_line, 8, IdKind::plain);
  SolidRows solids(context, block, form);
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    const Card card = reader.next(ids);
    std::int64_t row[ids_per_line];
    for (std::size_t i = 0; i < ids_per_line; ++i) row[i] = card.integer(i);
    solids.add(row, card.line());
    if (solids.complete()) skip_lines(reader, static_cast<std::int64_t>(extra));
  }
  return std::move(solids).finish();
}

ElementRows read_in_bulk(Context& context, const Block& block, const SolidForm& form) {
  static const CardLayout ids = id_line(ids_per_line, 8, IdKind::plain);
  const keyword::Rows rows = keyword::read_rows(context.deck, block, ids, context.diagnostics);
  SolidRows solids(context, block, form);
  for (std::size_t i = 0; i < rows.count; ++i) solids.add(&rows.integers[i * ids_per_line], rows.lines[i]);
  return std::move(solids).finish();
}

}  // namespace

void read_solids(Context& context, const Block& block, const Options& options) {
  const SolidForm& form = form_of(options);
  const std::size_t extra = 2 * options.count({"ORTHO"}) + options.count({"DOF"});
  const ElementRows rows =
      extra > 0 ? read_with_extra_lines(context, block, form, extra) : read_in_bulk(context, block, form);
  append_elements(context, block, solid, rows, context.model.mesh.solids);
}

}  // namespace gapcheck::model
