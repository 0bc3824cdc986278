#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "audit/judge.hpp"

namespace gapcheck::audit_test {

inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// The files of a run, made by hand; its log and contacts; what one rule says of it.
struct JudgedRun {
  results::RunResults files;
  SolverRun log;
  std::vector<ContactSummary> contacts;
  std::vector<std::int64_t> only;  ///< --contact
  std::vector<std::string> skips;  ///< what could not be judged

  JudgedRun() { files.directory = "out"; }

  /// A state of glstat.
  results::GlobalState& global(double time) {
    files.glstat.emplace_back().time = time;
    return files.glstat.back();
  }
  /// glstat with an internal energy that rises to `internal` at time 10; total energy the same.
  void internal(double internal) {
    for (const double time : {0.0, 5.0, 10.0}) {
      auto& state = global(time);
      state.internal = state.total = internal * time / 10;
    }
  }
  /// A state of sleout with one contact.
  void sleout(double time, std::int64_t contact, double side_a, double side_b, double friction) {
    results::InterfaceState state;
    state.contact = contact;
    state.energy = {side_a, side_b};
    state.friction = friction;
    add(files.sleout, time, state);
  }
  /// A state of rcforc with one contact.
  void rcforc(double time, std::int64_t contact, const Vector& side_a, const Vector& side_b) {
    results::InterfaceState state;
    state.contact = contact;
    state.force = {side_a, side_b};
    add(files.rcforc, time, state);
  }
  void part(double time, std::int64_t id, double internal, double hourglass) {
    auto& states = files.matsum.states;
    if (states.empty() || states.back().time != time) states.push_back({time, {}});
    results::PartState part;
    part.part = id;
    part.internal = internal;
    part.hourglass = hourglass;
    states.back().parts.push_back(part);
  }

  std::vector<Finding> findings(const std::string& rule) {
    Report report;
    report.source = "messag";
    report.files = {"out/messag"};
    report.run = log;
    report.contacts = contacts;
    skips = audit::judge_run(files, {{rule}, {}, only}, report);
    for (const Finding& f : report.findings) EXPECT_EQ(f.id, rule);
    return report.findings;
  }
  /// Expects one finding.
  Finding finding(const std::string& rule) {
    const std::vector<Finding> list = findings(rule);
    EXPECT_EQ(list.size(), 1u);
    return list.empty() ? Finding{} : list.front();
  }

 private:
  static void add(results::InterfaceHistory& history, double time, const results::InterfaceState& state) {
    if (history.states.empty() || history.states.back().time != time) history.states.push_back({time, 0, {}});
    history.states.back().contacts.push_back(state);
  }
};

inline bool says(const Finding& f, const std::string& words) { return f.message.find(words) != std::string::npos; }

}  // namespace gapcheck::audit_test
