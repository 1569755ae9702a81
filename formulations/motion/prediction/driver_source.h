#pragma once

#include <span>
#include <vector>

#include "cases/mechanism/motion.h"
#include "formulations/base/lane_values.h"
#include "formulations/base/live_row.h"
#include "formulations/base/state.h"
#include "formulations/model/model.h"
#include "formulations/motion/prediction/motions_ahead.h"

namespace desmo {

/// Writes the position, velocity and acceleration that the motions of all drivers have at time t
/// [s] to the state.
void write_drivers(const Model& model, double t, State& state);

/// A source of the driver values z, ż and z̈ of a model, at one time after the other. It puts them
/// in one row, and writes them from there to the state. It samples the motions of the model, known
/// in advance, or takes values that are handed in for one step.
class DriverSource {
 public:
  /// in_row: driven coordinates that some parts read in the row. The row begins with these, in this
  /// order, as often as they are named. The model outlives the source.
  explicit DriverSource(const Model& model, std::span<const int> in_row = {});

  /// Announces the grid whose times follow, in order from the first. Other times are possible,
  /// one by one.
  void expect(const TimeGrid& grid) { motions_.expect(grid); }

  /// Takes values in place of the motions until hand_back(). At other times than the row's own,
  /// drivers move linearly to the row's positions. start, from: time [s] and positions of the last
  /// instant, where that motion begins.
  void hand_in(const LiveRow& row, double start, const State& from);
  /// Goes back to the motions.
  void hand_back() { is_live_ = false; }
  bool is_live() const { return is_live_; }

  /// Samples all drivers at time t [s] and writes to the state those that are read there.
  const MotionRow& sample(double t, State& state) {
    row_ = is_live_ ? live_row(t) : motions_(t);
    write(written_, state);
    return row_;
  }

  /// Writes all drivers to the state as they were sampled last, if they were.
  void write_all(State& state) const;

  /// Sets which drivers sample() writes into the state: those that some part reads there, and those
  /// that nobody takes from the row. read: for each position in the state, whether a part or an
  /// observer reads it there.
  void set_observed(const std::vector<bool>& read);

 private:
  struct Driven {
    int coordinate, place;  // position in the state, place in the row
  };
  /// The source of a place in a row that is handed in.
  struct HandedIn {
    int driver, coordinate;  // positions in Model::drivers and in the state
  };
  MotionRow live_row(double t);
  void write(std::span<const Driven> drivers, State& state) const {
    for (const auto& [coordinate, place] : drivers) {
      state.q[coordinate] = row_.z[place];
      state.qd[coordinate] = row_.zd[place];
      state.qdd[coordinate] = row_.zdd[place];
    }
  }

  // for each position in the state, whether a part takes it from the row
  std::vector<bool> in_row_;
  std::vector<Driven> drivers_;
  std::vector<Driven> written_;  // drivers that sample() writes to the state
  MotionsAhead motions_;
  MotionRow row_{};
  std::vector<HandedIn> handed_in_;   // source of each place in the row
  LaneState live_, between_;          // the row handed in; the row between start_ and its time
  LaneValues from_;                   // positions at start_, by place in the row
  double live_time_ = 0, start_ = 0;  // times of live_ and from_ [s]
  bool is_live_ = false;
};

}  // namespace desmo
