#include "solver/material/strain_rates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "solver/material/finite_law.hpp"

namespace gapcheck::solver::strain_rates_test {
namespace {

TEST(RateAverage, LastTwelveValues) {
  RateAverage average;
  EXPECT_EQ(average.mean(), 0);
  EXPECT_EQ(average.newest_share(), 0);
  average.add(5, 1, 12);
  EXPECT_EQ(average.mean(), 5);
  EXPECT_EQ(average.newest_share(), 1);
  average.add(8, 1, 12);
  EXPECT_EQ(average.mean(), 6.5);
  for (int i = 1; i <= 20; ++i) average.add(i, 1, 12);
  EXPECT_EQ(average.mean(), 14.5);  // of 9 to 20
  EXPECT_EQ(average.newest_share(), 1.0 / 12);
}

// Of a value that rises like the time t: t − T/2, however long the steps are; of steps of T/3 the last three.
TEST(RateAverage, Window) {
  constexpr double window = 1.2;
  for (const double step : {0.1, 0.013, 0.001}) {
    RateAverage average;
    double time = 0, worst = 0;
    for (int i = 0; time < 7; ++i) {
      const double dt = step * (1 + 0.5 * (i % 3 - 1));
      time += dt;
      average.add(time - dt / 2, dt, window);
      if (time > 2) worst = std::max(worst, std::abs(average.mean() - (time - window / 2)));
    }
    EXPECT_LT(worst, 1e-2) << step;
  }
  RateAverage coarse;
  for (const double value : {7.0, 1.0, 2.0, 9.0}) coarse.add(value, 0.5, 1.5);
  EXPECT_DOUBLE_EQ(coarse.mean(), 4);
  coarse.add(6, 4, 1.5);
  EXPECT_EQ(coarse.mean(), 6);
}

// The direction that stretches fastest says what the rate is and whether it counts.
TEST(RateLaws, PresentRate) {
  RateLaws laws;
  const Vector pressed(-0.2, 0.1, 0.1), pulled(0.2, -0.1, -0.1), rates(-3, 1.5, 1.5);
  EXPECT_EQ(laws.present(pressed, rates), 3);
  EXPECT_EQ(laws.present(pressed, -rates), 0);
  EXPECT_EQ(laws.present(pulled, rates), 0);
  EXPECT_EQ(laws.present(pulled, -rates), 0);
  laws.effects = RateEffects::loading;
  EXPECT_EQ(laws.present(pressed, rates), 3);
  EXPECT_EQ(laws.present(pressed, -rates), 0);
  EXPECT_EQ(laws.present(pulled, rates), 0);
  EXPECT_EQ(laws.present(pulled, -rates), 3);
  laws.effects = RateEffects::always;
  laws.engineering = true;
  EXPECT_EQ(laws.present(pressed, rates), 3 * std::exp(-0.2));
  EXPECT_EQ(laws.present(pressed, -rates), 3 * std::exp(-0.2));
  EXPECT_EQ(laws.present(pulled, rates), 3 * std::exp(0.2));
}

constexpr double slow_slope = 2, fast_slope = 5;

std::shared_ptr<const PrincipalLaw> line(double slope, double poisson) {
  const StretchFunction f = tabulated_stretch([=](double strain) { return slope * strain; }, poisson);
  if (poisson < 0.5) return std::make_shared<HillLaw>(f, poisson);
  return std::make_shared<OgdenLaw>(f, 1e3);
}

/// A specimen of lines with the slope 2 up to the rate 1, and 5 from the rate 4 on.
FiniteLaw law_of(double poisson, RateEffects effects, bool engineering = false) {
  RateLaws laws;
  laws.rates = {1, 4};
  laws.laws = {line(slow_slope, poisson), line(fast_slope, poisson)};
  laws.effects = effects;
  laws.engineering = engineering;
  FiniteLaw law;
  law.elastic = laws.laws[0];
  law.rates = std::make_shared<const RateLaws>(std::move(laws));
  return law;
}

/// Stretches along x with the lateral stretch λ^−ν.
struct Specimen {
  FiniteLaw law;
  double poisson = 0.5;
  FiniteHistory history = {};
  FinitePoint point = {};
  double stretch = 1, stress = 0, work = 0;  ///< nominal stress

  /// By steps of one true rate.
  void go(double to, double rate) {
    constexpr int steps = 2000;
    const double from = stretch, dt = std::abs(std::log(to / from)) / rate / steps;
    for (int i = 1; i <= steps; ++i) {
      const double before = stretch, before_stress = stress;
      stretch = from * std::pow(to / from, static_cast<double>(i) / steps);
      const double lateral = std::pow(stretch, -poisson), true_rate = to > from ? rate : -rate;
      const Matrix f = Vector(stretch, lateral, lateral).asDiagonal();
      const Matrix gradient = (true_rate * Vector(1, -poisson, -poisson)).asDiagonal();
      point = update_finite(law, f, gradient, dt, history);
      stress = (point.stress[xx] - point.stress[yy]) * lateral * lateral;
      work += (stretch - before) * (stress + before_stress) / 2;
    }
  }
};

double slope_at(double rate) { return slow_slope + (fast_slope - slow_slope) * std::clamp((rate - 1) / 3, 0.0, 1.0); }

// The nominal stress of each constant rate is that of the line between the table's lines, of foam and rubber.
TEST(RateLaws, ConstantRate) {
  for (const double poisson : {0.2, 0.5})
    for (const double to : {0.6, 1.4})
      for (const double rate : {0.5, 1.0, 2.5, 4.0, 9.0}) {
        Specimen one{law_of(poisson, RateEffects::loading), poisson};
        one.go(to, rate);
        EXPECT_NEAR(one.stress, slope_at(rate) * (to - 1), 1e-3) << poisson << ' ' << to << ' ' << rate;
        // Engineering rates at the end: λ times the true one.
        Specimen other{law_of(poisson, RateEffects::loading, true), poisson};
        other.go(to, rate);
        EXPECT_NEAR(other.stress, slope_at(rate * to) * (to - 1), 3e-3) << poisson << ' ' << to << ' ' << rate;
      }
}

// −1: fast loading, slow unloading, both in compression and tension; 0: compression alone; 1: the fast line always.
TEST(RateLaws, Unloading) {
  constexpr double rate = 3, fast = 4;  // slope at the rate
  const std::tuple<RateEffects, double, double> cases[] = {{RateEffects::compressive_loading, 0.6, 0.8},
                                                           {RateEffects::compressive_loading, 1.4, 1.2},
                                                           {RateEffects::loading, 0.6, 0.8},
                                                           {RateEffects::loading, 1.4, 1.2},
                                                           {RateEffects::always, 0.6, 0.8},
                                                           {RateEffects::always, 1.4, 1.2}};
  for (const auto& [effects, to, back] : cases) {
    const bool counts = to < 1 || effects != RateEffects::compressive_loading;
    Specimen one{law_of(0.5, effects)};
    one.go(to, rate);
    const double loaded = (counts ? fast : slow_slope) * (to - 1);
    EXPECT_NEAR(one.stress, loaded, 1e-3);
    // What the slow line does not store of the work is lost.
    EXPECT_NEAR(one.work, loaded * (to - 1) / 2, 2e-3);
    EXPECT_NEAR(one.history.lost, (loaded - slow_slope * (to - 1)) * (to - 1) / 2, 2e-3);
    one.go(back, rate);
    EXPECT_NEAR(one.stress, (effects == RateEffects::always ? fast : slow_slope) * (back - 1), 1e-3);
    EXPECT_NEAR(one.work - one.history.lost, slow_slope * (back - 1) * (back - 1) / 2, 2e-3);
  }
}

// No step of the rate changes the stress by more than the viscosity says.
TEST(RateLaws, Viscosity) {
  for (const bool engineering : {false, true})
    for (const double to : {0.6, 1.4}) {
      Specimen one{law_of(0.2, RateEffects::loading, engineering), 0.2};
      one.go(to, 2);
      const double lateral = std::pow(to, -0.2), change = 0.01 * (to > 1 ? 1 : -1), volume = to * lateral * lateral;
      const auto stress_after = [&](double more) {
        FiniteHistory history = one.history;
        const double rate = to > 1 ? 2 : -2;
        return update_finite(one.law, Matrix(Vector(to, lateral, lateral).asDiagonal()),
                             Matrix(Vector(rate + more, -0.2 * rate, -0.2 * rate).asDiagonal()), 1e-4, history)
            .stress;
      };
      const Symmetric with = stress_after(change), without = stress_after(0);
      double squares = 0;
      for (std::size_t i = 0; i < 3; ++i) squares += (with[i] - without[i]) * (with[i] - without[i]);
      const double measured = std::sqrt(squares) * volume / 0.01;
      EXPECT_GT(measured, 0.01);
      EXPECT_GE(one.point.viscosity, measured * (1 - 1e-6));
      EXPECT_LE(one.point.viscosity, 3 * measured);
      // Beyond the last rate the stress hangs on it no more.
      one.go(1, 9);
      one.go(to, 9);
      EXPECT_EQ(one.point.viscosity, 0);
    }
}

}  // namespace
}  // namespace gapcheck::solver::strain_rates_test
