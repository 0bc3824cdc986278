#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "contact/surface/contact_surfaces.hpp"
#include "solver/interface/contact_source.hpp"

namespace gapcheck::solver {

/// The force transducers of a model: sums of other contacts' forces. With one surface, all forces on its nodes; with
/// two, those of automatic contacts between points of the one and of the other, if both points lie only on nodes of
/// their surfaces. Among transducers with two surfaces a force goes only to the first one, unless FTALL = 1. Moments
/// that ties put on rotations are not measured.
class Transducers {
 public:
  /// The model must outlive it.
  Transducers(const model::Model& model, contact::SurfaceStore& surfaces);
  /// What they measure, in deck order: force and moment of the sides; no energies.
  [[nodiscard]] std::vector<ContactState> measure(std::span<const ContactView> contacts, const State& state) const;

 private:
  using Marks = std::vector<bool>;  ///< by node
  struct Transducer {
    ContactIndex contact;  ///< position in Model::contacts
    bool between = false;  ///< it has two surfaces
    Marks a, b;
  };
  /// Adds a link; true: it is used up.
  static bool add(const Transducer& transducer, const ContactLink& link, const State& state, ContactState& sum);

  const model::Model& model_;
  std::vector<Transducer> transducers_;
};

}  // namespace gapcheck::solver
