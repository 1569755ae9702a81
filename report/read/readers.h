// The readers of the parts of a record. All throw InputError, naming the place, where
// - something is given twice, or a key is missing
// - a time is not above zero
// - a measurement is "ok" without a verification or, in the accuracy experiment, an error
// A measurement whose verification exceeds `record.settings.allowed` becomes a failure that says so
// and has no time.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "report/read/record.h"
#include "report/read/record_value.h"

namespace desmo::report {

/// Read an experiment, the object of that name in a record, into the record.
void read_paper(Record& record, const RecordValue& experiment);
void read_accuracy(Record& record, const RecordValue& experiment);
void read_sizes(Record& record, const RecordValue& experiment);
void read_modelling(Record& record, const RecordValue& experiment);
void read_instructions(Record& record, const RecordValue& experiment);
void read_extremes(Record& record, const RecordValue& experiment);

/// An experiment that a record may have.
struct Experiment {
  const char* name;              ///< key of its object in the record
  bool (*is_in)(const Record&);  ///< tells whether a record has anything of it
  void (*read)(Record&, const RecordValue&);
};

/// The experiments, in the order in which pages show them.
inline constexpr Experiment experiments[] = {
    {"paper", has_paper, read_paper},
    {"accuracy", [](const Record& r) { return !r.points.empty(); }, read_accuracy},
    {"size", [](const Record& r) { return !r.growth.empty() || !r.break_even.empty(); },
     read_sizes},
    {"modelling", [](const Record& r) { return !r.modelled.empty(); }, read_modelling},
    {"instructions", [](const Record& r) { return !r.instructions.empty(); }, read_instructions},
    {"extremes", [](const Record& r) { return !r.extremes.empty(); }, read_extremes}};

// ---- what several experiments have ----

/// Calls `read` with each element of a list of an experiment. The list may be missing.
template <class Read>
void read_each(const RecordValue& experiment, std::string_view list, const Read& read) {
  if (const auto found = experiment.find(list))
    for (const RecordValue node : found->elements()) read(node);
}

/// Adds a value, which was read from a node, to a map. Throws InputError when the map has the key.
/// - name: words for the value, for the message
template <class Map, class Key>
void add_once(Map& map, const RecordValue& node, const Key& key, typename Map::mapped_type value,
              const std::string& name) {
  if (!map.emplace(key, std::move(value)).second) node.complain(name + " is given twice");
}

/// Read the keys of a node that name a case at a size, and those that name a candidate.
CaseSize read_case_size(const RecordValue& node);
CandidateKey read_key(const RecordValue& node);

/// Reads "ok", "failed" or "not_run".
Status read_status(const RecordValue& node);

/// Reads the members "position", "velocity" and "acceleration" by a function of a RecordValue.
template <class Read>
auto read_levels(const RecordValue& node, const Read& read) {
  return PerLevel{std::invoke(read, node["position"]), std::invoke(read, node["velocity"]),
                  std::invoke(read, node["acceleration"])};
}

/// Returns words for each level that exceeds its limit, "velocity differs by 2e-06, 1e-08 is
/// allowed"; empty when none does.
std::string excess(const LevelNumbers& found, const LevelNumbers& allowed);

/// Turns a measurement into a failure that has no time. An empty reason leaves it as it is.
void fail(Measurement& measurement, std::string reason);

/// Reads samples of a time [s], at least one.
std::vector<double> read_samples(const RecordValue& node);

/// Throws InputError unless a time is by that clock. what: words for what is measured by it, for
/// the message.
void require_clock(const RecordValue& time, Clock clock, std::string_view what);

/// Reads the time of a whole analysis: its clock, which the id determines, its samples, and its
/// timing windows, where the settings have some. By the wall clock the whole motion is one window.
Time read_time(const RecordValue& node, const RecordSettings& settings, std::string_view id);

/// Reads the time of a step, which must be by the CPU clock and is one window.
Time read_step_time(const RecordValue& node);

}  // namespace desmo::report
