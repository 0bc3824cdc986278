#include "keyword/include_transforms.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "keyword/rows.hpp"
#include "keyword/transformation.hpp"

namespace gapcheck::keyword {
namespace {

double factor(const Card& card, std::string_view field) {
  const double value = card.real(field);
  return value == 0 ? 1 : value;
}

void read_offset(Transform& transform, IdKind kind, const Card& card, std::string_view field) {
  transform.offset[static_cast<std::size_t>(kind)] = card.integer(field);
}

using Definitions = std::map<std::int64_t, const Block*>;

Definitions find_definitions(const std::vector<std::uint32_t>& positions, const Deck& deck, Diagnostics& diagnostics) {
  Definitions definitions;
  for (const std::uint32_t position : positions) {
    const Block& block = deck.blocks()[position];
    const std::int64_t id = transformation_id(deck, block, diagnostics);
    if (!definitions.emplace(id, &block).second)
      diagnostics.error(deck.file(block.file).path, block.line,
                        "*DEFINE_TRANSFORMATION " + std::to_string(id) + " is defined again; remove one of them");
  }
  return definitions;
}

/// A node as its first definition has it.
struct WrittenNode {
  std::tuple<std::uint32_t, std::size_t> order;  ///< block and row
  Vector x = Vector::Zero();
  const Block* block = nullptr;
};
using WrittenNodes = std::map<std::int64_t, WrittenNode>;

/// Fills in the nodes with these ids; those that the deck does not define keep no block.
void find_written_nodes(const Deck& deck, WrittenNodes& nodes) {
  static const CardLayout layout = [] {
    CardLayout line = card_layout("NODE", "card1");
    line.fields.resize(4);
    return line;
  }();
  if (nodes.empty()) return;
  std::mutex found;
  Diagnostics unused;  // the reader of the nodes reports their faults
  for (const Block& block : deck.blocks()) {
    if (block.name != "NODE") continue;
    const auto take = [&](std::size_t first, const Rows& rows) {
      for (std::size_t i = 0; i < rows.count; ++i) {
        const auto node = nodes.find(rows.integers[i]);
        if (node == nodes.end()) continue;
        const std::lock_guard lock(found);
        WrittenNode& entry = node->second;
        const std::tuple order(block.order, first + i);
        if (entry.block == nullptr || order < entry.order)
          entry = {order, {rows.reals[3 * i], rows.reals[3 * i + 1], rows.reals[3 * i + 2]}, &block};
      }
    };
    read_rows_in_pieces(
        deck, block, layout, unused, [](std::size_t) {}, take);
  }
}

/// The nodes that the transformations of includes refer to.
class ReferredNodes {
 public:
  ReferredNodes(const Deck& deck, const std::vector<Transform>& all) : deck_(deck), all_(all) {}
  void add(const Block& definition) {
    for (const std::int64_t id : transformation_nodes(deck_, definition)) nodes_.try_emplace(id);
  }
  void find() { find_written_nodes(deck_, nodes_); }
  [[nodiscard]] bool none_referred() const { return nodes_.empty(); }

  /// Where a node lies in the coordinates of the file that includes `own`. Transformations before `own` are known.
  [[nodiscard]] Result<Vector> position(std::int64_t id, TransformIndex own, TransformIndex parent) const {
    const auto node = nodes_.find(id);
    if (node == nodes_.end() || node->second.block == nullptr)
      return plain_error("node " + std::to_string(id) + " is not defined");
    const Block& block = *node->second.block;
    if (block.transform.value >= own.value)
      return plain_error("node " + std::to_string(id) + " is defined in " + deck_.file(block.file).path +
                         ", which is placed by this transformation or included after it; refer to nodes of files "
                         "before it");
    if (block.transform == parent) return node->second.x;
    const Transform& of = all_[block.transform.value];
    const Transform& frame = all_[parent.value];
    const Vector x = of.apply(of.length_factor * node->second.x) - frame.shift;
    const Eigen::FullPivLU<Eigen::Matrix3d> inverse(frame.matrix * frame.length_factor);
    if (!inverse.isInvertible())
      return plain_error("node " + std::to_string(id) +
                         " has no place in the including file, whose own transformation flattens it");
    return Vector(inverse.solve(x));
  }

 private:
  const Deck& deck_;
  const std::vector<Transform>& all_;
  WrittenNodes nodes_;
};

}  // namespace

IncludeTransform read_include_transform(CardReader& reader) {
  IncludeTransform include;
  Transform& own = include.own;
  const Card ids = reader.next(card_layout("INCLUDE_TRANSFORM", "card2"));
  read_offset(own, IdKind::node, ids, "idnoff");
  read_offset(own, IdKind::element, ids, "ideoff");
  read_offset(own, IdKind::part, ids, "idpoff");
  read_offset(own, IdKind::material, ids, "idmoff");
  read_offset(own, IdKind::set, ids, "idsoff");
  read_offset(own, IdKind::function, ids, "idfoff");
  read_offset(own, IdKind::define, ids, "iddoff");
  read_offset(own, IdKind::other, reader.next(card_layout("INCLUDE_TRANSFORM", "card3")), "idroff");
  const Card factors = reader.next(card_layout("INCLUDE_TRANSFORM", "card4"));
  own.mass_factor = factor(factors, "fctmas");
  own.time_factor = factor(factors, "fcttim");
  own.length_factor = factor(factors, "fctlen");
  const Card last = reader.next(card_layout("INCLUDE_TRANSFORM", "card5"));
  include.transformation = last.integer("tranid");
  include.line = last.line();
  return include;
}

IncludeTransform read_include_offsets(CardReader& reader) {
  IncludeTransform include;
  include.line = reader.block().line;
  const Card ids = reader.next(card_layout("INCLUDE_AUTO_OFFSET_USER", "card2"));
  read_offset(include.own, IdKind::node, ids, "noffset");
  read_offset(include.own, IdKind::element, ids, "neoffset");
  return include;
}

TransformIndex IncludeTransforms::add(std::vector<Transform>& all, TransformIndex parent,
                                      const IncludeTransform& include, const Block& block, const std::string& path,
                                      Diagnostics& diagnostics) {
  const Transform& own = include.own;
  Transform total = all[parent.value];
  for (std::size_t i = 0; i < total.offset.size(); ++i)
    if (__builtin_add_overflow(total.offset[i], own.offset[i], &total.offset[i])) {
      diagnostics.error(path, block.line, "*" + block.name + ": the id offset is too large");
      total.offset[i] = 0;
    }
  total.automatic = total.automatic || own.automatic;
  total.length_factor *= own.length_factor;
  total.mass_factor *= own.mass_factor;
  total.time_factor *= own.time_factor;
  const TransformIndex index(static_cast<std::uint32_t>(all.size()));
  all.push_back(total);
  pending_.push_back({index, parent, include.transformation, block.file, include.line});
  return index;
}

void IncludeTransforms::resolve(std::vector<Transform>& all, const Deck& deck, Diagnostics& diagnostics) const {
  if (std::none_of(pending_.begin(), pending_.end(), [](const Pending& each) { return each.transformation != 0; }))
    return;
  const Definitions definitions = find_definitions(definitions_, deck, diagnostics);
  ReferredNodes nodes(deck, all);
  for (const Pending& pending : pending_)
    if (const auto definition = definitions.find(pending.transformation); definition != definitions.end())
      nodes.add(*definition->second);
  nodes.find();
  // With nodes a placement depends on the file that includes; its faults are reported once.
  std::map<std::pair<std::int64_t, std::uint32_t>, std::optional<Placement>> placements;
  std::set<std::int64_t> reported;
  for (const Pending& pending : pending_) {
    Placement own;
    if (pending.transformation != 0) {
      const auto definition = definitions.find(pending.transformation);
      if (definition == definitions.end()) {
        diagnostics.error(deck.file(pending.file).path, pending.line,
                          "*INCLUDE_TRANSFORM refers to transformation " + std::to_string(pending.transformation) +
                              ", which is not defined; add *DEFINE_TRANSFORMATION or clear TRANID");
      } else {
        const std::uint32_t frame = nodes.none_referred() ? 0 : pending.parent.value;
        const auto [entry, is_new] = placements.try_emplace({pending.transformation, frame});
        if (is_new) {
          Diagnostics again;
          entry->second = read_transformation(
              deck, *definition->second,
              [&](std::int64_t id) { return nodes.position(id, pending.own, pending.parent); },
              reported.insert(pending.transformation).second ? diagnostics : again);
        }
        own = entry->second.value_or(Placement{});
      }
    }
    const Transform& parent = all[pending.parent.value];
    Transform& total = all[pending.own.value];
    total.places = pending.transformation != 0 || parent.places;
    total.matrix = parent.matrix * own.matrix;
    total.shift = parent.length_factor * (parent.matrix * own.shift) + parent.shift;
  }
}

}  // namespace gapcheck::keyword
