// desmo range: how far each driver can go from the start of a scene.
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>

#include "bench/cli/commands.h"
#include "bench/cli/errors.h"
#include "bench/cli/input.h"
#include "bench/cli/output.h"
#include "bench/cli/solve/run_notes.h"
#include "bench/cli/text.h"
#include "cases/mechanism/names.h"
#include "formulations/variants.h"
#include "formulations/verification/range/driver_range.h"

namespace desmo::cli {
namespace {

using Json = nlohmann::ordered_json;

struct RangeOptions {
  std::string scene;
  bool json = false;
};

/// What is known of an input's drivers.
struct Ranges {
  const Mechanism& mechanism;
  const Model& model;
  double time;  ///< [s]
  std::vector<DriverRange> drivers;
};

constexpr const char* stop_names[] = {"dead_point", "full_turn",   "zero_length", "other_branch",
                                      "start",      "not_reached", "none"};

/// Returns the position at the start. At a dead point, where it cannot be assembled, the estimate
/// may be near enough.
std::vector<double> start_of(const Model& m, double time) {
  const auto formulation = make_formulation(find_variant("block_automatic_klu"), m);
  const Summary s = formulation->assemble(time, Level::position);
  if (s.ok()) return {formulation->q().begin(), formulation->q().end()};
  std::vector<double> q = m.estimate;
  for (const Driver& d : m.drivers)
    q[m.entities[d.coordinate].first] = sample(d.motion, time).position;
  return q;
}

std::vector<std::string> names_of(const std::vector<EntityId>& entities, const Model& m) {
  std::vector<std::string> names;
  for (const EntityId e : entities) names.push_back(m.entities[e].name);
  return names;
}

/// Names of the joints at points or vectors that can still move.
std::vector<std::string> joints_of(const RangeEnd& e, const Ranges& r) {
  const std::vector<std::string> moving = names_of(e.moving, r.model);
  const auto moves = [&](const std::string& name) {
    return std::ranges::find(moving, name) != moving.end();
  };
  std::vector<std::string> joints;
  for (const Mechanism::Joint& j : r.mechanism.joints)
    if (std::ranges::any_of(j.points, [&](int p) { return moves(r.mechanism.points[p].name); }))
      joints.push_back(j.name);
  return joints;
}

std::vector<std::string> constraints_of(const RangeEnd& e, const Model& m) {
  std::vector<std::string> names;
  for (const int c : e.constraints) names.push_back(m.constraints[c].name);
  return names;
}

std::string number(double value, const char* format = "%.12g") {
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

void range(const RangeOptions& options) {
  const Input input = load_scene(options.scene);
  const Model m = model_mechanism(input).model;
  const double time = input.scene.grid.time(0);
  Ranges ranges{input.scene.mechanism, m, time, {}};
  const std::vector<double> q = start_of(m, time);
  for (int d = 0; d < m.degrees_of_freedom(); ++d) ranges.drivers.push_back(find_range(m, q, d));
  for (int d = 0; d < m.degrees_of_freedom(); ++d) {
    const DriverRange& r = ranges.drivers[d];
    std::printf("%s start %.12g idle %d\n", m.entities[m.drivers[d].coordinate].name.c_str(), r.start, r.is_idle);
    auto show = [&](const char* n, const RangeEnd& e) {
      std::printf("  %s %s %.15g beyond %.3g turns %d group %s moving %s joints %s constraints %s\n", n, stop_names[(int)e.stop], e.value, e.beyond - e.value, e.turns, e.group < 0 ? "-" : m.groups[e.group].name.c_str(), enumerate(names_of(e.moving, m)).c_str(), enumerate(joints_of(e, ranges)).c_str(), enumerate(constraints_of(e, m), 12).c_str());
    };
    show("down", r.down);
    show("up", r.up);
    if (r.other_branch) show("other", *r.other_branch);
    for (const ChangePoint& c : r.change_points) std::printf("  change %.15g %d\n", c.value, c.group);
  }
}

}  // namespace

void add_range(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "range", "How far each driver can go from the start, the others at rest");
  const auto options = std::make_shared<RangeOptions>();
  command
      ->add_option("scene", options->scene,
                   "Scene file, - for standard input, library mechanism (its scene), or scalable "
                   "case with its units, such as truck_suspension:5")
      ->required();
  command->add_flag("--json", options->json, "As JSON");
  command->callback([options] { range(*options); });
}

}  // namespace desmo::cli
