#include "audit/shared_results.hpp"

namespace gapcheck::audit {

contact::InitialOptions SharedResults::initial_options() const {
  const AuditOptions& given = selection_.options();
  contact::InitialOptions options;
  options.contacts = given.contacts;
  options.tolerance = given.ptol;
  options.mode = given.exact ? geometry::Mode::exact : geometry::Mode::filtered;
  options.brute_force = given.brute_force;
  constexpr std::size_t most_listed = 1'000'000;
  options.most_listed = most_listed;
  return options;
}

contact::ContactMesh& SharedResults::contact_mesh() {
  ++requests_;
  if (!contact_mesh_) contact_mesh_.emplace(selection_.model(), surfaces_, selection_.contacts());
  return *contact_mesh_;
}

contact::InitialState& SharedResults::initial() {
  ++requests_;
  if (!initial_) {
    contact::InitialOptions options = initial_options();
    options.segments = selection_.needs(Need::segment_penetrations);
    options.mortar = selection_.needs(Need::mortar_penetrations);
    options.edges = selection_.needs(Need::edge_penetrations);
    options.moved_into = selection_.needs(Need::moved_nodes);
    options.overlaps = selection_.needs(Need::intended_overlaps);
    initial_ = contact::initialise_contacts(selection_.model(), surfaces_, options, counters_);
  }
  return *initial_;
}

contact::InitialState SharedResults::initial_if(contact::SurfaceStore& surfaces,
                                                const std::vector<ContactIndex>& chosen) {
  const model::Model& model = selection_.model();
  contact::InitialOptions options = initial_options();
  options.nodes_stay = true;
  options.contacts.clear();
  for (const ContactIndex i : chosen) options.contacts.push_back(model.contact(i).id.value);
  // Tied nodes are not reported against the parts they are tied to, so the ties must be made.
  for (const ContactIndex i : selection_.contacts())
    if (contact::classify(model.contact(i)).family == contact::Family::tied)
      options.contacts.push_back(model.contact(i).id.value);
  return contact::initialise_contacts(model, surfaces, options, other_counters_);
}

const contact::PredictedTimesteps& SharedResults::timesteps() {
  ++requests_;
  if (!timesteps_) timesteps_ = contact::predict_timesteps(selection_.model(), surfaces_, selection_.contacts());
  return *timesteps_;
}

}  // namespace gapcheck::audit
