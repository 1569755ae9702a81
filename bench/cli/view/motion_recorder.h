// Records the data of a page from a checked run: instants, their accuracy, and where they are
// flagged.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "bench/kit/process/progress.h"
#include "cases/io/units.h"
#include "formulations/modelling/measures/measures.h"
#include "formulations/verification/run/checked_run.h"

namespace desmo::cli {

/// An instant that is kept.
struct RecordedInstant {
  int index;                  ///< index in the grid
  std::vector<double> state;  ///< q, q̇, q̈, each of all coordinates, then of the measures
  double condition;           ///< largest condition number since the instant kept before
  PerLevel<double> radius;    ///< largest relative radius since that instant; NaN: none was proven
};

/// An interval that is flagged, and why.
struct Flag {
  enum class Kind { unproven, misfit, failed, crossing, branch };
  Kind kind;
  double from, to;  ///< first and last time of the interval [s]
  std::string text;
  std::vector<EntityId> open{};  ///< entities of the constraint that does not close
};

/// An observer that keeps every n-th instant, and the last one before every gap and before the end.
/// n is 1 at first. When more than `max_kept`, at least 4, are kept, it doubles n and drops the
/// instants between. Gaps shorter than n instants are then no longer shown.
class MotionRecorder final : public Observer {
 public:
  /// max_kept: number of instants to keep, those before gaps and the end not counted. progress:
  /// null where none is shown.
  MotionRecorder(const Model& model, Measures& measures, const DisplayUnits& units,
                 const TimeGrid& grid, std::size_t max_kept, bench::Progress* progress);

  /// Runs the formulation over the motion, and past intervals that cannot be assembled. Where no
  /// instant is kept, keeps the initial estimate, at rest.
  CheckedSummary run(Formulation& formulation);

  Flow observe(const Instant& instant) noexcept override;

  /// Doubles n. Drops all instants that are no multiples of it, except those before gaps longer
  /// than n instants and, after the run, the last. A dropped instant hands its condition number and
  /// radii to the next one that is kept.
  void thin_out();

  const std::vector<RecordedInstant>& instants() const { return instants_; }
  int stride() const { return stride_; }  ///< n of the class comment
  /// Returns the number of instants solved, without those on a change point.
  long solved() const { return solved_; }
  const std::vector<Flag>& flags() const { return flags_; }  ///< in order of their beginning
  bool overflowed() const { return overflowed_; }            ///< a number is not finite

 private:
  static constexpr PerLevel<double> no_radius{NAN, NAN, NAN};

  void record(const CheckedInstant& instant);
  std::vector<double> state_of(const Instant& instant);
  void keep(RecordedInstant instant);
  void flag(const RowFlag& flag, int index);
  void flag_failures(const CheckedSummary& summary);

  /// A flag whose interval grows if the next row has the same flag.
  struct Lasting {
    int last_row;       // index in the grid of the last row that has the flag
    std::size_t place;  // index in flags_
    GroupId group;
  };

  const Model& model_;
  Measures& measures_;
  const DisplayUnits& units_;  // units of the flags' texts
  const TimeGrid grid_;
  const std::size_t max_kept_;
  bench::Progress* progress_;
  std::vector<RecordedInstant> instants_;
  std::optional<RecordedInstant> passed_;  // last instant recorded, unless it is in instants_
  std::vector<Flag> flags_;
  std::vector<Lasting> lasting_;
  int stride_ = 1;
  long solved_ = 0;
  double condition_ = 0;
  PerLevel<double> radius_ = no_radius;
  bool overflowed_ = false, is_over_ = false;  // a number is not finite; the run has ended
};

}  // namespace desmo::cli
