// Finding measurements in a record: functions return a number, or the mark that says why there is
// none.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "report/read/record.h"
#include "report/statistics/statistics.h"
#include "report/statistics/variants.h"

namespace desmo::report {

/// The time of one analysis, or the mark that stands in its place.
struct Measured {
  std::optional<SampleSummary> seconds;  ///< time of one analysis; none: it was not measured
  std::string mark;  ///< failed_mark, not_run_mark or missing_mark; empty when measured
  Clock clock = Clock::cpu;
};

/// Return the time of a candidate. A key is looked up in Record::candidates (by the CPU clock).
Measured measured(const Record& record, const CandidateKey& key);
Measured measured(const Measurement& candidate);

/// Measurements by their keys. They refer to the record.
using Measurements = std::map<CandidateKey, const Measurement*>;

/// Returns the measurements() that a clock times or was to time.
Measurements measurements_by(Clock clock, const Record& record);

/// The speed-up of one candidate over another, or the mark of the one that has no time.
struct MeasuredSpeedUp {
  std::optional<SpeedUp> speed_up;
  std::string mark;  ///< empty when there is a speed-up
};

/// Returns the speed-up over a reference; without one, the mark is missing_mark.
MeasuredSpeedUp measured_speed_up(const Record& record,
                                  const std::optional<CandidateKey>& reference,
                                  const CandidateKey& variant);

/// Returns the speed-up. Throws std::logic_error for times of two clocks: they make no ratio.
MeasuredSpeedUp measured_speed_up(const Measured& reference, const Measured& variant);

/// The mean speed-up of one of the paper's variants relative to `truck_global` with the same sparse
/// solver. The mean is that of the paper's sizes at which both were measured.
struct MeanSpeedUp {
  std::optional<SpeedUp> speed_up;
  std::size_t sizes = 0;  ///< number of sizes in the mean
};

MeanSpeedUp mean_speed_up(const Record& record, std::string_view family,
                          const PaperVariant& variant);

/// Returns the candidates of a case and size whose ids fulfil `holds`, ordered by id.
std::vector<CandidateKey> candidates_at(const Record& record, const CaseSize& place,
                                        const std::function<bool(const std::string&)>& holds);

/// Finds the fastest of some candidates; returns nothing where none has a time.
std::optional<CandidateKey> fastest_of(const Record& record,
                                       const std::vector<CandidateKey>& candidates);

/// Finds the fastest candidate of a case and size whose configuration fulfils `holds`. Leaves out
/// candidates that stand next to peers (is_beside_peers()) and ids that are no configuration.
std::optional<CandidateKey> fastest(const Record& record, const CaseSize& place,
                                    const std::function<bool(const Configuration&)>& holds);

/// Finds the fastest reference (is_reference()) that has the paper's settings.
std::optional<CandidateKey> papers_reference(const Record& record, const CaseSize& place);

/// Finds the fastest reference with the guess, iterations and tolerance of a candidate. Returns
/// nothing where the candidate's id is no configuration.
std::optional<CandidateKey> reference_like(const Record& record, const CandidateKey& key);

/// Returns the numbers of coordinates recorded of each case, measured or not.
template <class Entries>
std::map<std::string, std::set<std::int64_t>> recorded_sizes(const Entries& entries) {
  std::map<std::string, std::set<std::int64_t>> sizes;
  for (const auto& [key, entry] : entries) sizes[key.case_name].insert(key.coordinates);
  return sizes;
}

/// Returns the families (sparse solvers) with which the record has one of the paper's variants,
/// measured or not, in the order of sparse_families. Tables show these families only.
/// - case_name: only variants of this case count; empty: those of any case
std::vector<std::string_view> recorded_families(const Record& record,
                                                std::string_view case_name = {});

/// Returns why a candidate has no time; empty when it has one.
std::string remark(const Measurement& candidate);

}  // namespace desmo::report
