#include "bench/experiments/accuracy/tuning_validation.h"

#include <algorithm>
#include <array>
#include <list>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/kit/process/progress.h"
#include "bench/kit/record/record.h"
#include "cases/generators/cases.h"
#include "cases/io/files.h"
#include "formulations/modelling/modelling.h"

namespace desmo::accuracy {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<double, 5> budgets{1e-3, 1e-5, 1e-7, 1e-9, 1e-11};
constexpr std::array<const char*, 3> library{"slider_crank", "rssr", "stewart"};

constexpr double as_fast = 1.3;  // what a single sample may be off
constexpr std::size_t max_compared = 24;
constexpr int rounds = 7;
constexpr double promise_sample = 5e-3;  // s

/// Returns the fastest within the error on the begin of the motion, fastest first, as far as they
/// may yet be the best on all of it.
std::vector<std::string> fastest(const std::vector<Tried>& all, double allowed) {
  std::vector<std::string> found;
  double best = 0;
  for (const Tried& t : all) {  // fastest first
    if (!(t.error <= allowed / safety)) continue;
    if (found.empty()) best = t.seconds;
    if (found.size() == max_compared || t.seconds > as_fast * best) break;
    found.push_back(t.id);
  }
  return found;
}

Measured measured(const Trial& trial) {
  return {trial.id(), trial.error.position.max, trial.seconds};
}

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

Json measured_json(const Measured& m) {
  return {{"id", m.id}, {"error", m.error}, {"time_per_step", bench::time_json(m.seconds)}};
}

void add_promises(Json& list, const Named& named, bench::Progress& progress) {
  const Plan plan = make_plan(make_model(named.scene), {});
  const TimeGrid& grid = named.scene.grid;
  const TunedMotion motion = make_tuned_motion(plan, grid);
  const Problem control = bench::make_problem(plan, grid, grid.instants);
  const std::vector<Tried> all = everything(motion);
  progress.done();
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
                    {"choice", measured_json(p.choice)},
                    {"best", measured_json(p.best)}});
    progress.done();
  }
}

}  // namespace

std::vector<Tried> everything(const TunedMotion& motion) {
  const TunedMotion begin{motion.begin, motion.begin};
  return search(begin, {Level::position, 1, 0}, {.exhaustive = true, .rounds = 1}).tried;
}

Promise promise(const TunedMotion& motion, const Problem& control, const std::vector<Tried>& all,
                double allowed, const Effort& effort) {
  const Found found = search(motion, {Level::position, allowed, 0}, effort);
  if (!found.choice) throw std::runtime_error("nothing holds the error");
  std::list<Trial> trials;
  Trial& choice = trials.emplace_back(control, *found.choice);
  choice.compare();
  if (!choice.is_verified()) throw std::runtime_error(choice.id() + ": " + choice.message);
  for (const std::string& id : fastest(all, allowed)) {
    if (id == choice.id()) continue;
    Trial& trial = trials.emplace_back(control, parse_id(id));
    trial.compare();
    if (!trial.is_verified() || trial.error.position.max > allowed / safety) trials.pop_back();
  }
  for (int round = 0; round < rounds; ++round)
    for (Trial& t : trials) t.time(promise_sample);
  return {allowed, found.error.position.max, measured(choice),
          measured(*std::ranges::min_element(trials, {}, &Trial::min_seconds))};
}

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
