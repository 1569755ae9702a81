// Finding measurements in a record. Whoever looks for a number gets it or the reason for none.
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

/// A measurement, or the mark that stands in its place.
struct Measured {
  std::optional<SampleSummary> seconds;  ///< of one analysis
  std::string mark;  ///< failed_mark, not_run_mark or missing_mark; empty when measured
  Clock clock = Clock::cpu;
};

/// Return the time of a candidate; of a key, that of the CPU clock.
Measured measured(const Record& record, const CandidateKey& key);
Measured measured(const Measurement& candidate);

/// Measurements by their keys; they stand in the record.
using Measurements = std::map<CandidateKey, const Measurement*>;

/// Returns all of measurements() that was to be timed by a clock.
Measurements measurements_by(Clock clock, const Record& record);

/// The speed-up of one candidate over another, or the mark of the one that has no number.
struct MeasuredSpeedUp {
  std::optional<SpeedUp> speed_up;
  std::string mark;
};

/// Returns the speed-up over a reference; without one, the mark is missing_mark.
MeasuredSpeedUp measured_speed_up(const Record& record,
                                  const std::optional<CandidateKey>& reference,
                                  const CandidateKey& variant);

/// Throws std::logic_error for times of two clocks: they make no ratio.
MeasuredSpeedUp measured_speed_up(const Measured& reference, const Measured& variant);

/// The mean speed-up of one of the paper's variants over `truck_global` within a family, over those
/// of the paper's sizes where both were measured.
struct MeanSpeedUp {
  std::optional<SpeedUp> speed_up;
  std::size_t sizes = 0;  ///< number of sizes in the mean
};

MeanSpeedUp mean_speed_up(const Record& record, std::string_view family,
                          const PaperVariant& variant);

/// Returns the candidates of a case and size whose ids `holds` is true of, by id.
std::vector<CandidateKey> candidates_at(const Record& record, const CaseSize& place,
                                        const std::function<bool(const std::string&)>& holds);

/// Finds the fastest of some candidates; nothing where none has a time.
std::optional<CandidateKey> fastest_of(const Record& record,
                                       const std::vector<CandidateKey>& candidates);

/// Finds the fastest candidate of a case and size that something holds of; what stands next to
/// peers has no part in it, nor has an id that is no configuration.
std::optional<CandidateKey> fastest(const Record& record, const CaseSize& place,
                                    const std::function<bool(const Configuration&)>& holds);

/// Finds the fastest reference (is_reference) that has the paper's settings.
std::optional<CandidateKey> papers_reference(const Record& record, const CaseSize& place);

/// Finds the fastest reference with the guess and the tolerance of a candidate.
std::optional<CandidateKey> reference_like(const Record& record, const CandidateKey& key);

/// Returns the sizes recorded of each case, in whatever state.
template <class Entries>
std::map<std::string, std::set<std::int64_t>> recorded_sizes(const Entries& entries) {
  std::map<std::string, std::set<std::int64_t>> sizes;
  for (const auto& [key, entry] : entries) sizes[key.case_name].insert(key.coordinates);
  return sizes;
}

/// Returns the sparse families of which the record has a variant of the paper's, in whatever state.
/// case_name: of this case alone; empty: of any. No table shows other families, as of a build
/// without its solver or of a scene of the user's own.
std::vector<std::string_view> recorded_families(const Record& record,
                                                std::string_view case_name = {});

/// Says why there is no time; empty when there is one.
std::string remark(const Measurement& candidate);

}  // namespace desmo::report
