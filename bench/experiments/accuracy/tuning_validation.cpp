#include "bench/experiments/accuracy/tuning_validation.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/experiments/accuracy/promise.h"
#include "bench/experiments/accuracy/record.h"
#include "bench/kit/process/progress.h"
#include "bench/kit/record/recording.h"
#include "bench/kit/record/time_json.h"
#include "cases/generators/cases.h"
#include "cases/io/files.h"
#include "formulations/modelling/modelling.h"

namespace desmo::accuracy {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<double, 5> budgets{1e-3, 1e-5, 1e-7, 1e-9, 1e-11};
constexpr std::array<const char*, 3> library{"slider_crank", "rssr", "stewart"};

struct Named {
  std::string name;
  Scene scene;
};

/// Returns the scenes of all mechanisms, or of those named. Throws std::invalid_argument, naming
/// one that is not among them.
std::vector<Named> scenes(const std::vector<std::string>& named) {
  std::vector<Named> all;
  for (const Case& c : cases()) all.push_back({std::string(c.name), describe(c, c.sizes.front())});
  for (const char* name : library) all.push_back({name, library_scene(name)});
  for (const std::string& name : named)
    if (!std::ranges::count(all, name, &Named::name))
      throw std::invalid_argument("--mechanism: '" + name + "' is none of those tried");
  if (!named.empty())
    std::erase_if(all, [&](const Named& n) { return !std::ranges::count(named, n.name); });
  return all;
}

Json rival_json(const Rival& rival) {
  return {
      {"id", rival.id}, {"error", rival.error}, {"time_per_step", bench::time_json(rival.seconds)}};
}

void add_promises(Json& list, const Named& named, bench::Progress& progress) {
  const Plan plan = make_plan(make_model(named.scene), {});
  const TimeGrid& grid = named.scene.grid;
  const TunedMotion motion = make_tuned_motion(plan, grid);
  const Problem control = make_problem(plan, grid, grid.instants);
  const std::vector<Tried> all = everything(motion);
  progress.one_done();
  for (const double allowed : budgets) {
    const Promise p = promise(motion, control, all, allowed);
    list.push_back({{"mechanism", named.name},
                    {"coordinates", plan.model.coordinates()},
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

}  // namespace

void validate_tuning(const std::string& record, const std::string& command,
                     const std::vector<std::string>& mechanisms) {
  const std::vector<Named> all = scenes(mechanisms);
  bench::Recording recording(record, command);
  Json lists = {{"tuning", Json::array()}};
  {
    bench::Progress progress("searches", static_cast<int>(all.size() * (1 + budgets.size())));
    for (const Named& named : all) add_promises(lists["tuning"], named, progress);
  }
  recording.write(all.front().scene.grid, lists);
}

}  // namespace desmo::accuracy
