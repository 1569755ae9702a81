#include "formulations/verification/reference/drift.h"

#include <algorithm>
#include <vector>

namespace desmo {

namespace {

class Ends final : public Observer {
 public:
  Ends(const Model& m, const Reference& reference, std::size_t window)
      : first_(m, std::span(reference.instants).first(window), reference.scales),
        last_(m, std::span(reference.instants).subspan(window), reference.scales) {}

  Flow observe(const Instant& instant) noexcept override {
    first_.observe(instant);
    return last_.observe(instant);
  }
  SolutionError first() const { return first_.error(); }
  SolutionError last() const { return last_.error(); }

 private:
  ErrorMeasure first_, last_;
};

}  // namespace

Drift measure_drift(Formulation& formulation, const TimeGrid& grid, int window) {
  window = std::min(window, grid.instants / 2);
  std::vector<double> times;
  for (int i = 0; i < window; ++i) times.push_back(grid.time(i));
  for (int i = grid.instants - window; i < grid.instants; ++i) times.push_back(grid.time(i));
  const Reference reference = make_reference(formulation.model(), times);
  Ends ends(formulation.model(), reference, window);
  const Summary summary = formulation.run(grid, {}, ends);
  return {summary, ends.first(), ends.last(), reference.floor};
}

}  // namespace desmo
