#include "formulations/runtime/motion_samples.h"

#include <algorithm>

#include "formulations/codegen/record/recording.h"
#include "formulations/variants.h"

namespace desmo::load {

namespace {

using generate::sample_count;

constexpr int max_steps = 400;
constexpr double tolerance = 1e-6;  // of what only sizes are looked at

class Sampler final : public Observer {
 public:
  Sampler(const Model& model, int instants) : m_(model), instants_(instants) {}

  Flow observe(const Instant& instant) noexcept override {
    const int samples = static_cast<int>(states.size());
    if (instant.index < (instants_ - 1) * samples / (sample_count - 1)) return Flow::go_on;
    std::vector<double>& state = states.emplace_back(instant.q.begin(), instant.q.end());
    state.insert(state.end(), m_.fixed_values.begin(), m_.fixed_values.end());
    return Flow::go_on;
  }

  std::vector<std::vector<double>> states;

 private:
  const Model& m_;
  int instants_;
};

}  // namespace

TimeGrid with_few_steps(TimeGrid grid) {
  if (grid.instants - 1 > max_steps) {
    grid.step = (grid.instants - 1) * grid.step / max_steps;
    grid.instants = max_steps + 1;
  }
  return grid;
}

std::vector<std::vector<double>> sample_motion(const Model& m, const TimeGrid& grid) {
  const TimeGrid coarse = with_few_steps(grid);
  Sampler sampler(m, coarse.instants);
  const auto f = make_formulation(find_variant("group_automatic_klu"), m, {.tolerance = tolerance});
  static_cast<void>(f->run(coarse, Request{Level::position}, sampler));  // as far as it goes
  return std::move(sampler.states);
}

}  // namespace desmo::load
