// Decks by other authors: their conditions are read and put on the structure.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "solver/conditioned.hpp"
#include "solver/supported.hpp"

namespace gapcheck::solver::real_decks_test {
namespace {

namespace fs = std::filesystem;

class RealConditions : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(decks)) GTEST_SKIP() << "the real decks are not beside the project: " << decks;
  }
  const fs::path decks = fs::path(GAPCHECK_ROOT) / ".." / "shared" / "decks";

  Conditioned read(const std::string& name, std::vector<Unsupported>& left_out) {
    Diagnostics diagnostics;
    const auto deck = keyword::read_deck((decks / name).string(), {}, diagnostics);
    EXPECT_TRUE(deck.ok()) << name;
    Conditioned result;
    if (!deck.ok()) return result;
    const auto model = model::read_model(deck.value(), diagnostics);
    left_out = unsupported(deck.value(), model.value());
    auto built = build_structure(model.value(), {}, diagnostics);
    if (!built) {
      result.status = built.error();
      return result;
    }
    result.structure = std::move(built).value();
    result.status = apply_conditions(model.value(), result.structure, result.forces, diagnostics);
    return result;
  }
};

TEST_F(RealConditions, TwoBodies) {
  std::vector<Unsupported> left_out;
  const Conditioned result = read("two_body_impact/main.k", left_out);
  ASSERT_TRUE(result.status.ok()) << result.status.error().message;
  EXPECT_TRUE(left_out.empty()) << left_out[0].keyword << ": " << left_out[0].why;
  std::size_t held = 0, moving = 0;
  for (std::size_t i = 0; i < result.structure.state.x.size(); ++i) {
    held += result.structure.constraints.mask(i) == 63;
    moving += result.structure.state.v[i] == Vector(0, 0, -500);
  }
  EXPECT_EQ(held, 11u * 11u);          // the plate, 10 x 10 shells
  EXPECT_EQ(moving, 11u * 11u * 11u);  // the box, which is full of bricks
  EXPECT_EQ(held + moving, result.structure.state.x.size());
}

// All nodes of the rigid ball have the same velocity: so has the ball.
TEST_F(RealConditions, BallOnPlate) {
  std::vector<Unsupported> left_out;
  const Conditioned result = read("ball_plate/ball_plate.k", left_out);
  ASSERT_TRUE(result.status.ok()) << result.status.error().message;
  EXPECT_TRUE(left_out.empty()) << left_out[0].keyword << ": " << left_out[0].why;
  ASSERT_EQ(result.structure.rigid.size(), 1u);
  EXPECT_NEAR((result.structure.rigid[0].velocity() - Vector(0, 0, -10)).norm(), 0, 1e-12);
  EXPECT_NEAR(result.structure.rigid[0].angular_velocity().norm(), 0, 1e-12);
}

TEST_F(RealConditions, Car) {
  std::vector<Unsupported> left_out;
  const Conditioned result = read("car6/car6_crash.k", left_out);
  ASSERT_TRUE(result.status.ok()) << result.status.error().message;
  for (const Unsupported& one : left_out) ADD_FAILURE() << one.keyword << " in line " << one.line << ": " << one.why;
  std::size_t moving = 0;
  for (const Vector& velocity : result.structure.state.v) moving += std::abs(velocity.x() + 1.564e4) < 1e-6;
  EXPECT_EQ(moving, 758u);  // as many rows has the deck
}

}  // namespace
}  // namespace gapcheck::solver::real_decks_test
