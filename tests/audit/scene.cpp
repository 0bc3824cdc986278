#include "audit/scene.hpp"

#include <fmt/format.h>

#include <iterator>

namespace gapcheck::audit_test {
namespace {

void write_parts(const Scene& scene, std::string& text) {
  auto out = std::back_inserter(text);
  for (const auto& part : scene.parts) {
    fmt::format_to(out, "*PART\npart {0}\n{0},{0},1\n", part.id);
    if (part.solid)
      fmt::format_to(out, "*SECTION_SOLID\n{},1,0\n", part.id);
    else
      fmt::format_to(out, "*SECTION_SHELL\n{},2,1.0,2\n{},{},{},{}\n", part.id, part.thickness, part.thickness,
                     part.thickness, part.thickness);
  }
  for (const auto& set : scene.sets) {
    fmt::format_to(out, "*SET_PART_LIST\n{:>10}\n", set.id);
    for (std::size_t i = 0; i < set.parts.size(); ++i)
      fmt::format_to(out, "{:>10}{}", set.parts[i], i % 8 == 7 || i + 1 == set.parts.size() ? "\n" : "");
  }
}

void write_mesh(const Scene& scene, std::string& text) {
  auto out = std::back_inserter(text);
  text += "*NODE\n";
  for (const auto& node : scene.nodes)
    fmt::format_to(out, "{},{},{},{}\n", node.id, node.x.x(), node.x.y(), node.x.z());
  for (const bool solid : {false, true}) {
    text += solid ? "*ELEMENT_SOLID\n" : "*ELEMENT_SHELL\n";
    for (const auto& element : scene.elements) {
      if (element.solid() != solid) continue;
      fmt::format_to(out, "{:>8}{:>8}", element.id, element.part);
      for (const auto node : element.nodes) fmt::format_to(out, "{:>8}", node);
      if (element.nodes.size() == 3) fmt::format_to(out, "{:>8}", element.nodes[2]);
      text += '\n';
    }
  }
}

void write_contact(const Scene::Contact& c, std::string& text) {
  auto out = std::back_inserter(text);
  fmt::format_to(out, "*CONTACT_{}_ID\n{:>10}contact\n", c.keyword, c.id);
  fmt::format_to(out, "{},{},{},{}\n", c.set_a, c.set_b, c.set_a == 0 ? 5 : 2, c.set_b == 0 ? 0 : 2);
  fmt::format_to(out, "0.0,0.0,0.0,0.0,0.0,0\n");
  fmt::format_to(out, "1.0,1.0,{},{},{},{},1.0,1.0\n", c.sst, c.mst, c.sfst, c.sfmt);
  fmt::format_to(out, "0,0.1,0,0.0,0,0,0,0\n0.0,0,0,{},0,0,0.0,0.0\n", c.snlog);
  if (c.ignore != 0) fmt::format_to(out, "1,{},0.0,0.0\n", c.ignore);
}

}  // namespace

std::string Scene::text() const {
  std::string text = "*KEYWORD\n";
  fmt::format_to(std::back_inserter(text), "*CONTROL_CONTACT\n0.1,0.0,2,0,1,0,1,0\n0,0,10,0,4.0,{},0,0\n", ssthk);
  text += "*MAT_ELASTIC\n1,7.85e-9,210000.0,0.3\n";
  write_parts(*this, text);
  write_mesh(*this, text);
  for (const auto& contact : contacts) write_contact(contact, text);
  return text + "*END\n";
}

}  // namespace gapcheck::audit_test
