// The front of the report: what the paper found, what this record says of it, what gains.
#include <algorithm>

#include "report/statistics/paper.h"
#include "report/tables/tables.h"
#include "report/text/digits.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

constexpr std::size_t papers_best = 6;  // TS-TPS_LAP, in `variants`
constexpr std::size_t min_repetitions = 3;

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
  return text.empty() ? sentence("answer.not_measured") : text;
}

/// Tells whether solvers differ by a factor of 1.5 or more and generated code is faster, like for
/// like.
bool shows_the_finding(const Record& record) {
  const std::vector<Mean> means = complete_means(record);
  const auto value = [](const Mean& mean) { return mean.speed_up.value; };
  const std::optional<Best> best = best_generated(record, "");
  return !means.empty() && best && best->like_for_like.speed_up &&
         best->like_for_like.speed_up->value > 1 &&
         value(*std::ranges::max_element(means, {}, value)) >=
             1.5 * value(*std::ranges::min_element(means, {}, value));
}

std::string what_gains(const Record& record) {
  const std::optional<Best> scalar = best_generated(record, ""),
                            lanes = best_generated(record, "lanes"),
                            segments = best_generated(record, "segments");
  const auto times = [](const std::optional<Best>& best, MeasuredSpeedUp Best::*ratio) {
    return best && (*best.*ratio).speed_up ? two_digits((*best.*ratio).speed_up->value)
                                           : missing_mark;
  };
  const auto like = &Best::like_for_like, paper = &Best::papers_settings;
  return sentence("answer.gains", {{"scalar", times(scalar, like)},
                                   {"lanes", times(lanes, like)},
                                   {"segments", times(segments, like)},
                                   {"scalar_paper", times(scalar, paper)},
                                   {"lanes_paper", times(lanes, paper)},
                                   {"segments_paper", times(segments, paper)}});
}

/// Returns the repetitions of what has the fewest, of the truck's candidates with a time; 0 where
/// there is none.
std::size_t least_repetitions(const Record& record) {
  std::size_t least = 0;
  for (const auto& [key, candidate] : record.candidates)
    if (const Measured time = measured(candidate);
        time.seconds && key.case_name == variants[truck_global].case_name)
      least = least == 0 ? time.seconds->count : std::min(least, time.seconds->count);
  return least;
}

}  // namespace

Section answer(const Record& record) {
  Section section = headed_section("answer");
  section.tables = {figure_of_speed_ups(record), best_formulations(record)};
  if (least_repetitions(record) >= min_repetitions) {
    const std::string_view name = variants[papers_best].paper_name;
    section.paragraphs = {
        sentence("answer.paper", {{"variant", name},
                                  {"published", published_speed_up().text("mean", name)},
                                  {"by_solver", list(complete_means(record))}}),
        sentence(shows_the_finding(record) ? "answer.finding" : "answer.finding_not_shown"),
        what_gains(record)};
  } else {
    section.paragraphs = {sentence("answer.too_few"), sentence("answer.finding_filed")};
    for (Table& table : section.tables) table.title += " (first look)";
  }
  if (const std::size_t count = failures(record).size(); count > 0)
    section.paragraphs.push_back(sentence("answer.failed", {{"count", count}}));
  return section;
}

}  // namespace desmo::report
