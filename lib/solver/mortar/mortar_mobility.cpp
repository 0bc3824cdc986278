#include "solver/mortar/mortar_mobility.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/quad.hpp"

namespace gapcheck::solver {
namespace {

using BodyVector = Eigen::Matrix<double, 6, 1>;
using FreedomMatrix = Eigen::Matrix<double, 6, 6>;

/// The body that moves all corners of a face; no_position: none does.
std::uint32_t body_of(const MortarFace& face, const State& state) {
  const auto at = [&](NodeIndex node) { return node.value < state.body.size() ? state.body[node.value] : no_position; };
  const std::uint32_t body = at(face.nodes[0]);
  const bool all = std::all_of(face.nodes.begin(), face.nodes.end(), [&](NodeIndex n) { return at(n) == body; });
  return all && body < state.bodies.size() ? body : no_position;
}

}  // namespace

double body_mobility(const BodyState& body, const std::vector<std::array<Vector, 4>>& faces) {
  const Eigen::SelfAdjointEigenSolver<Matrix> turns((body.turn_response + body.turn_response.transpose()) / 2);
  const Matrix turn = turns.eigenvectors() * turns.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal() *
                      turns.eigenvectors().transpose();
  const Vector push = body.push_response.cwiseMax(0).cwiseSqrt();
  FreedomMatrix sum = FreedomMatrix::Zero();
  constexpr double place = 0.57735026918962576;  // Gauss
  for (const std::array<Vector, 4>& face : faces) {
    const Vector doubled = quad_normal(face);
    const double area = doubled.norm() / 2;
    if (!(area > 0) || !std::isfinite(area)) continue;
    const Vector normal = doubled / (2 * area);
    for (const double s : {-place, place})
      for (const double t : {-place, place}) {
        BodyVector g;
        g << push.cwiseProduct(normal), turn * (quad_point(face, s, t) - body.center).cross(normal);
        sum += area / 4 * g * g.transpose();
      }
  }
  const Eigen::SelfAdjointEigenSolver<FreedomMatrix> solved(sum, Eigen::EigenvaluesOnly);
  return std::max(0.0, solved.eigenvalues().maxCoeff());
}

bool MortarMobility::follow(const State& state) {
  const bool same = std::equal(imposed_.begin(), imposed_.end(), state.bodies.begin(), state.bodies.end(),
                               [](unsigned imposed, const BodyState& body) { return imposed == body.imposed; });
  if (measured_ && same) return false;
  measured_ = true;
  imposed_.clear();
  for (const BodyState& body : state.bodies) imposed_.push_back(body.imposed);
  mobility_.assign(surface_.size(), 0);
  body_.assign(surface_.size(), no_position);
  std::map<std::uint32_t, std::vector<std::array<Vector, 4>>> faces;
  for (std::uint32_t i = 0; i < surface_.size(); ++i) {
    const MortarFace& face = surface_[i];
    mobility_[i] = face.mass > 0 ? 1 / face.mass : std::numeric_limits<double>::infinity();
    body_[i] = body_of(face, state);
    if (body_[i] != no_position) faces[body_[i]].push_back(MortarSurface::corners(face, state.x));
  }
  std::map<std::uint32_t, double> of_body;
  for (const auto& [body, corners] : faces) of_body[body] = body_mobility(state.bodies[body], corners);
  for (std::uint32_t i = 0; i < surface_.size(); ++i)
    if (body_[i] != no_position) mobility_[i] = of_body[body_[i]];
  return true;
}

}  // namespace gapcheck::solver
