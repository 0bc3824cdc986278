#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "model/entity/raw_sets.hpp"
#include "model/entity/set_members.hpp"
#include "model/model.hpp"

namespace gapcheck::model {

/// Finds nodes, elements, parts and segments that belong together. Every call spends one step of the budget per entity
/// visited, and returns nothing if the budget is exhausted.
class Selection {
 public:
  /// Both must outlive the selection.
  Selection(const Model& model, Budget& budget) : model_(model), budget_(budget) {}

  [[nodiscard]] std::optional<std::uint32_t> find(SetKind kind, std::int64_t id) const;
  /// Those of the ids first, first + step, … last that exist, ascending.
  [[nodiscard]] Members range(SetKind kind, std::int64_t first, std::int64_t last, std::int64_t step) const;
  [[nodiscard]] Members all(SetKind kind) const;
  /// Entities with all their nodes in the box; parts with all their elements.
  [[nodiscard]] Members in_box(SetKind kind, const Box& box) const;
  /// Converts things of one kind to another: elements as their nodes or faces, parts as their elements, faces or nodes,
  /// segments as nodes. Faces of solids and thick shells are those that only one of the elements has. Nothing if one
  /// kind does not consist of the other.
  [[nodiscard]] std::optional<Members> convert(Members members, SetKind from, SetKind to) const;

 private:
  template <class Visitor>
  void visit(SetKind kind, const Visitor& visitor) const;
  template <class Select>
  [[nodiscard]] Members elements(SetKind kind, const Select& select) const;
  template <class Select>
  [[nodiscard]] Members surface(const Select& select) const;
  [[nodiscard]] Members faces_of(SetKind kind, const Members& members) const;
  [[nodiscard]] Members nodes_of(SetKind kind, const Members& members) const;
  template <class Inside>
  [[nodiscard]] Members parts_inside(const Inside& inside) const;
  [[nodiscard]] std::vector<std::uint8_t> marked_parts(const Members& parts) const;

  const Model& model_;
  Budget& budget_;
};

}  // namespace gapcheck::model
