#include "solver/contact/edge_springs.hpp"

#include "contact/stiffness/segment_mass.hpp"
#include "contact/stiffness/stiffness.hpp"

namespace gapcheck::solver {

using contact::SurfaceEdge;

EdgeSprings::EdgeSprings(const ContactSetting& setting, ContactIndex contact, const contact::EdgeScene& scene,
                         const std::vector<SurfaceEdge>& edges)
    : scene_(scene.scene()),
      edges_(edges),
      friction_(setting.model, setting.model.contact(contact)),
      penopt_(setting.model.controls.penopt) {
  const model::Contact& card = scene_.contact;
  const double slsfac = setting.model.controls.slsfac, solid_modulus = card.sldthk > 0 ? card.sldstf : 0;
  for (const SurfaceEdge& edge : edges_) {
    Edge& spring = of_edge_.emplace_back();
    spring.scale = slsfac * (scene.on_b(edge) ? card.sfm : card.sfs);
    spring.stiffness =
        setting.masses.springs(scene_.segments, edge.segment.value, spring.scale, false, solid_modulus).stiffness;
    spring.mass = setting.masses.mass[edge.a.value] + setting.masses.mass[edge.b.value];
    spring.segment_mass = contact::segment_mass(setting.model, setting.masses.sizes, setting.masses.mass,
                                                scene_.segments, edge.segment.value);
    spring.part = contact::part_of(setting.model.mesh, scene_.segments, edge.segment.value);
  }
}

LinkSpring EdgeSprings::between(std::uint32_t tracked, std::uint32_t other) const {
  const Edge &e = of_edge_[tracked], &f = of_edge_[other];
  const double thickness = 2 * edges_[tracked].half;
  const model::Contact& contact = scene_.contact;
  const std::int64_t soft = contact.soft == 2 && !scene_.type.by_segments() ? 1 : contact.soft;
  const double first = e.stiffness > 0 ? e.stiffness : f.stiffness;
  const double second = f.stiffness > 0 ? f.stiffness : e.stiffness;
  ContactSprings::Spring masses{0, e.mass, f.mass};
  LinkSpring spring;
  if (soft == 2) {
    spring.stiffness = contact::soft_2_stiffness(e.scale, e.segment_mass, f.segment_mass, timestep_);
  } else {
    spring.stiffness = contact::spring_stiffness(penopt_, {first, second, first, thickness});
    if (soft == 1)
      spring.stiffness = contact::soft_1_spring(spring.stiffness, contact.sofscl,
                                                contact::soft_1_stiffness(e.mass, f.mass, timestep_));
  }
  masses.stiffness = spring.stiffness;
  spring.damping = ContactSprings::damping(masses, contact.vdc);
  spring.rubs = friction_.any();
  if (spring.rubs) {
    spring.friction = friction_.between(e.part, f.part);
    // Two crossing strips as wide as they are thick.
    spring.area = thickness * 2 * edges_[other].half;
  }
  return spring;
}

}  // namespace gapcheck::solver
