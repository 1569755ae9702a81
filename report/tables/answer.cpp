// The front of the report: what the paper found, what this record says of it, what gains. Fixed
// sentences with numbers in them, and two tables.
#include <algorithm>

#include "report/statistics/measurements.h"
#include "report/statistics/paper.h"
#include "report/statistics/variants.h"
#include "report/tables/best.h"
#include "report/tables/tables.h"
#include "report/text/digits.h"

namespace desmo::report {
namespace {

constexpr std::size_t papers_best = 6;  // TS-TPS_LAP, in `variants`
constexpr std::size_t min_repetitions = 3;

constexpr const char* finding =
    "The speed-up that the paper found depends on the solver underneath, not on the topology; what "
    "gains is generating the elimination.";

std::string two_digits(double value) { return write(value, significant_digits(value, 2)); }

/// The mean speed-up of the paper's best variant with one sparse solver, over all its sizes.
struct Mean {
  std::string_view family;
  SpeedUp speed_up;
};

std::vector<Mean> complete_means(const Record& record) {
  std::vector<Mean> means;
  for (const std::string_view family : recorded_families(record)) {
    const MeanSpeedUp mean =
        mean_speed_up(record, family, truck_global, papers_best, published_sizes());
    if (mean.speed_up && mean.sizes == published_sizes().size())
      means.push_back({family, *mean.speed_up});
  }
  return means;
}

/// "cholmod 0.61, umfpack 2.3, klu 0.15"
std::string list(const std::vector<Mean>& means) {
  std::string text;
  for (const auto& [family, speed_up] : means)
    text += (text.empty() ? "" : ", ") + std::string(family) + " " + two_digits(speed_up.value) +
            (speed_up.inconclusive() ? " (inconclusive)" : "");
  return text.empty() ? "not measured" : text;
}

std::string what_the_paper_found(const Record& record) {
  const std::string name(variants[papers_best].paper_name);
  return "The paper's best variant, " + name +
         " (group after group, generated equations, LAPACK), was " +
         published_speed_up().text("mean", name) +
         " times as fast as its global formulation with the sparse solver MA27. Here the same "
         "ratio "
         "is, by the sparse solver: " +
         list(complete_means(record)) + ".";
}

/// Whether solvers differ by a factor of 1.5 or more and generated code is faster, like for like.
bool shows_the_finding(const Record& record) {
  const std::vector<Mean> means = complete_means(record);
  const auto value = [](const Mean& mean) { return mean.speed_up.value; };
  const std::optional<Best> best = best_generated(record, Batch::none);
  return !means.empty() && best && best->like_for_like.speed_up &&
         best->like_for_like.speed_up->value > 1 &&
         value(*std::ranges::max_element(means, {}, value)) >=
             1.5 * value(*std::ranges::min_element(means, {}, value));
}

std::string what_gains(const Record& record) {
  const std::optional<Best> scalar = best_generated(record, Batch::none),
                            lanes = best_generated(record, Batch::lanes),
                            segments = best_generated(record, Batch::segments);
  const auto times = [](const std::optional<Best>& best, MeasuredSpeedUp Best::*ratio) {
    return best && (*best.*ratio).speed_up ? two_digits((*best.*ratio).speed_up->value)
                                           : missing_mark;
  };
  const auto like = &Best::like_for_like, paper = &Best::papers_settings;
  return "On one thread, a generated elimination is " + times(scalar, like) +
         " times as fast as the fastest global reference with the same guess and tolerance, " +
         times(lanes, like) + " times with equal parts side by side (lanes), " +
         times(segments, like) +
         " times with pieces of a motion known in advance side by side (segments); over the "
         "reference with the paper's settings " +
         times(scalar, paper) + ", " + times(lanes, paper) + " and " + times(segments, paper) +
         " times.";
}

/// Repetitions of what has the fewest, of the truck's candidates with a time; 0 where there is
/// none.
std::size_t least_repetitions(const Record& record) {
  std::size_t least = 0;
  for (const auto& [key, candidate] : record.candidates)
    if (const Measured time = measured(record, key);
        time.seconds && key.case_name == variants[truck_global].case_name)
      least = least == 0 ? time.seconds->count : std::min(least, time.seconds->count);
  return least;
}

}  // namespace

Section answer(const Record& record) {
  Section section{.title = "The answer",
                  .paragraphs = {},
                  .tables = {figure_of_speed_ups(record), best_formulations(record)}};
  if (least_repetitions(record) >= min_repetitions) {
    section.paragraphs = {
        what_the_paper_found(record),
        (shows_the_finding(record) ? "" : "The filed records say, and this one does not show: ") +
            std::string(finding),
        what_gains(record)};
  } else {
    section.paragraphs = {
        "Too few repetitions for a figure; run bench/run without --quick. The tables are a first "
        "look.",
        "The filed records say: " + std::string(finding)};
    for (Table& table : section.tables) table.title += " (first look)";
  }
  if (const std::size_t count = failures(record).size(); count > 0)
    section.paragraphs.push_back("Failed their verification and have no time: " +
                                 std::to_string(count) + "; the last section says which and why.");
  return section;
}

}  // namespace desmo::report
