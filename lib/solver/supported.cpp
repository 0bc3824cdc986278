#include "solver/supported.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <tuple>

#include "base/embedded.hpp"
#include "contact/definition/contact_type.hpp"
#include "solver/build/build_spring_law.hpp"
#include "solver/build/material/build_equation_of_state.hpp"
#include "solver/build/material/build_erosion.hpp"
#include "solver/build/material/build_foam_rubber.hpp"
#include "solver/build/material/build_johnson_cook.hpp"
#include "solver/build/material/build_orthotropic.hpp"
#include "solver/build/material/build_plasticity.hpp"
#include "solver/condition/relaxation.hpp"
#include "solver/condition/rigid_walls.hpp"
#include "solver/contact/contact_method.hpp"

namespace gapcheck::embedded {
extern const std::span<const Text> supported_keywords;
}

namespace gapcheck::solver {
namespace {

enum class Treatment : std::uint8_t { calculated, harmless, by_model, refused };

struct Entry {
  std::string_view pattern;  ///< without the `*`
  bool prefix = false;
  Treatment treatment = Treatment::refused;
  std::string_view why;
  [[nodiscard]] bool fits(std::string_view name) const { return prefix ? name.starts_with(pattern) : name == pattern; }
};

std::string_view next_word(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  const std::string_view word = text.substr(0, text.find(' '));
  text.remove_prefix(word.size());
  return word;
}

Entry entry(std::string_view word, Treatment treatment, std::string_view why) {
  const bool prefix = word.ends_with('*');
  return {word.substr(0, word.size() - (prefix ? 1 : 0)), prefix, treatment, why};
}

void read_line(std::string_view line, std::vector<Entry>& entries) {
  if (line.starts_with('#')) return;
  const std::string_view head = next_word(line);
  if (head == "refused") {
    const std::string_view word = next_word(line);
    line.remove_prefix(std::min<std::size_t>(1, line.size()));
    entries.push_back(entry(word, Treatment::refused, line));
    return;
  }
  const Treatment treatment = head == "calculated" ? Treatment::calculated
                              : head == "harmless" ? Treatment::harmless
                                                   : Treatment::by_model;
  for (std::string_view word = next_word(line); !word.empty(); word = next_word(line))
    entries.push_back(entry(word, treatment, ""));
}

const std::vector<Entry>& table() {
  static const std::vector<Entry> entries = [] {
    std::vector<Entry> list;
    std::string_view text = embedded::supported_keywords[0].content;
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      read_line(text.substr(0, end), list);
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    return list;
  }();
  return entries;
}

/// Without the words ID and TITLE after the first one.
std::string bare(std::string_view name) {
  std::string result;
  for (std::size_t at = 0; at <= name.size();) {
    const std::size_t end = std::min(name.find('_', at), name.size());
    const std::string_view word = name.substr(at, end - at);
    if (at == 0 || (word != "ID" && word != "TITLE")) result += (at == 0 ? "" : "_") + std::string(word);
    at = end + 1;
  }
  return result;
}

const Entry* find(std::string_view name) {
  const Entry* best = nullptr;
  for (const Entry& candidate : table())
    if (candidate.fits(name) && (best == nullptr || candidate.pattern.size() > best->pattern.size())) best = &candidate;
  return best;
}

/// Collects findings with their location.
class Finder {
 public:
  Finder(const keyword::Deck& deck, const model::Model& model) : deck_(deck), model_(model) {}

  std::vector<Unsupported> all() {
    find_keywords();
    find_materials();
    find_erosions();
    find_states();
    find_contacts();
    find_rigid_walls();
    find_moves();
    find_settings();
    std::stable_sort(found_.begin(), found_.end(), [](const Found& a, const Found& b) {
      return std::tuple(a.place.file, a.place.line) < std::tuple(b.place.file, b.place.line);
    });
    std::vector<Unsupported> list;
    for (Found& one : found_) list.push_back(std::move(one.what));
    return list;
  }

 private:
  struct Found {
    model::Place place;
    Unsupported what;
  };
  void add(std::string_view keyword, model::Place place, std::string why) {
    const std::string file = place.file.value < model_.files.size() ? model_.files[place.file.value] : "";
    found_.push_back({place, {std::string(keyword), file, place.line, std::move(why)}});
  }

  void find_keywords() {
    // What the solver need not calculate may be a misspelt form of what it must.
    std::map<std::string_view, std::string> misspelt;
    for (const model::UnknownKeyword& unknown : model_.unknown_keywords)
      if (misspelt.size() < model::unknown_keywords_looked_up)
        misspelt.emplace(unknown.name, model::nearest_keyword(unknown));
    for (const keyword::Block& block : deck_.blocks()) {
      const Entry* known = find(bare(block.name));
      if (const auto unknown = misspelt.find(block.name); unknown != misspelt.end()) {
        add(block.name, {block.file, block.line},
            unknown->second.empty() ? "it is not a known keyword"
                                    : fmt::format("it is not a known keyword; did you mean *{}?", unknown->second));
        continue;
      }
      if (known != nullptr && known->treatment != Treatment::refused) continue;
      add(block.name, {block.file, block.line},
          known != nullptr ? std::string(known->why) : "the solver does not know this keyword");
    }
  }

  template <std::size_t N>
  void mark(const model::Elements<N>& elements, std::vector<bool>& used) const {
    for (const PartIndex part : elements.part)
      if (part.value < used.size()) used[part.value] = true;
  }

  void find_materials() {
    constexpr std::array<std::string_view, 23> continua{"MAT_ELASTIC",
                                                        "MAT_JOHNSON_COOK",
                                                        "MAT_SIMPLIFIED_JOHNSON_COOK",
                                                        "MAT_ELASTIC_PLASTIC_HYDRO",
                                                        "MAT_PLASTIC_KINEMATIC",
                                                        "MAT_NULL",
                                                        "MAT_RIGID",
                                                        "MAT_MOONEY-RIVLIN_RUBBER",
                                                        "MAT_POWER_LAW_PLASTICITY",
                                                        "MAT_MODIFIED_PIECEWISE_LINEAR_PLASTICITY",
                                                        "MAT_PLASTICITY_WITH_DAMAGE",
                                                        "MAT_ORTHOTROPIC_ELASTIC",
                                                        "MAT_FABRIC",
                                                        "MAT_VISCOELASTIC",
                                                        "MAT_BLATZ-KO_RUBBER",
                                                        "MAT_LOW_DENSITY_FOAM",
                                                        "MAT_CRUSHABLE_FOAM",
                                                        "MAT_OGDEN_RUBBER",
                                                        "MAT_HYPERELASTIC_RUBBER",
                                                        "MAT_SIMPLIFIED_RUBBER",
                                                        "MAT_SPOTWELD",
                                                        "MAT_PIECEWISE_LINEAR_PLASTICITY",
                                                        "MAT_TRANSVERSELY_ANISOTROPIC_ELASTIC_PLASTIC"};
    std::vector<bool> used(model_.parts.size()), beams(model_.parts.size()), material_seen(model_.materials.size());
    mark(model_.mesh.shells, used);
    mark(model_.mesh.solids, used);
    mark(model_.mesh.thick_shells, used);
    mark(model_.mesh.beams, used);
    mark(model_.mesh.beams, beams);
    for (std::size_t i = 0; i < beams.size(); ++i)
      if (const auto section = model_.parts[i].section; section && model_.sections[*section].integrated())
        beams[i] = false;
    mark(model_.mesh.discrete, used);
    for (std::size_t i = 0; i < used.size(); ++i) {
      const auto position = model_.parts[i].material;
      if (!used[i] || !position || material_seen[*position]) continue;
      material_seen[*position] = true;
      const model::Material& material = model_.materials[*position];
      const bool known = std::find(continua.begin(), continua.end(), material.keyword) != continua.end();
      if (const std::string why = spring_not_calculated(material); !why.empty()) {
        add(material.keyword, material.place, fmt::format("material {}: {}", material.id, why));
        continue;
      }
      if (!known && !material.discrete && !material.discrete_beam) {
        add(material.keyword, material.place, fmt::format("material {} is of no kind that is calculated", material.id));
        continue;
      }
      if (material.plasticity) find_plasticity(material, beams[i]);
      if (material.orthotropic) find_element_axes(material);
      if (material.johnson_cook)
        if (const std::string why = johnson_cook_not_calculated(*material.johnson_cook); !why.empty())
          add(material.keyword, material.place, fmt::format("material {}: {}", material.id, why));
      for (const std::string& why :
           {foam_rubber_not_calculated(model_, material), plasticity_not_calculated(material),
            material.orthotropic ? orthotropic_not_calculated(*material.orthotropic) : std::string()})
        if (!why.empty()) add(material.keyword, material.place, fmt::format("material {}: {}", material.id, why));
      if (material.hydro)
        if (const std::string why = hydro_not_calculated(*material.hydro); !why.empty())
          add(material.keyword, material.place, fmt::format("material {}: {}", material.id, why));
      if (material.weld && !material.weld->variant.empty())
        add(material.keyword, material.place,
            fmt::format("material {}: the variant {} is not calculated", material.id, material.weld->variant));
    }
  }

  /// Angles that elements add to the axes of their material are not read.
  void find_element_axes(const model::Material& material) {
    for (const keyword::Block& block : deck_.blocks())
      if (block.name.starts_with("ELEMENT_SHELL") &&
          (block.name.find("_BETA") != std::string::npos || block.name.find("_MCID") != std::string::npos))
        return add(block.name, {block.file, block.line},
                   fmt::format("the axes that it gives to orthotropic material {} are not calculated", material.id));
  }

  void find_plasticity(const model::Material& material, bool of_beams) {
    const model::Plasticity& data = *material.plasticity;
    const auto name = [&](std::string_view what) {
      add(material.keyword, material.place, fmt::format("material {}: {}", material.id, what));
    };
    if (of_beams && data.failure_strain > 0 && data.failure_strain < 1e20) name("beams do not fail (FS, FAIL)");
    if (data.failure_strain < 0) name("failure by a subroutine (FAIL < 0) is not calculated");
    if (data.lcsr != 0) name("the factor over the strain rate (LCSR) is not calculated");
    const bool table = data.lcss != 0 && model_.tables.count(data.lcss) > 0;
    if (data.other_vp != 0 && (data.by_rate() || table))
      name(fmt::format("the rate of VP = {:g} is not calculated", data.other_vp));
  }

  void find_erosions() {
    for (const model::Erosion& erosion : model_.erosions) {
      const auto name = [&](std::string_view what) {
        add("MAT_ADD_EROSION", erosion.place, fmt::format("material {}: {}", erosion.material_id, what));
      };
      if (const std::string why = erosion_not_calculated(erosion); !why.empty()) name(why);
      const auto is_of = [&](PartIndex part) {
        const auto material = part.value < model_.parts.size() ? model_.part(part).material : std::nullopt;
        return material && model_.materials[*material].id == erosion.material_id;
      };
      const auto& beams = model_.mesh.beams.part;
      if (std::any_of(beams.begin(), beams.end(), is_of)) name("beams do not erode");
    }
  }

  void find_states() {
    for (const auto& [id, state] : model_.equations_of_state)
      if (const std::string why = state_not_calculated(state); !why.empty() && find(bare(state.keyword)) != nullptr)
        add(state.keyword, state.place, fmt::format("equation of state {}: {}", id, why));
  }

  void find_contacts() {
    for (const model::Contact& contact : model_.contacts) {
      if (contact.symmetry_faces != 0 && contact.symmetry_faces != 1)
        add(contact.written, contact.place,
            fmt::format("contact {}: ISYM = {} has no meaning; set 0 or 1", contact.id.value, contact.symmetry_faces));
      const std::string_view why = choose_method(contact).why_not;
      if (why.empty()) continue;
      add(contact.written, contact.place, fmt::format("contact {}: {}", contact.id.value, why));
    }
  }

  void find_rigid_walls() {
    for (const model::RigidWall& wall : model_.rigid_walls)
      if (const std::string_view why = wall_not_calculated(wall); !why.empty())
        add(wall.keyword, wall.place, fmt::format("wall {}: {}", wall.id, why));
  }

  /// The run begins where the model's nodes are.
  void find_moves() {
    for (const model::NotMoved& one : model_.not_moved) add(one.keyword, one.place, one.why);
  }

  void find_settings() {
    const model::Controls& controls = model_.controls;
    if (controls.tslimt != 0)
      add("CONTROL_TIMESTEP", controls.timestep_place, "shells that soften to keep a step (TSLIMT) are not calculated");
    find_relaxation();
    if (controls.erode != 0 && controls.erode != 1)
      add("CONTROL_TIMESTEP", controls.timestep_place,
          fmt::format("ERODE = {} is not calculated; 0 and 1 are", controls.erode));
  }

  /// Of the ways to relax the explicit one of all parts is calculated; IDRFLG -999 switches it off.
  void find_relaxation() {
    const model::Controls& controls = model_.controls;
    const auto name = [&](std::string_view why) {
      add("CONTROL_DYNAMIC_RELAXATION", controls.relaxation_place,
          fmt::format("IDRFLG = {}: {}", controls.idrflg, why));
    };
    switch (controls.idrflg) {
      case -999:
        return;
      case 0:
      case 1:
        break;
      case -1:
        name("no time histories are written during the relaxation; set IDRFLG to 1");
        break;
      case 2:
        name("nodes are not placed by a file; set IDRFLG to 1 and give the loads curves with SIDR = 1");
        break;
      case 3:
      case -3:
        name("convergence is not checked by parts (DRPSET); set IDRFLG to 1, which checks all");
        break;
      case 5:
      case 6:
        name("nothing is calculated implicitly; set IDRFLG to 1 for an explicit relaxation");
        break;
      default:
        name("this value has no meaning; set 0, 1 or -999");
    }
    if (relaxes(model_) && controls.irelal != 0)
      add("CONTROL_DYNAMIC_RELAXATION", controls.relaxation_place,
          fmt::format("IRELAL = {}: the velocities are scaled by a constant factor only; set IRELAL to 0 and choose "
                      "DRFCTR",
                      controls.irelal));
  }

  const keyword::Deck& deck_;
  const model::Model& model_;
  std::vector<Found> found_;
};

}  // namespace

std::vector<Unsupported> unsupported(const keyword::Deck& deck, const model::Model& model) {
  return Finder(deck, model).all();
}

}  // namespace gapcheck::solver
