#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"
#include "audit/shared/length_unit.hpp"
#include "contact/definition/exclusions.hpp"
#include "contact/definition/friction.hpp"
#include "contact/surface/surface_parts.hpp"

namespace gapcheck::audit::rule::uniform_friction {
namespace {

/// Materials that slide in different ways, each recognised beyond doubt.
enum class Kind : std::uint8_t { metal, rubber, foam, fabric };
constexpr std::array<std::string_view, 4> kind_names{"metal", "rubber", "foam", "fabric"};

std::optional<Kind> kind_of(const model::Model& model, PartIndex index) {
  const model::Part& part = model.part(index);
  if (!part.material) return std::nullopt;
  const model::Material& material = model.materials[*part.material];
  const std::string& keyword = material.keyword;
  const auto named = [&](std::string_view word) { return keyword.find(word) != std::string::npos; };
  if (material.null_material || material.spotweld) return std::nullopt;
  if (material.fabric) return Kind::fabric;
  if (named("RUBBER")) return Kind::rubber;
  if (named("FOAM") && !named("SOIL")) return Kind::foam;
  if (known_metal(material)) return Kind::metal;
  return std::nullopt;
}

/// Parts of one side by kind.
using ByKind = std::array<std::vector<PartIndex>, kind_names.size()>;

ByKind by_kind(const model::Model& model, const contact::ContactSide& side) {
  ByKind parts;
  for (const PartIndex part : contact::parts_of(model, side))
    if (const auto kind = kind_of(model, part)) parts[static_cast<std::size_t>(*kind)].push_back(part);
  return parts;
}

struct KindPair {
  std::size_t first = 0, second = 0;  ///< ascending
  PartIndex a, b;                     ///< parts of these kinds that may meet
};

/// Two different parts of the lists that may meet.
std::optional<std::pair<PartIndex, PartIndex>> meeting(const Context& context, const contact::Exclusions& exclusions,
                                                       const std::vector<PartIndex>& first,
                                                       const std::vector<PartIndex>& second) {
  for (const PartIndex a : first)
    for (const PartIndex b : second)
      if (a != b && !exclusions.excluded(a, b) && (context.part_chosen(a) || context.part_chosen(b)))
        return std::pair(a, b);
  return std::nullopt;
}

/// The pairs of kinds between which a contact acts.
std::vector<KindPair> kind_pairs(Context& context, ContactIndex i) {
  const model::Model& model = context.model();
  const contact::ContactSurfaces& surfaces = context.surfaces(i);
  const ByKind a = by_kind(model, surfaces.a), b = surfaces.two_sided() ? by_kind(model, surfaces.b) : a;
  const contact::Exclusions exclusions(model, model.contact(i).id);
  std::vector<KindPair> pairs;
  for (std::size_t first = 0; first < a.size(); ++first)
    for (std::size_t second = first; second < a.size(); ++second) {
      auto parts = meeting(context, exclusions, a[first], b[second]);
      if (!parts && first != second && surfaces.two_sided()) {
        parts = meeting(context, exclusions, a[second], b[first]);
        if (parts) std::swap(parts->first, parts->second);
      }
      if (parts) pairs.push_back({first, second, parts->first, parts->second});
    }
  return pairs;
}

/// One value for all. Without friction only global contacts: in a local one somebody decided it.
bool one_value(const model::Contact& contact, const contact::ContactType& type) {
  if (contact.fs < 0 || !contact::has_friction(contact) || contact.kind == nullptr || contact.kind->ties())
    return false;
  if (!contact::takes_friction_table(contact)) return false;
  const bool frictionless = contact.fs == 0 && contact.fd == 0;
  return !frictionless || type.treatment == contact::Treatment::single_surface;
}

std::string pair_text(const model::Model& model, const KindPair& pair) {
  return fmt::format("{} on {} (parts {} and {})", kind_names[pair.first], kind_names[pair.second],
                     model.part(pair.a).id.value, model.part(pair.b).id.value);
}

Finding words(const RuleIdentity& rule, const Context& context, const model::Contact& contact,
              const std::vector<KindPair>& pairs) {
  const model::Model& model = context.model();
  std::string text;
  for (const KindPair& pair : pairs) text += (text.empty() ? "" : ", ") + pair_text(model, pair);
  const std::string by_part = contact::takes_part_friction(contact) ? ", or by parts: FS = -1 and *PART_CONTACT" : "";
  Finding f =
      finding_at(rule, context, contact,
                 fmt::format("FS = {:g}, FD = {:g} for all pairs of parts, among them {}; where friction matters, "
                             "give it by pairs: FS = -2 and *DEFINE_FRICTION{}",
                             contact.fs, contact.fd, text, by_part));
  f.part = model.part(pairs.front().a).id.value;
  f.element_part = model.part(pairs.front().b).id.value;
  f.count = pairs.size();
  return f;
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  std::vector<Finding> found;
  for (const ContactIndex i : context.read_contacts()) {
    const model::Contact& contact = context.model().contact(i);
    if (!one_value(contact, contact::classify(contact))) continue;
    const std::vector<KindPair> pairs = kind_pairs(context, i);
    if (pairs.size() > 1) found.push_back(words(rule, context, contact, pairs));
  }
  add_first(report, std::move(found), "more contacts have one friction for different materials");
}

}  // namespace

const Rule definition{
    {"GC426", "uniform-friction", Severity::note, "one value of friction for metal, rubber, foam or fabric together",
     Need::surfaces, "Friction is the same where it cannot be"},
    run};

}  // namespace gapcheck::audit::rule::uniform_friction
