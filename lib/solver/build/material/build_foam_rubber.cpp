#include "solver/build/material/build_foam_rubber.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gapcheck::solver {
namespace {

using Points = std::vector<std::array<double, 2>>;

constexpr double no_limit_from = 1e20;  ///< limits from here on are none

/// Sets the constants of one material after another; remembers what is wrong with the first.
class FoamRubberBuilder {
 public:
  FoamRubberBuilder(const model::Model& model, const model::Material& material, Material& result)
      : model_(model), material_(material), result_(result) {}

  void operator()(const std::monostate&) {}

  void operator()(const model::LowDensityFoam& data) {
    const Points* points = curve("LCID", data.curve);
    if (points == nullptr) return;
    if (!(material_.young > 0))
      return fail(fmt::format("E = {:g} is not above 0, which tension needs", material_.young));
    if (!(data.cutoff >= 0)) return fail(fmt::format("TC = {:g} is below 0", data.cutoff));
    if (!(data.contact >= 0)) return fail(fmt::format("KCON = {:g} is below 0", data.contact));
    if (!(data.relaxing >= 0) || !(data.relaxation_rate >= 0)) return fail("ED or BETA1 is below 0");
    const double steepest = model::largest_slope(*points);
    if (points->back()[0] <= 0 || !(steepest > 0))
      return fail(fmt::format("curve {} has no stress in compression; give strain and stress in compression above zero",
                              data.curve));
    FiniteLaw law;
    law.bulk_viscosity = data.bulk_viscosity == 1;
    law.wave = std::max(material_.young, data.contact > 0 ? data.contact : steepest);
    law.branch_modulus = data.relaxing;
    law.branch_decay = data.relaxation_rate;
    law.elastic = std::make_shared<LowDensityFoamLaw>(
        *points, material_.young, data.cutoff > 0 && data.cutoff < no_limit_from ? data.cutoff : no_limit_from,
        data.fail == 1);
    set_hysteresis(data.unloading, data.shape, data.decay, law);
    set_damping(data.damping, 0.05);
    finish(std::move(law));
  }

  void operator()(const model::BlatzKo& data) {
    if (!(data.shear > 0)) return fail(fmt::format("G = {:g} is not above 0", data.shear));
    constexpr double poisson = 0.463;
    FiniteLaw law;
    law.wave = material_.bulk + 4.0 / 3 * data.shear;
    law.elastic = std::make_shared<HillLaw>(StretchFunction::terms({{data.shear, 2}}), poisson);
    finish(std::move(law));
  }

  void operator()(const model::TabulatedRubber& data) {
    const model::SpecimenTest& test = data.test;
    FiniteLaw law;
    law.compressible = is_foam(data);
    const auto table = model_.tables.find(test.curve);
    if (table != model_.tables.end() && model_.curves.count(test.curve) == 0) {
      law.rates = rate_laws(table->second, data);
      if (law.rates) law.elastic = law.rates->laws.front();
    } else {
      law.elastic = tabulated_law("LC/TBID", test.curve, data);
    }
    if (!law.elastic) return;
    law.wave = data.bulk;
    if (law.compressible) law.wave = std::max(law.wave, law.elastic->shape(Vector::Zero(), false).slope(0, 0));
    set_hysteresis(data.unloading, data.shape, 0, law);
    set_damping(data.damping, 0.1);
    finish(std::move(law));
  }

  void operator()(const model::ConstantRubber& data) {
    if (!(material_.poisson > -1 && material_.poisson < 0.5))
      return fail(fmt::format("PR = {:g} is not below 0.5", material_.poisson));
    if (!(material_.bulk > 0)) return fail("its constants have no shear modulus above 0");
    FiniteLaw law;
    law.compressible = false;
    law.wave = material_.bulk;
    if (data.ogden) {
      std::vector<std::array<double, 2>> terms;
      for (std::size_t i = 0; i < data.mu.size(); ++i)
        if (data.mu[i] != 0) terms.push_back({data.mu[i], data.alpha[i]});
      law.elastic = std::make_shared<OgdenLaw>(StretchFunction::terms(std::move(terms)), material_.bulk);
    } else {
      law.elastic = std::make_shared<InvariantLaw>(data.c, material_.bulk);
    }
    finish(std::move(law));
  }

  void operator()(const model::CrushableFoam& data) {
    const Points* points = rising_curve("LCID", data.curve);
    if (points == nullptr) return;
    if (std::any_of(points->begin(), points->end(), [](const auto& point) { return point[0] < 0 || !(point[1] >= 0); }))
      return fail(fmt::format("curve {} has a strain or stress below 0", data.curve));
    if (!(data.cutoff >= 0)) return fail(fmt::format("TSC = {:g} is below 0", data.cutoff));
    CrushableFoam law;
    law.points = *points;
    law.cutoff = data.cutoff;
    if (const double last = model::last_slope(*points); last > 0) result_.young = last;
    result_.kind = MaterialKind::crushable;
    result_.crushable = std::make_shared<const CrushableFoam>(std::move(law));
    set_damping(data.damping, 0.1);
  }

  void operator()(const model::Viscoelastic& data) {
    if (!(data.bulk > 0) || !(data.shear > 0))
      return fail(fmt::format("BULK = {:g} and G0 = {:g} are not both above 0", data.bulk, data.shear));
    if (!(data.long_shear >= 0 && data.long_shear <= data.shear))
      return fail(fmt::format("GI = {:g} is not in 0 … G0 = {:g}", data.long_shear, data.shear));
    if (!(data.decay >= 0)) return fail(fmt::format("BETA = {:g} is below 0", data.decay));
    result_.kind = MaterialKind::viscoelastic;
    result_.viscoelastic = Viscoelastic{data.bulk, data.long_shear, data.shear - data.long_shear, data.decay};
  }

  SolverStatus status;

 private:
  static constexpr double least_of_rubber = 0.49;

  static bool is_foam(const model::TabulatedRubber& data) { return data.poisson > 0 && data.poisson < least_of_rubber; }

  /// The law of one test of 181; nothing after fail().
  std::shared_ptr<const PrincipalLaw> tabulated_law(std::string_view field, std::int64_t id,
                                                    const model::TabulatedRubber& data) {
    const auto refuse = [&](std::string_view why) {
      fail(why);
      return nullptr;
    };
    const Points* points = curve(field, id);
    if (points == nullptr) return nullptr;
    if (!(data.bulk > 0)) return refuse(fmt::format("KM = {:g} is not above 0", data.bulk));
    const model::SpecimenTest& test = data.test;
    if (!(test.length > 0 && test.width > 0 && test.thickness > 0))
      return refuse(
          fmt::format("SGL = {:g}, SW = {:g} and ST = {:g} are not all above 0; set 1 for a curve of stress over "
                      "strain",
                      test.length, test.width, test.thickness));
    if (points->front()[0] / test.length <= -1) return refuse("its curve presses the specimen to nothing");
    const double area = test.width * test.thickness;
    Points stresses;
    for (const auto& point : *points) stresses.push_back({point[0] / test.length, point[1] / area});
    const auto nominal = [&](double strain) { return on_curve(stresses, strain); };
    if (!(model::largest_slope(stresses) > 0)) return refuse("its curve has no stiffness");
    const StretchFunction f = tabulated_stretch(nominal, is_foam(data) ? data.poisson : 0.5);
    if (is_foam(data)) return std::make_shared<HillLaw>(f, data.poisson);
    return std::make_shared<OgdenLaw>(f, data.bulk);
  }

  /// The laws of a table of 181 over the strain rate; nothing after fail().
  std::shared_ptr<const RateLaws> rate_laws(const model::Table& table, const model::TabulatedRubber& data) {
    const auto refuse = [&](std::string_view why) {
      fail(why);
      return nullptr;
    };
    constexpr std::size_t most_rates = 100;
    const std::int64_t id = data.test.curve;
    if (table.rows.empty() || table.rows.size() > most_rates)
      return refuse(fmt::format("table {} has {} strain rates; give 1 to {}", id, table.rows.size(), most_rates));
    if (data.unloading > 0 && data.unloading < 1 && data.tension == 1)
      return refuse(fmt::format("HU = {:g} unloads by hysteresis, TENSION = 1 by the curves of table {}; keep one",
                                data.unloading, id));
    RateLaws result;
    result.effects = data.tension == 0   ? RateEffects::compressive_loading
                     : data.tension == 1 ? RateEffects::always
                                         : RateEffects::loading;
    result.engineering = data.rate_type == 1;
    result.window = -data.averaging;
    for (const model::Table::Row& row : table.rows) {
      if (!(row.value >= 0 && std::isfinite(row.value)) ||
          (!result.rates.empty() && !(row.value > result.rates.back())))
        return refuse(
            fmt::format("the strain rate {:g} of table {} is below 0 or not above the one before it", row.value, id));
      auto law = tabulated_law(fmt::format("the curve of {:g} in table {}", row.value, id), row.curve, data);
      if (!law) return nullptr;
      result.rates.push_back(row.value);
      result.laws.push_back(std::move(law));
    }
    return std::make_shared<const RateLaws>(std::move(result));
  }

  void fail(std::string_view why) {
    status = Failure{Failure::Kind::bad_material,
                     fmt::format("material {} (*{}): {}", material_.id, material_.keyword, why), material_.place};
  }

  /// Linear between the points, with the end slopes beyond them.
  static double on_curve(const Points& points, double at) {
    const auto above = std::upper_bound(points.begin() + 1, points.end() - 1, at,
                                        [](double a, const std::array<double, 2>& point) { return a < point[0]; });
    const auto& [a0, o0] = *(above - 1);
    const auto& [a1, o1] = *above;
    return o0 + (o1 - o0) * (at - a0) / (a1 - a0);
  }

  /// A curve with two or more points and abscissas that rise.
  const Points* rising_curve(std::string_view field, std::int64_t id) {
    const auto found = model_.curves.find(id);
    if (found == model_.curves.end()) {
      fail(model_.tables.count(id) > 0
               ? fmt::format("{} = {} is a table, which is not calculated; name a curve", field, id)
               : fmt::format("{} = {} is no curve that is there", field, id));
      return nullptr;
    }
    const Points& points = found->second.points;
    const auto falls = [](const auto& a, const auto& b) { return !(a[0] < b[0]); };
    const auto bad = [](const auto& point) { return !std::isfinite(point[0]) || !std::isfinite(point[1]); };
    if (points.size() >= 2 && std::adjacent_find(points.begin(), points.end(), falls) == points.end() &&
        std::none_of(points.begin(), points.end(), bad))
      return &points;
    fail(fmt::format("curve {} must have two points or more, with strains that rise", id));
    return nullptr;
  }

  /// The same; it passes through the origin.
  const Points* curve(std::string_view field, std::int64_t id) {
    const Points* points = rising_curve(field, id);
    if (points == nullptr) return nullptr;
    double largest = 0;
    for (const auto& point : *points) largest = std::max(largest, std::abs(point[1]));
    constexpr double negligible = 1e-9;
    if (points->front()[0] <= 0 && points->back()[0] >= 0 && std::abs(on_curve(*points, 0)) <= negligible * largest)
      return points;
    fail(fmt::format("curve {} has a stress at zero strain, or does not reach it; give it the point 0, 0", id));
    return nullptr;
  }

  void set_hysteresis(double unloading, double shape, double decay, FiniteLaw& law) {
    if (!(unloading >= 0 && unloading <= 1)) return fail(fmt::format("HU = {:g} is not in 0 … 1", unloading));
    if (!(shape >= 0)) return fail(fmt::format("SHAPE = {:g} is below 0", shape));
    if (!(decay >= 0)) return fail(fmt::format("BETA = {:g} is below 0", decay));
    law.unloading = unloading == 0 ? 1 : unloading;
    law.shape = shape == 0 ? 1 : shape;
    law.healing = decay;
  }

  void set_damping(double damping, double usual) {
    if (damping < 0) return fail(fmt::format("the damping {:g} is a curve, which is not calculated", damping));
    if (!(damping <= 10)) return fail(fmt::format("the damping {:g} is above 10; 0.05 to 0.5 is usual", damping));
    result_.damping = damping == 0 ? usual : damping;
  }

  void finish(FiniteLaw law) {
    result_.kind = MaterialKind::rubber;
    result_.finite = std::make_shared<const FiniteLaw>(std::move(law));
  }

  const model::Model& model_;
  const model::Material& material_;
  Material& result_;
};

}  // namespace

SolverStatus set_foam_rubber(const model::Model& model, const model::Material& material, Material& result) {
  if (const std::string why = foam_rubber_not_calculated(model, material); !why.empty())
    return Failure{Failure::Kind::not_calculated,
                   fmt::format("material {} (*{}): {}", material.id, material.keyword, why), material.place};
  FoamRubberBuilder builder(model, material, result);
  std::visit(builder, material.foam_rubber);
  return builder.status;
}

std::string foam_rubber_not_calculated(const model::Model& model, const model::Material& material) {
  const auto given = [](std::string_view field, double value) {
    return fmt::format("{} = {:g} is not calculated; set 0", field, value);
  };
  if (const auto* foam = std::get_if<model::LowDensityFoam>(&material.foam_rubber)) {
    if (foam->reference != 0) return given("REF", foam->reference);
    if (foam->fail != 0 && foam->fail != 1) return given("FAIL", foam->fail);
  }
  if (const auto* rubber = std::get_if<model::BlatzKo>(&material.foam_rubber); rubber && rubber->reference != 0)
    return given("REF", rubber->reference);
  if (const auto* foam = std::get_if<model::CrushableFoam>(&material.foam_rubber); foam && foam->model != 0)
    return given("MODEL", foam->model);
  if (const auto* rubber = std::get_if<model::TabulatedRubber>(&material.foam_rubber)) {
    if (!rubber->unread.empty()) return rubber->unread + " is not calculated";
    if (rubber->unloading_curve != 0) return "LCUNLD is not calculated; give HU instead";
    if (rubber->test.curve != 0 && model.tables.count(rubber->test.curve) > 0) {
      if (std::abs(rubber->tension) != 1 && rubber->tension != 0) return given("TENSION", rubber->tension);
      if (rubber->rate_type != 0 && rubber->rate_type != 1) return given("RTYPE", rubber->rate_type);
      if (!(rubber->averaging <= 0) || std::isinf(rubber->averaging))
        return fmt::format("AVGOPT = {:g} is not calculated; set 0, or minus the time to average over",
                           rubber->averaging);
    }
    if (rubber->poisson < 0 || rubber->poisson >= 0.5)
      return fmt::format("PR = {:g}: the viscosity BETA is not calculated", rubber->poisson);
  }
  if (const auto* rubber = std::get_if<model::ConstantRubber>(&material.foam_rubber))
    if (!rubber->unread.empty()) return rubber->unread + " is not calculated";
  return "";
}

}  // namespace gapcheck::solver
