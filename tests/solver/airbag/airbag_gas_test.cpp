#include "solver/airbag/airbag_gas.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gapcheck::solver::airbag_gas_test {
namespace {

AirbagGas air() {
  AirbagGas gas;
  gas.heat_volume = 700;
  gas.heat_pressure = 980;  // ratio 1.4
  gas.ambient_pressure = 1e5;
  gas.ambient_density = 1.2;
  return gas;
}

TEST(AirbagGas, BeginsAsTheAmbientGas) {
  const AirbagGas gas = air();
  const GasContent content = GasContent::start(gas, 0.05);
  EXPECT_NEAR(content.mass, 0.06, 1e-15);
  EXPECT_NEAR(gas.pressure(content.energy, 0.05), 1e5, 1e-9);
  // p = rho (CP - CV) T
  EXPECT_NEAR(content.energy / (content.mass * 700), 1e5 / (1.2 * 280), 1e-9);
}

// p V^k stays, over any number of steps, there and back.
TEST(AirbagGas, CompressionWithoutFlow) {
  const AirbagGas gas = air();
  for (const int steps : {1, 10}) {
    GasContent content = GasContent::start(gas, 1);
    double volume = 1;
    for (const double end : {0.4, 1.7, 1.0}) {
      const double from = volume;
      for (int i = 1; i <= steps; ++i) {
        const double now = from + (end - from) * i / steps;
        content.advance(gas, volume, now, 0, 0.01);
        volume = now;
      }
      EXPECT_NEAR(gas.pressure(content.energy, volume) * std::pow(volume, 1.4), 1e5, 1e-7);
      EXPECT_EQ(content.mass, 1.2);
    }
  }
}

// Gas that flows in brings its enthalpy: a rigid volume without an exit keeps all of it.
TEST(AirbagGas, InflowIntoARigidVolume) {
  AirbagGas gas = air();
  gas.inflow_temperature = 600;
  gas.inflow = std::make_shared<const TimeCurve>(std::vector<TimeCurve::Point>{{0, 0}, {0.5, 4}, {1, 0}});
  gas.inflow_scale = 0.1;
  GasContent content = GasContent::start(gas, 2);
  for (int i = 1; i <= 7; ++i) {
    content.advance(gas, 2, 2, i / 7.0, 1 / 7.0);
    EXPECT_GT(content.rate_in, 0);
  }
  const double in = 0.1 * 2;  // half of 1 x 4
  EXPECT_NEAR(content.mass, 2.4 + in, 1e-13);
  EXPECT_NEAR(content.energy, 1e5 * 2 / 0.4 + 980 * 600 * in, 1e-6);
}

/// The rate by the speed and density in the exit.
double exit_twin(const AirbagGas& gas, double pressure, double density) {
  const double k = 1.4, outside = std::max(gas.ambient_pressure, pressure * std::pow(2 / (k + 1), k / (k - 1)));
  const double temperature = pressure / (density * (gas.heat_pressure - gas.heat_volume));
  const double cold = temperature * std::pow(outside / pressure, (k - 1) / k);
  return density * std::pow(outside / pressure, 1 / k) * std::sqrt(2 * gas.heat_pressure * (temperature - cold));
}

TEST(AirbagGas, ExitRate) {
  AirbagGas gas = air();
  gas.shape.constant = 0.7;
  gas.area.constant = 0.01;
  for (const double pressure : {1.0001e5, 1.2e5, 1.8e5, 1.9e5, 5e5})
    EXPECT_NEAR(gas.exit_rate(pressure, 2), 0.007 * exit_twin(gas, pressure, 2), 1e-9) << pressure;
  // Sonic: the density and speed of sound at the critical temperature 2 T / (k + 1).
  const double critical = 2 / 2.4, sound = std::sqrt(1.4 * 280 * critical * 5e5 / (2 * 280));
  EXPECT_NEAR(gas.exit_rate(5e5, 2), 0.007 * 2 * std::pow(critical, 2.5) * sound, 1e-9);
  EXPECT_EQ(gas.exit_rate(1e5, 2), 0);
  EXPECT_EQ(gas.exit_rate(0.5e5, 2), 0);
}

TEST(AirbagGas, ExitByCurves) {
  AirbagGas gas = air();
  gas.shape.curve.points = {{1e5, 0}, {2e5, 1}};
  gas.area = {0, {}, 1, 2};
  gas.area.curve.points = {{0, 0.01}, {2e5, 0.03}};
  EXPECT_NEAR(gas.exit_rate(1.5e5, 2), 0.5 * 2 * 0.025 * exit_twin(gas, 1.5e5, 2), 1e-9);
  AirbagGas drained = air();
  drained.exit_flow = {0, {}, 1e5, 3};
  drained.exit_flow.curve.points = {{0, 0}, {1, 0.5}};
  EXPECT_NEAR(drained.exit_rate(1.4e5, 2), 3 * 0.2, 1e-12);  // over the pressure above the ambient one
}

// A vessel that blows into the vacuum is always choked: closed form.
TEST(AirbagGas, BlowdownIntoVacuum) {
  AirbagGas gas = air();
  const double volume = 0.5;
  GasContent content{2, 2 * 700 * 400, 0, 0};
  gas.ambient_pressure = gas.ambient_density = 0;
  gas.shape.constant = 0.8;
  gas.area.constant = 0.002;
  const double start = gas.pressure(content.energy, volume);
  const double sound = std::sqrt(1.4 * 280 * 400), constant = 0.0016 / volume * sound * std::pow(2 / 2.4, 3);
  const int steps = 20000;
  for (int i = 1; i <= steps; ++i) {
    content.advance(gas, volume, volume, i * 1e-4, 1e-4);
    if (i % 5000 == 0) {
      const double fall = 1 + 0.2 * constant * i * 1e-4;
      EXPECT_NEAR(gas.pressure(content.energy, volume) / start, std::pow(fall, -7), 2e-4);
      EXPECT_NEAR(content.mass / 2, std::pow(fall, -5), 2e-4);
    }
  }
  EXPECT_LT(content.mass, 1.2);
}

// Steps far too long do not take more than there is, nor suck air out below the ambient pressure.
TEST(AirbagGas, LongSteps) {
  AirbagGas gas = air();
  gas.shape.constant = gas.area.constant = 1e3;
  GasContent content = GasContent::start(gas, 1);
  content.advance(gas, 1, 0.5, 1, 1);
  EXPECT_NEAR(gas.pressure(content.energy, 0.5), 1e5, 1e-6);
  EXPECT_NEAR(content.rate_out, 1.2 - content.mass, 1e-12);
  AirbagGas drained = air();
  drained.exit_flow = {1e6, {}, 1, 1};
  content = GasContent::start(drained, 1);
  content.advance(drained, 1, 1, 1, 1);
  EXPECT_GE(content.mass, 0);
  EXPECT_GE(content.energy, 0);
  EXPECT_TRUE(std::isfinite(content.rate_out));
}

}  // namespace
}  // namespace gapcheck::solver::airbag_gas_test
