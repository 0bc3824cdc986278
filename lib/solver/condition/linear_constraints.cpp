#include "solver/condition/linear_constraints.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "base/union_find.hpp"

namespace gapcheck::solver {

std::uint32_t LinearConstraints::position(const Freedom& freedom) {
  freedoms_.push_back(freedom);
  return static_cast<std::uint32_t>(freedoms_.size() - 1);
}

void LinearConstraints::join(const std::vector<Freedom>& freedoms, double end) {
  Joined joined{{}, end};
  for (const Freedom& freedom : freedoms) joined.members.push_back(position(freedom));
  joined_.push_back(std::move(joined));
}

void LinearConstraints::add_equation(const std::vector<Term>& terms) {
  std::vector<Entry>& row = groups_.emplace_back().rows.emplace_back();
  for (const Term& term : terms) row.push_back({position(term.at), term.factor});
}

/// Gives each degree of freedom one position, and puts equations together that share one, or a joined one.
void LinearConstraints::finish() {
  std::vector<Freedom> each = freedoms_;
  std::sort(each.begin(), each.end());
  each.erase(std::unique(each.begin(), each.end()), each.end());
  const auto place = [&](std::uint32_t before) {
    return static_cast<std::uint32_t>(std::lower_bound(each.begin(), each.end(), freedoms_[before]) - each.begin());
  };
  joined_of_.assign(each.size(), no_position);
  UnionFind together(each.size());
  for (std::uint32_t j = 0; j < joined_.size(); ++j)
    for (std::uint32_t& member : joined_[j].members) {
      member = place(member);
      joined_of_[member] = j;
      together.unite(joined_[j].members[0], member);
    }
  for (Group& group : groups_)
    for (Entry& entry : group.rows[0]) {
      entry.freedom = place(entry.freedom);
      together.unite(group.rows[0][0].freedom, entry.freedom);
    }
  std::map<std::uint32_t, std::vector<std::vector<Entry>>> merged;
  for (Group& group : groups_) {
    std::map<std::uint32_t, double> sum;  // a degree of freedom may be named twice
    for (const Entry& entry : group.rows[0]) sum[entry.freedom] += entry.factor;
    std::vector<Entry> row;
    for (const auto& [freedom, factor] : sum) row.push_back({freedom, factor});
    merged[together.root(group.rows[0][0].freedom)].push_back(std::move(row));
  }
  groups_ = std::vector<Group>(merged.size());
  std::size_t next = 0;
  for (auto& [root, rows] : merged) groups_[next++].rows = std::move(rows);
  freedoms_ = std::move(each);
  mass_.assign(freedoms_.size(), 0);
  velocity_.assign(freedoms_.size(), 0);
  acts_.assign(joined_.size(), true);
}

std::size_t LinearConstraints::largest_group() const {
  std::size_t most = 0;
  for (const Group& group : groups_) most = std::max(most, group.rows.size());
  return most;
}

namespace {

/// Mass, or rotational inertia.
double mass_of(const State& state, const LinearConstraints::Freedom& at) {
  return (at.freedom < 3 ? state.mass : state.inertia)[at.node];
}

double& linear_component(std::vector<Vector>& translations, std::vector<Vector>& rotations,
                         const LinearConstraints::Freedom& at) {
  return (at.freedom < 3 ? translations : rotations)[at.node][at.freedom % 3];
}

double linear_component(const std::vector<Vector>& translations, const std::vector<Vector>& rotations,
                        const LinearConstraints::Freedom& at) {
  return (at.freedom < 3 ? translations : rotations)[at.node][at.freedom % 3];
}

}  // namespace

/// Joined degrees of freedom count as one of their whole mass.
void LinearConstraints::factorise(Group& group) const {
  std::vector<double> masses;
  std::map<std::pair<bool, std::uint32_t>, std::map<std::size_t, double>> columns;
  for (std::size_t row = 0; row < group.rows.size(); ++row)
    for (const Entry& entry : group.rows[row]) {
      const std::uint32_t j = joined_of_[entry.freedom];
      const bool acts = j != no_position && acts_[j];
      columns[{acts, acts ? j : entry.freedom}][row] += entry.factor;
    }
  for (const auto& [which, entries] : columns) {
    double mass = which.first ? 0 : mass_[which.second];
    if (which.first)
      for (const std::uint32_t member : joined_[which.second].members) mass += mass_[member];
    masses.push_back(mass);
  }
  if (masses == group.masses) return;
  group.masses = masses;
  const auto size = static_cast<Eigen::Index>(group.rows.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
  std::size_t column = 0;
  for (const auto& [which, entries] : columns) {
    for (const auto& [a, first] : entries)
      for (const auto& [b, second] : entries)
        matrix(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) += first * second / masses[column];
    ++column;
  }
  group.solver.compute(matrix);
}

void LinearConstraints::project(Group& group) {
  factorise(group);
  Eigen::VectorXd gap = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(group.rows.size()));
  for (std::size_t row = 0; row < group.rows.size(); ++row)
    for (const Entry& entry : group.rows[row])
      gap[static_cast<Eigen::Index>(row)] += entry.factor * velocity_[entry.freedom];
  const Eigen::VectorXd load = group.solver.solve(gap);
  for (std::size_t row = 0; row < group.rows.size(); ++row)
    for (const Entry& entry : group.rows[row]) {
      const double impulse = entry.factor * load[static_cast<Eigen::Index>(row)];
      const std::uint32_t j = joined_of_[entry.freedom];
      if (j == no_position || !acts_[j]) {
        velocity_[entry.freedom] -= impulse / mass_[entry.freedom];
        continue;
      }
      double mass = 0;
      for (const std::uint32_t member : joined_[j].members) mass += mass_[member];
      for (const std::uint32_t member : joined_[j].members) velocity_[member] -= impulse / mass;
    }
}

void LinearConstraints::project(double time) {
  for (std::size_t j = 0; j < joined_.size(); ++j) {
    acts_[j] = time < joined_[j].end;
    if (!acts_[j]) continue;
    double mass = 0, momentum = 0;
    for (const std::uint32_t member : joined_[j].members) {
      mass += mass_[member];
      momentum += mass_[member] * velocity_[member];
    }
    for (const std::uint32_t member : joined_[j].members) velocity_[member] = momentum / mass;
  }
  for (Group& group : groups_) project(group);
}

void LinearConstraints::add(State& state, Forces& /*forces*/) {
  for (std::size_t i = 0; i < freedoms_.size(); ++i) mass_[i] = mass_of(state, freedoms_[i]);
  if (state.cycle > 0) return;
  for (std::size_t i = 0; i < freedoms_.size(); ++i) velocity_[i] = linear_component(state.v, state.w, freedoms_[i]);
  project(state.time);
  for (std::size_t i = 0; i < freedoms_.size(); ++i) linear_component(state.v, state.w, freedoms_[i]) = velocity_[i];
}

void LinearConstraints::react(const State& state, double mean, double /*next*/, Forces& net, Forces& external) {
  std::vector<double> free(freedoms_.size());
  for (std::size_t i = 0; i < freedoms_.size(); ++i) {
    const Freedom& at = freedoms_[i];
    free[i] = linear_component(state.v, state.w, at) + mean * linear_component(net.force, net.moment, at) / mass_[i];
  }
  velocity_ = free;
  project(state.time);
  for (std::size_t i = 0; i < freedoms_.size(); ++i) {
    const double reaction = mass_[i] * (velocity_[i] - free[i]) / mean;
    linear_component(net.force, net.moment, freedoms_[i]) += reaction;
    linear_component(external.force, external.moment, freedoms_[i]) += reaction;
  }
}

}  // namespace gapcheck::solver
