#include "formulations/stepping/keepers.h"

#include <algorithm>
#include <iterator>

namespace desmo {

void Keepers::clear() {
  keepers_.clear();
  drivers_.clear();
}

void Keepers::add(Keeper& keeper, Level level) {
  keepers_.push_back({&keeper, level, drivers_.size()});
  std::ranges::copy(keeper.drivers(), std::back_inserter(drivers_));
}

void Keepers::begin_step(const StepHistory& history, const MotionRow& row) {
  for (const auto& [keeper, level, first_driver] : keepers_)
    keeper->begin_step(history.up_to(level), row.from(first_driver));
}

void Keepers::write_last(std::span<double> q) const {
  for (const Kept& kept : keepers_) kept.keeper->write_last(q);
}

void Keepers::write(State& state) const {
  for (const Kept& kept : keepers_) kept.keeper->write(state);
}

void Keepers::bind(const Request& request, const Model& model) {
  const std::vector<int> requested = requested_coordinates(request, model.coordinates());
  std::vector<int> places(model.state_size(), -1);
  for (std::size_t n = 0; n < requested.size(); ++n) places[requested[n]] = static_cast<int>(n);
  for (const Kept& kept : keepers_)  // what is filled to a lower level has drivers up to that only
    kept.keeper->prepare_outputs(places, kept.level == Level::acceleration);
  not_kept_.clear();
  std::ranges::copy_if(requested, std::back_inserter(not_kept_),
                       [&](int i) { return places[i] >= 0; });
  from_state_ = OutputWriter(places, requested.size());
}

void Keepers::deliver(Instant& instant, Level level) const {
  for (const Kept& kept : keepers_) kept.keeper->fill(instant.output, std::min(level, kept.level));
  from_state_.write(instant);
}

}  // namespace desmo
