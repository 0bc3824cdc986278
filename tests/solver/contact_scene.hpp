#pragma once
#include <functional>
#include <memory>
#include <string>

#include "model/read.hpp"
#include "solver/contact/contact_forces.hpp"
#include "solver/structure_of.hpp"

namespace gapcheck::solver {

/// A deck with its contacts, ready to step. `prepare` sets velocities and constraints, `add_forces` further forces.
struct ContactScene {
  using Prepare = std::function<void(Structure&)>;

  explicit ContactScene(const std::string& deck, const Prepare& prepare = {}, StepSettings settings = {})
      : ContactScene(model::read_text(deck), prepare, settings) {}

  explicit ContactScene(model::Read the_model, const Prepare& prepare = {}, StepSettings settings = {})
      : read(std::move(the_model)), surfaces(read.model) {
    EXPECT_EQ(read.errors(), 0u) << read.text();
    contact::InitialCounters counters;
    initial = contact::initialise_contacts(read.model, surfaces, {}, counters);
    Diagnostics diagnostics;
    auto built = build_structure(read.model, {}, diagnostics);
    if (!built) {
      why_not = built.error().message;
      return;
    }
    Structure structure = std::move(built).value();
    structure.state.x = initial.x;
    if (prepare) prepare(structure);
    std::vector<bool> movable(structure.state.x.size());
    for (std::size_t i = 0; i < movable.size(); ++i)
      movable[i] = !structure.rigid.holds(i) && (structure.constraints.mask(i) & 7u) != 7u;
    stepper = std::make_unique<Stepper>(std::move(structure), settings);
    auto forces = std::make_unique<ContactForces>(read.model, surfaces, initial, movable);
    contacts = forces.get();
    stepper->add(std::move(forces));
  }
  void step(int times = 1) {
    for (int i = 0; i < times; ++i)
      if (const SolverStatus status = stepper->step(); !status.ok()) FAIL() << status.error().message;
  }
  [[nodiscard]] const State& state() const { return stepper->state(); }
  [[nodiscard]] const ContactState& result(std::size_t i = 0) const { return contacts->states()[i]; }
  [[nodiscard]] Vector momentum() const {
    Vector sum = Vector::Zero();
    for (std::size_t i = 0; i < state().x.size(); ++i) sum += state().mass[i] * state().v[i];
    return sum;
  }

  model::Read read;
  std::string why_not;  ///< the structure cannot be built; then there is no stepper
  contact::SurfaceStore surfaces;
  contact::InitialState initial;
  std::unique_ptr<Stepper> stepper;
  ContactForces* contacts = nullptr;
};

/// One quad of material 009 in z = 0 from 0 to 1, nodes 1 to 4 with 1 kg each beside its own mass of nothing, and node
/// 5 of mass 1 above its middle at `height`; contact of node 5 against the quad with thickness `thickness`. `cards`:
/// further lines of the contact from card 3 on, `controls`: keywords.
inline std::string node_over_quad(double height, double thickness, const std::string& options = "",
                                  const std::string& controls = "", const std::string& friction = "0.") {
  return fmt::format(
             "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n5,0.5,0.5,{}\n"
             "*ELEMENT_SHELL\n1,1,1,2,3,4\n*ELEMENT_MASS\n1,1,1.\n2,2,1.\n3,3,1.\n4,4,1.\n5,5,1.\n"
             "*PART\np\n1,1,1\n*SECTION_SHELL\n1,2\n{}\n*MAT_ELASTIC\n1,1e-9,1000.,0.25\n"
             "*SET_NODE_LIST\n1\n5\n*SET_PART_LIST\n1\n1\n",
             height, thickness) +
         controls + "*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n1,1,4,2\n" + friction + "\n1.,1.\n" + options;
}

}  // namespace gapcheck::solver
