// desmo range: how far each driver can go from the start of a scene.
#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "bench/cli/commands.h"
#include "bench/cli/errors.h"
#include "bench/cli/input.h"
#include "bench/cli/range/ranges.h"
#include "bench/cli/solve/check_notes.h"
#include "bench/cli/solve/failure_notes.h"
#include "bench/cli/text.h"
#include "bench/kit/delivery.h"
#include "cases/io/new_files.h"
#include "cases/mechanism/names.h"
#include "formulations/variants.h"
#include "formulations/verification/branch/departure.h"
#include "formulations/verification/run/checked_run.h"

namespace desmo::cli {
namespace {

struct RangeOptions {
  std::string scene;
  UnitSystem units = UnitSystem::file;
  bool json = false;
};

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

std::vector<std::string> joints_at(const std::vector<std::string>& moving,
                                   const Mechanism& mechanism) {
  std::vector<std::string> joints;
  for (const Mechanism::Joint& j : mechanism.joints)
    if (std::ranges::any_of(j.points,
                            [&](int p) { return contains(moving, mechanism.points[p].name); }))
      joints.push_back(j.name);
  return joints;
}

/// Returns the bodies that carry all points and vectors of at least one of the constraints.
std::vector<std::string> bodies_of(const std::vector<int>& constraints, const Model& m,
                                   const Mechanism& mechanism) {
  const auto carries_all = [&](const Mechanism::Body& body, const Constraint& c) {
    std::vector<std::string> names;
    for (const int p : body.points) names.push_back(mechanism.points[p].name);
    for (const int v : body.vectors) names.push_back(mechanism.vectors[v].name);
    return std::ranges::all_of(c.operands, [&](EntityId e) {
      return m.entities[e].size == 1 || contains(names, m.entities[e].name);
    });
  };
  std::vector<std::string> bodies;
  for (auto body = mechanism.bodies.begin() + 1; body < mechanism.bodies.end(); ++body)
    if (std::ranges::any_of(constraints,
                            [&](int c) { return carries_all(*body, m.constraints[c]); }))
      bodies.push_back(body->name);
  return bodies;
}

NamedEnd with_names(const RangeEnd& end, const char* direction, const Model& m,
                    const Mechanism& mechanism) {
  return {end, direction, joints_at(names_at(m.entities, end.moving), mechanism),
          bodies_of(end.constraints, m, mechanism)};
}

/// The position at the start, and what is proven of it. Where no position can be assembled, as at a
/// dead point, q is the model's estimate, which may be near enough. In either case drivers have
/// their values at the start.
struct Start {
  CheckedSummary summary;
  std::vector<double> q;
};

Start start_at(const Model& m, double time, double tolerance) {
  const auto formulation =
      make_formulation(find_variant("block_automatic_klu"), m, Settings{.tolerance = tolerance});
  bench::Delivery found(m.coordinates(), Level::position);
  Start start{run_checked(*formulation, {time, 1, 1}, Request{Level::position}, found), m.estimate};
  if (start.summary.outcome() != Outcome::failed) std::ranges::copy(found.q(), start.q.begin());
  const std::vector<double> drivers = exact_drivers_at(m, time);
  for (std::size_t i = 0; i < drivers.size(); ++i)
    start.q[m.entities[m.drivers[i].coordinate].first] = drivers[i];
  return start;
}

void range(const RangeOptions& options) {
  const Input input = load_scene(options.scene, options.units);
  const Mechanism& mechanism = input.scene.mechanism;
  const Model m = model_mechanism(input).model;
  Ranges ranges{m, input.scene.grid.time(0), {}};
  const Start start = start_at(m, ranges.time, input.scene.tolerance);
  std::fputs(note_on_flags(start.summary, m, input.units).c_str(), stderr);
  for (int i = 0; i < m.degrees_of_freedom(); ++i) {
    const Entity& driven = m.entities[m.drivers[i].coordinate];
    NamedRange& named = ranges.drivers.emplace_back();
    named.driver = driven.name;
    named.is_angle = driven.kind == EntityKind::angle;
    named.unit = unit_of(input.units, driven.kind);
    try {
      named.range = find_range(m, start.q, i);
    } catch (const std::runtime_error& error) {
      throw CommandError(
          not_solved,
          input.source + ": " + error.what() +
              (start.summary.outcome() != Outcome::failed ? ""
                                                          : ": " + describe(start.summary, m)) +
              start_text(m, input.units, exact_drivers_at(m, ranges.time)) +
              "; choose a start that can be assembled");
    }
    const DriverRange& r = named.range;
    named.ends = {with_names(r.down, "down", m, mechanism), with_names(r.up, "up", m, mechanism)};
    if (r.other_branch)
      named.ends.push_back(with_names(
          *r.other_branch, r.other_branch->value < r.start ? "down" : "up", m, mechanism));
  }
  write_standard_output(options.json ? to_json(ranges) : to_text(ranges));
}

}  // namespace

void add_range(CLI::App& program) {
  const auto [command, options] =
      add_command(program, "range",
                  "How far each driver can go from a scene's start, the others at rest", range);
  add_scene(command, options.scene);
  add_units(command, options.units);
  command.add_flag("--json", options.json, "As JSON, with all digits and constraints by name");
  command.footer(
      "Examples:\n"
      "  desmo range stewart\n"
      "  desmo range mine.scene.json --json --units si");
}

}  // namespace desmo::cli
