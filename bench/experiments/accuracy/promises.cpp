// desmo_promises: what the choices of desmo tune are worth. Is the error that was asked for held at
// every instant of the motion? How much slower is the choice than the best there is?
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/experiments/accuracy/promise.h"
#include "bench/experiments/accuracy/record.h"
#include "bench/kit/kept_memory.h"
#include "bench/kit/progress.h"
#include "bench/kit/recording.h"
#include "bench/kit/time_json.h"
#include "cases/cases.h"
#include "cases/files.h"
#include "formulations/algebra/blas.h"
#include "formulations/modelling/model.h"

namespace desmo::precision {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<double, 5> budgets{1e-3, 1e-5, 1e-7, 1e-9, 1e-11};
constexpr std::array<const char*, 3> library{"slider_crank", "rssr", "stewart"};

struct Named {
  std::string name;
  Scene scene;
};

/// All there are, or those named, at least one. Throws std::invalid_argument where there is none.
std::vector<Named> scenes(const std::vector<std::string>& named) {
  std::vector<Named> all;
  for (const Case& c : cases()) all.push_back({std::string(c.name), describe(c, c.sizes.front())});
  for (const char* name : library) all.push_back({name, library_scene(name)});
  if (!named.empty())
    std::erase_if(all, [&](const Named& n) { return !std::ranges::count(named, n.name); });
  if (all.empty()) throw std::invalid_argument("there is no such mechanism among those tried");
  return all;
}

Json rival_json(const Rival& rival) {
  return {
      {"id", rival.id}, {"error", rival.error}, {"time_per_step", suite::time_json(rival.seconds)}};
}

void add_promises(Json& list, const Named& named, suite::Progress& progress) {
  const Plan plan = make_plan(make_mechanism(named.scene), {});
  const TimeGrid& grid = named.scene.grid;
  const TunedMotion motion = make_tuned_motion(plan, grid);
  const Problem control = make_problem(plan, grid, grid.instants);
  const std::vector<Tried> all = everything(motion);
  progress.one_done();
  for (const double allowed : budgets) {
    const Promise p = promise(motion, control, all, allowed);
    list.push_back({{"mechanism", named.name},
                    {"coordinates", plan.mechanism.coordinates()},
                    {"step_seconds", grid.step},
                    {"instants", grid.instants},
                    {"allowed", p.allowed},
                    {"promised", p.promised},
                    {"compared", control.reference.instants.size()},
                    {"tried", all.size()},
                    {"choice", rival_json(p.choice)},
                    {"best", rival_json(p.best)}});
    progress.one_done();
  }
}

void run(const std::string& record, const std::string& command, const std::vector<Named>& all) {
  suite::keep_freed_memory();
  set_blas_threads(1);  // the clock is the thread's own
  suite::Recording recording(record, command);
  Json lists = {{"tuning", Json::array()}};
  {
    suite::Progress progress("searches", static_cast<int>(all.size() * (1 + budgets.size())));
    for (const Named& named : all) add_promises(lists["tuning"], named, progress);
  }
  recording.write(all.front().scene.grid, lists);
}

}  // namespace

}  // namespace desmo::precision

int main(int argc, char** argv) {
  CLI::App program{"What the choices of desmo tune are worth", "desmo_promises"};
  std::string record;
  program.add_option("--record", record, "Write the results record to this file")->required();
  std::vector<std::string> mechanisms;
  program.add_option("--mechanism", mechanisms, "Only these, not all");
  const std::string command = desmo::suite::command_line(argc, argv);
  return desmo::suite::record_main(program, argc, argv, [&] {
    desmo::precision::run(record, command, desmo::precision::scenes(mechanisms));
    return true;
  });
}
