// Many positions at once: the range of every coordinate over 3001 positions of a crank, several of
// them in the lanes of wide registers, and on two threads.
#include <desmo/cases.h>
#include <desmo/formulation.h>
#include <desmo/model.h>
#include <desmo/observer.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace {

/// The smallest and the largest value of each coordinate, whatever the order of the instants.
class Range final : public desmo::Observer {
 public:
  explicit Range(int coordinates) : low(coordinates, INFINITY), high(coordinates, -INFINITY) {}
  desmo::Flow observe(const desmo::Instant& instant) noexcept override {
    for (std::size_t i = 0; i < low.size(); ++i) {
      low[i] = std::min(low[i], instant.q[i]);
      high[i] = std::max(high[i], instant.q[i]);
    }
    return desmo::Flow::go_on;
  }
  bool any_order() const noexcept override { return true; }
  void restart() noexcept override {
    std::ranges::fill(low, INFINITY);
    std::ranges::fill(high, -INFINITY);
  }

  std::vector<double> low, high;
};

}  // namespace

int main() {
  const desmo::Scene scene = desmo::four_bar(20);
  const desmo::Model model = desmo::make_model(scene);  // shared by all of the formulations
  const desmo::TimeGrid grid = desmo::time_grid(30, 0.01);
  const desmo::Request positions{desmo::Level::position, {}};
  Range one_by_one(model.coordinates());
  const auto& variant = desmo::find_variant("group_symbolic_explicit");
  if (!desmo::make_formulation(variant, model)->run(grid, positions, one_by_one).ok()) return 1;
  for (const char* suffix : {"/lanes:4", "/segments:4", "/threads:2"}) {
    const std::string id = variant.id + suffix;
    const auto [of_table, settings] = desmo::parse_id(id);
    if (!desmo::unavailable_reason(settings).empty()) continue;  // on this machine
    Range range(model.coordinates());
    const desmo::Summary summary =
        desmo::make_formulation(*of_table, model, settings)->run(grid, positions, range);
    double difference = 0;
    for (int i = 0; i < model.coordinates(); ++i)
      difference = std::max({difference, std::abs(range.low[i] - one_by_one.low[i]),
                             std::abs(range.high[i] - one_by_one.high[i])});
    std::printf("%s: %s, as one by one to %.1e\n", id.c_str(),
                desmo::describe(summary, model).c_str(), difference);
    if (!summary.ok() || summary.instants != grid.instants || !(difference < 1e-9)) return 1;
  }
  return 0;
}
