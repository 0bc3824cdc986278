#include "model/assumption.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>
#include <optional>

#include "base/number.hpp"

namespace gapcheck::model {
namespace {

enum class Values : std::uint8_t { amount, number, whole };

struct Field {
  std::string_view name;
  Values values;
  void (*set)(Model& model, double value);
};

template <class Change>
void each_contact(Model& model, const Change& change) {
  for (Contact& contact : model.contacts) change(contact);
}

/// A thickness of all contacts that keep surfaces apart.
template <double Contact::*Field>
void set_thickness(Model& model, double value) {
  each_contact(model, [&](Contact& c) {
    if (c.kind == nullptr || !c.kind->ties()) c.*Field = value;
  });
}

template <double Contact::*Field>
void set_real(Model& model, double value) {
  each_contact(model, [&](Contact& c) { c.*Field = value; });
}

template <std::int64_t Contact::*Field>
void set_whole(Model& model, double value) {
  each_contact(model, [&](Contact& c) { c.*Field = static_cast<std::int64_t>(value); });
}

/// Zero takes the value away from the parts that have one.
template <double PartContact::*Field>
void set_part(Model& model, double value) {
  for (Part& part : model.parts) {
    if (!part.contact && value == 0) continue;
    if (!part.contact) part.contact.emplace();
    (*part.contact).*Field = value;
  }
}

void set_ignore(Model& model, double value) {
  const auto ignore = static_cast<std::int64_t>(value);
  model.controls.ignore = ignore;
  each_contact(model, [&](Contact& c) {
    c.ignore = ignore;
    c.mpp_ignore.reset();
  });
}

constexpr std::array fields{
    Field{"SFS", Values::amount, set_real<&Contact::sfs>},
    Field{"SFM", Values::amount, set_real<&Contact::sfm>},
    Field{"SST", Values::number, set_thickness<&Contact::sst>},
    Field{"MST", Values::number, set_thickness<&Contact::mst>},
    Field{"SFST", Values::amount, set_thickness<&Contact::sfst>},
    Field{"SFMT", Values::amount, set_thickness<&Contact::sfmt>},
    Field{"SOFT", Values::whole, set_whole<&Contact::soft>},
    Field{"SOFSCL", Values::amount, set_real<&Contact::sofscl>},
    Field{"PENMAX", Values::amount, set_real<&Contact::penmax>},
    Field{"SNLOG", Values::whole, set_whole<&Contact::snlog>},
    Field{"SLDTHK", Values::amount, set_thickness<&Contact::sldthk>},
    Field{"IGNORE", Values::whole, set_ignore},
    Field{"OPTT", Values::amount, set_part<&PartContact::optt>},
    Field{"SFT", Values::amount, set_part<&PartContact::sft>},
    Field{"SSTHK", Values::whole,
          [](Model& model, double value) { model.controls.ssthk = static_cast<std::int64_t>(value); }},
    Field{"TH", Values::amount, [](Model& model, double value) { model.controls.th = value; }},
    Field{"TH_SF", Values::amount, [](Model& model, double value) { model.controls.th_sf = value; }},
};

const Field* find_field(std::string_view name) {
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const Field& field) { return field.name == name; });
  return found == fields.end() ? nullptr : &*found;
}

/// Why the field cannot have the value; empty if it can.
std::string_view objection(const Field& field, double value) {
  constexpr double largest_option = 1e6;
  if (field.values == Values::amount && value < 0) return "is negative";
  if (field.values == Values::whole && (value != std::floor(value) || std::abs(value) > largest_option))
    return "is not a whole number";
  return {};
}

}  // namespace

std::vector<std::string_view> assumable_fields() {
  std::vector<std::string_view> names;
  names.reserve(std::size(fields));
  for (const Field& field : fields) names.push_back(field.name);
  return names;
}

Result<Assumption> read_assumption(std::string_view text) {
  const std::size_t equals = text.find('=');
  Assumption assumption;
  assumption.field = std::string(trimmed(text.substr(0, equals)));
  std::transform(assumption.field.begin(), assumption.field.end(), assumption.field.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  const std::string_view written = equals == std::string_view::npos ? std::string_view() : text.substr(equals + 1);
  const Field* field = find_field(assumption.field);
  if (equals == std::string_view::npos || field == nullptr)
    return plain_error(
        fmt::format("'{}' is not FIELD=VALUE with one of the fields {}", text, fmt::join(assumable_fields(), ", ")));
  const std::optional<double> value = parse_real(written);
  if (!value) return plain_error(fmt::format("'{}' is not a number for {}", written, assumption.field));
  if (const std::string_view wrong = objection(*field, *value); !wrong.empty())
    return plain_error(fmt::format("the value {} of {} {}", trimmed(written), assumption.field, wrong));
  assumption.value = *value;
  return assumption;
}

void assume(std::span<const Assumption> assumptions, Model& model) {
  for (const Assumption& assumption : assumptions)
    if (const Field* field = find_field(assumption.field)) field->set(model, assumption.value);
}

}  // namespace gapcheck::model
