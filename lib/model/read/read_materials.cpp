#include <fmt/format.h>

#include <algorithm>

#include "base/number.hpp"
#include "model/read/cards.hpp"
#include "model/read/context.hpp"

namespace gapcheck::model {
namespace {

/// Where a material's first card holds its elastic constants: fields of ten columns from 0 (the id); 0 = absent.
struct ElasticFields {
  std::string_view name;    ///< without MAT_
  std::string_view number;  ///< empty: none
  std::size_t young = 0, poisson = 0, bulk = 0;
};

constexpr ElasticFields materials[] = {
    {"ELASTIC", "001", 2, 3, 0},
    {"ELASTIC_FLUID", "001_FLUID", 2, 3, 6},
    {"ELASTIC_PERI", ""},
    {"ELASTIC_PHASE_CHANGE", "", 2, 3, 0},
    {"ELASTIC_PLASTIC_HYDRO", "010"},
    {"ELASTIC_SPRING_DISCRETE_BEAM", "074"},
    {"ELASTIC_6DOF_SPRING_DISCRETE_BEAM", "093"},
    {"ELASTIC_VISCOPLASTIC_THERMAL", "106", 2, 3, 0},
    {"ELASTIC_WITH_VISCOSITY", "060"},
    {"ORTHOTROPIC_ELASTIC", "002", 2, 5, 0},
    {"ANISOTROPIC_ELASTIC", "002_ANIS"},
    {"PLASTIC_KINEMATIC", "003", 2, 3, 0},
    {"ELASTIC_PLASTIC_THERMAL", "004"},
    {"SOIL_AND_FOAM", "005", 0, 0, 3},
    {"VISCOELASTIC", "006", 0, 0, 2},
    {"BLATZ-KO_RUBBER", "007"},
    {"HIGH_EXPLOSIVE_BURN", "008"},
    {"NULL", "009", 6, 7, 0},
    {"POWER_LAW_PLASTICITY", "018", 2, 3, 0},
    {"STRAIN_RATE_DEPENDENT_PLASTICITY", "019"},
    {"RIGID", "020", 2, 3, 0},
    {"ORTHOTROPIC_THERMAL", "021", 2, 5, 0},
    {"COMPOSITE_DAMAGE", "022", 2, 5, 0},
    {"PIECEWISE_LINEAR_PLASTICITY", "024", 2, 3, 0},
    {"HONEYCOMB", "026", 2, 3, 0},
    {"MOONEY-RIVLIN_RUBBER", "027", 0, 2, 0},
    {"RESULTANT_PLASTICITY", "028", 2, 3, 0},
    {"ISOTROPIC_ELASTIC_PLASTIC", "012", 0, 0, 5},
    {"ISOTROPIC_ELASTIC_FAILURE", "013", 0, 0, 5},
    {"JOHNSON_COOK", "015", 3, 4, 0},
    {"LAMINATED_GLASS", "032", 2, 3, 0},
    {"FABRIC", "034", 2, 5, 0},
    {"FABRIC_MAP", "034M"},
    {"3-PARAMETER_BARLAT", "036", 2, 3, 0},
    {"TRANSVERSELY_ANISOTROPIC_ELASTIC_PLASTIC", "037", 2, 3, 0},
    {"ENHANCED_COMPOSITE_DAMAGE", "054", 2, 5, 0},
    {"ENHANCED_COMPOSITE_DAMAGE", "055", 2, 5, 0},
    {"CLOSED_CELL_FOAM", "053", 2, 0, 0},
    {"LOW_DENSITY_FOAM", "057", 2, 0, 0},
    {"LAMINATED_COMPOSITE_FABRIC", "058", 2, 5, 0},
    {"COMPOSITE_FAILURE", "059", 2, 5, 0},
    {"KELVIN-MAXWELL_VISCOELASTIC", "061", 0, 0, 2},
    {"VISCOUS_FOAM", "062", 2, 7, 0},
    {"CRUSHABLE_FOAM", "063", 2, 3, 0},
    {"LOW_DENSITY_VISCOUS_FOAM", "073", 2, 0, 0},
    {"GENERAL_VISCOELASTIC", "076", 0, 0, 2},
    {"LINEAR_ELASTIC_DISCRETE_BEAM", "066"},
    {"NONLINEAR_ELASTIC_DISCRETE_BEAM", "067"},
    {"NONLINEAR_PLASTIC_DISCRETE_BEAM", "068"},
    {"CABLE_DISCRETE_BEAM", "071"},
    {"GENERAL_NONLINEAR_6DOF_DISCRETE_BEAM", "119"},
    {"OGDEN_RUBBER", "077_O", 0, 2, 0},
    {"HYPERELASTIC_RUBBER", "077_H", 0, 2, 0},
    {"PLASTICITY_WITH_DAMAGE", "081", 2, 3, 0},
    {"FU_CHANG_FOAM", "083", 2, 0, 0},
    {"SIMPLIFIED_JOHNSON_COOK", "098", 2, 3, 0},
    {"PLASTICITY_POLYMER", "089", 2, 3, 0},
    {"SPOTWELD", "100", 2, 3, 0},
    {"DAMAGE_1", "104", 2, 3, 0},
    {"DAMAGE_2", "105", 2, 3, 0},
    {"MODIFIED_JOHNSON_COOK", "107", 2, 3, 0},
    {"GURSON", "120", 2, 3, 0},
    {"HILL_3R", "122", 2, 3, 0},
    {"PLASTICITY_COMPRESSION_TENSION", "124", 2, 3, 0},
    {"KINEMATIC_HARDENING_TRANSVERSELY_ANISOTROPIC", "125", 2, 3, 0},
    {"MODIFIED_HONEYCOMB", "126", 2, 3, 0},
    {"BARLAT_YLD2000", "133", 2, 3, 0},
    {"DESHPANDE_FLECK_FOAM", "154", 2, 3, 0},
    {"HILL_FOAM", "177", 0, 0, 2},
    {"SAMP-1", "187", 4, 5, 2},
    {"TABULATED_JOHNSON_COOK", "224", 2, 3, 0},
    {"UHS_STEEL", "244", 2, 3, 0},
    {"LAMINATED_FRACTURE_DAIMLER_PINHO", "261", 2, 5, 0},
    {"LAMINATED_FRACTURE_DAIMLER_CAMANHO", "262", 2, 5, 0},
    {"ORTHOTROPIC_SIMPLIFIED_DAMAGE", "221", 2, 5, 0},
    {"MODIFIED_PIECEWISE_LINEAR_PLASTICITY", "123", 2, 3, 0},
    {"ARUP_ADHESIVE", "169", 2, 3, 0},
    {"SIMPLIFIED_RUBBER", "181", 0, 0, 2},
    {"SPRING_ELASTIC", "S01"},
    {"DAMPER_VISCOUS", "S02"},
    {"SPRING_ELASTOPLASTIC", "S03"},
    {"SPRING_NONLINEAR_ELASTIC", "S04"},
    {"DAMPER_NONLINEAR_VISCOUS", "S05"},
    {"SPRING_GENERAL_NONLINEAR", "S06"},
    {"SPRING_MAXWELL", "S07"},
    {"SPRING_INELASTIC", "S08"},
    {"SPRING_TRILINEAR_DEGRADING", "S13"},
    {"SPRING_SQUAT_SHEARWALL", "S14"},
    {"SPRING_MUSCLE", "S15"},
};

/// `name` is `prefix`, possibly followed by an option.
bool is_or_extends(std::string_view name, std::string_view prefix) {
  return !prefix.empty() && name.starts_with(prefix) &&
         (name.size() == prefix.size() || name[prefix.size()] == '_' || name[prefix.size()] == '/');
}

/// The entry with the longest match by name or number; nullptr if the material is not in the table.
const ElasticFields* find_material(std::string_view name) {
  const ElasticFields* best = nullptr;
  std::size_t length = 0;
  for (const ElasticFields& entry : materials)
    for (const std::string_view key : {entry.name, entry.number})
      if (key.size() > length && is_or_extends(name, key)) {
        best = &entry;
        length = key.size();
      }
  return best;
}

/// CON1 and CON2 are in fields of reals. In a local system the second has six digits.
std::int64_t constraint_code(double value) { return value > 0 && value < 1e6 ? static_cast<std::int64_t>(value) : 0; }

/// Bulk modulus from Young's modulus and Poisson's ratio; incompressible materials get that of ν = 0.4999.
double bulk_modulus(double young, double poisson) {
  constexpr double nearly_incompressible = 0.4999;
  return young / (3 * (1 - 2 * std::min(poisson, nearly_incompressible)));
}

/// "24" is the same material as "024".
std::string padded_number(std::string_view name) {
  const std::size_t digits = std::min(name.find_first_not_of("0123456789"), name.size());
  const bool is_number = digits == name.size() || name[digits] == '_';
  if (!is_number || digits == 0 || digits >= 3) return std::string(name);
  return std::string(3 - digits, '0') + std::string(name);
}

/// Springs and dampers have no density: their constants are in its field.
bool is_discrete(const ElasticFields* known) { return known != nullptr && known->number.starts_with('S'); }

/// A, B and the test of material 027.
void read_mooney_rivlin(Context& context, CardReader& reader, const Card& card, double stress, Material& material) {
  static const CardLayout four = real_line(4, 10);
  MooneyRivlin rubber{card.real(3) * stress, card.real(4) * stress, {}};
  const double length = context.transform(reader.block()).length_factor;
  const Card second = reader.next(four);
  rubber.test = {second.real(std::size_t{0}) * length, second.real(1) * length, second.real(2) * length, 0};
  if (const double curve = second.real(3); curve >= 1 && curve < 1e9)
    rubber.test.curve =
        context.with_offset(reader.block(), keyword::IdKind::function, static_cast<std::int64_t>(curve));
  material.mooney_rivlin = rubber;
  set_small_strain_moduli(material);
}

}  // namespace

void read_material(Context& context, const Block& block, const Options& options) {
  static const CardLayout first_card = id_and_reals(IdKind::material, 7);
  CardReader reader(context.deck, block, context.diagnostics);
  if (options.has("TITLE")) reader.skip();
  const Place start = Context::place(block, block.line);
  if (reader.at_end()) {
    context.error(start, fmt::format("*{} has no card", block.name));
    return;
  }
  const Card card = reader.next(first_card);
  const std::string_view after_mat = std::string_view(block.name).substr(std::string_view("MAT").size());
  const std::string bare = padded_number(after_mat.substr(std::min<std::size_t>(1, after_mat.size())));
  const ElasticFields* known = find_material(bare);
  Material material;
  material.id = card.integer(std::size_t{0});
  material.place = Context::place(block, card.line());
  material.keyword = "MAT_" + (known != nullptr ? std::string(known->name) : bare);
  if (known == nullptr && material.keyword.ends_with("_TITLE")) material.keyword.resize(material.keyword.size() - 6);
  if (material.id <= 0) {
    context.bad_id(material.place,
                   fmt::format("material id {} is not positive; the material is left out", material.id));
    return;
  }
  const keyword::Transform& units = context.transform(block);
  const double length = units.length_factor;
  const double stress = units.mass_factor / (length * units.time_factor * units.time_factor);
  const auto field = [&](std::size_t index) { return index == 0 ? 0.0 : card.real(index); };
  if (is_discrete(known))
    material.discrete = read_discrete_material(context, block, card, known->name);
  else
    material.density = card.real(1) * units.mass_factor / (length * length * length);
  if (known != nullptr && !is_discrete(known)) {
    material.young = field(known->young) * stress;
    material.poisson = field(known->poisson);
    material.bulk = field(known->bulk) * stress;
    if (material.bulk == 0) material.bulk = bulk_modulus(material.young, material.poisson);
    material.stiffness_known = known->young != 0 || known->bulk != 0;
    material.rigid = known->name == "RIGID";
    material.null_material = known->name == "NULL";
    material.spotweld = known->name == "SPOTWELD";
    if (material.spotweld) material.weld = read_spotweld(context, reader, card, bare);
    material.fabric = known->name.starts_with("FABRIC");
    if (material.rigid) {
      const Card limits = reader.next(keyword::card_layout("MAT_RIGID", "card2"));
      material.constraint = {limits.real("cmo"), constraint_code(limits.real("con1")),
                             constraint_code(limits.real("con2"))};
    }
    material.plasticity = read_plasticity(context, reader, card, known->name);
    material.discrete_beam = read_discrete_beam(context, reader, card, known->name);
    if (material.null_material) material.fluid = read_fluid(context, block, card);
    if (known->name == "ELASTIC_PLASTIC_HYDRO") material.hydro = read_hydro(context, reader, card, bare);
    if (known->name == "JOHNSON_COOK" || known->name == "SIMPLIFIED_JOHNSON_COOK")
      material.johnson_cook = read_johnson_cook(context, reader, card, known->name);
    if (known->name == "ORTHOTROPIC_ELASTIC" || known->name == "FABRIC")
      material.orthotropic = read_orthotropic(context, reader, card, material.fabric);
    read_foam_rubber(context, reader, card, known->name, bare, material);
    if (known->name == "MOONEY-RIVLIN_RUBBER") read_mooney_rivlin(context, reader, card, stress, material);
  }
  Model& model = context.model;
  const auto [entry, is_new] =
      context.material_of_id.try_emplace(material.id, static_cast<std::uint32_t>(model.materials.size()));
  if (is_new)
    model.materials.push_back(std::move(material));
  else
    context.duplicate("material", material.id, model.materials[entry->second].place, material.place);
}

}  // namespace gapcheck::model
