// The answer of the benchmark: what the paper found, what this record says of it, and the best
// formulations of one thread. *Like for like* means: compared with reference_like(), the fastest
// global reference with the same guess, iterations and tolerance.
#include <algorithm>
#include <array>

#include "report/statistics/paper.h"
#include "report/tables/entries.h"
#include "report/tables/record_words.h"
#include "report/tables/tables.h"

namespace desmo::report {
namespace {

/// Tells whether a formulation has one setting apart from those of its iteration, and that is
/// `kind`: "lanes" or "segments". If `kind` is "", tells whether it has none.
bool is_side_by_side(const Configuration& c, std::string_view kind) {
  if (kind.empty()) return c.has_papers_algorithm();
  return c.others.size() == 1 && c.others.front().starts_with(std::string(kind) + ":");
}

bool has_other_iteration(const std::optional<Configuration>& c) {
  return c && c->has_papers_algorithm() && !c->is_papers();
}

/// Returns the last case, which is the truck where both cases were measured, at the largest size at
/// which settings of the iteration other than the paper's were measured. Where there is no such
/// size, it is the case's largest. Returns an empty name where there is no candidate.
CaseSize in_front(const Record& record) {
  if (record.candidates.empty()) return {};
  const CaseSize& last = record.candidates.rbegin()->first;
  CaseSize found = last;
  for (const auto& [key, candidate] : record.candidates)  // sizes ascend
    if (key.case_name == last.case_name && has_other_iteration(parse_configuration(key.id)) &&
        !is_beside_peers(record, key.id))
      found.coordinates = key.coordinates;
  return found;
}

std::optional<CandidateKey> papers_reference(const Record& record) {
  return papers_reference(record, in_front(record));
}

std::optional<CandidateKey> best_reference(const Record& record) {
  return fastest(record, in_front(record), is_reference);
}

/// Finds the fastest generated elimination with the guess, iterations and tolerance of a
/// configuration. side_by_side: is_side_by_side().
std::optional<CandidateKey> generated_like(const Record& record, const Configuration& like,
                                           std::string_view side_by_side) {
  return fastest(record, in_front(record), [&](const Configuration& c) {
    return algebra_kind(c.formulation) == "generated" && c.iterates_like(like) &&
           is_side_by_side(c, side_by_side);
  });
}

void add_row(Table& table, const Record& record, const std::string& what,
             const std::optional<CandidateKey>& key) {
  if (!key) return;
  const auto over_entry = [&](const std::optional<CandidateKey>& reference) {
    return key == reference ? reference_entry()
                            : ratio_entry(measured_speed_up(record, reference, *key));
  };
  table.rows.push_back({what, key->id, instant_entry(record, measured(record, *key), 3),
                        over_entry(reference_like(record, *key)),
                        over_entry(papers_reference(record))});
}

TextValues words_of(const Record& record) {
  const CaseSize place = in_front(record);
  return timed_words(record, {{"case", place.case_name}, {"coordinates", place.coordinates}});
}

/// Finds the fastest generated elimination with the guess, iterations and tolerance of the fastest
/// global reference. side_by_side: "lanes", "segments", or "" for neither.
std::optional<CandidateKey> best_generated(const Record& record, std::string_view side_by_side) {
  const std::optional<CandidateKey> reference = best_reference(record);
  if (!reference) return std::nullopt;
  return generated_like(record, *parse_configuration(reference->id), side_by_side);
}

/// Returns the speed-up of a candidate relative to reference_like() it; nothing where one of the
/// two is missing.
std::optional<SpeedUp> like_for_like(const Record& record, const std::optional<CandidateKey>& key) {
  if (!key) return std::nullopt;
  return measured_speed_up(record, reference_like(record, *key), *key).speed_up;
}

/// Lists the global reference and the best formulations, with the paper's settings and with the
/// best ones.
Table best_formulations(const Record& record) {
  Table table = headed_table("best", words_of(record));
  const std::optional<CandidateKey> paper = papers_reference(record), best = best_reference(record);
  add_row(table, record, "global, paper's settings", paper);
  add_row(table, record, "generated elimination, paper's settings", generated_like(record, {}, ""));
  if (best && best != paper) {
    add_row(table, record, "global, best settings", best);
    add_row(table, record, "generated elimination, best settings", best_generated(record, ""));
    add_row(table, record, "the same, in lanes", best_generated(record, "lanes"));
    add_row(table, record, "the same, in segments", best_generated(record, "segments"));
  }
  if (!paper) {  // the ratios of the last column have no reference
    table.columns.pop_back();
    for (auto& row : table.rows) row.pop_back();
  }
  return table;
}

constexpr const PaperVariant& papers_best = paper_variants.back();  // TS-TPS_LAP

std::string two_digits(double value) { return write(value, significant_digits(value, 2)); }

/// The mean speed-up of the paper's best variant with one sparse solver, over all of the paper's
/// sizes.
struct Mean {
  std::string_view family;
  SpeedUp speed_up;
};

std::vector<Mean> complete_means(const Record& record) {
  std::vector<Mean> means;
  for (const std::string_view family : recorded_families(record)) {
    const MeanSpeedUp mean = mean_speed_up(record, family, papers_best);
    if (mean.speed_up && mean.sizes == published_sizes().size())
      means.push_back({family, *mean.speed_up});
  }
  return means;
}

/// Returns mean speed-ups in words: "cholmod 0.61, umfpack 2.3, klu 0.15".
std::string list(const std::vector<Mean>& means) {
  std::string text;
  for (const auto& [family, speed_up] : means)
    text += (text.empty() ? "" : ", ") + std::string(family) + " " + two_digits(speed_up.value) +
            (speed_up.inconclusive() ? " (inconclusive)" : "");
  return text.empty() ? sentence("answer.not_measured") : text;
}

/// Tells whether the record shows the benchmark's finding:
/// - means with different sparse solvers differ by a factor of 1.5 or more
/// - the best generated elimination has a speed-up above 1, like for like
bool shows_the_finding(const Record& record) {
  const std::vector<Mean> means = complete_means(record);
  const auto value = [](const Mean& mean) { return mean.speed_up.value; };
  const std::optional<SpeedUp> speed_up = like_for_like(record, best_generated(record, ""));
  return !means.empty() && speed_up && speed_up->value > 1 &&
         value(*std::ranges::max_element(means, {}, value)) >=
             1.5 * value(*std::ranges::min_element(means, {}, value));
}

/// Returns the values of placeholders in the texts "answer" and "answer_numbers": speed-ups of the
/// best formulations. A missing speed-up is missing_mark, and its clause empty.
TextValues what_gains(const Record& record) {
  TextValues values = words_of(record);
  std::vector<std::string> over_paper;
  for (const auto& [way, kind, clause] : {std::array{"scalar", "", ""},
                                          {"lanes", "lanes", "lanes_too"},
                                          {"segments", "segments", "segments_too"}}) {
    const std::optional<CandidateKey> best = best_generated(record, kind);
    const std::optional<SpeedUp> speed_up = like_for_like(record, best);
    const TextValue times(way, speed_up ? two_digits(speed_up->value) : missing_mark);
    values.push_back(times);
    if (*clause)
      values.emplace_back(clause,
                          speed_up ? sentence(std::string("answer.") + clause, {times}) : "");
    if (!speed_up) continue;
    if (const auto over = measured_speed_up(record, papers_reference(record), *best).speed_up)
      over_paper.push_back(two_digits(over->value));
  }
  const TextValue ratios("ratios", in_a_row(over_paper));
  values.emplace_back("paper_too",
                      over_paper.empty() ? "" : sentence("answer.paper_too", {ratios}));
  return values;
}

/// Returns the least number of repetitions of the candidates that have a time, at all sizes of the
/// case in front; 0 where none has.
std::size_t least_repetitions(const Record& record) {
  const std::string name = in_front(record).case_name;
  std::size_t least = 0;
  for (const auto& [key, candidate] : record.candidates)
    if (const Measured time = measured(candidate); time.seconds && key.case_name == name)
      least = least == 0 ? time.seconds->count : std::min(least, time.seconds->count);
  return least;
}

}  // namespace

Section answer(const Record& record) {
  Section section =
      headed_section("answer", {}, {figure_of_speed_ups(record), best_formulations(record)});
  const auto say = [&](const char* name, const TextValues& values = {}) {
    section.paragraphs.push_back(sentence(std::string("answer.") + name, values));
  };
  const bool is_the_papers = !recorded_families(record, truck_case).empty();
  const std::size_t repetitions = least_repetitions(record);
  if (repetitions == 0) {
    say("nothing_timed");
  } else if (repetitions < min_for_interval) {
    say("first_look");
    if (is_the_papers) say("finding_filed");
  } else {
    if (is_the_papers) {
      const std::string_view name = papers_best.paper_name;
      say("paper", {{"variant", name},
                    {"published", published(published_speed_up, "mean", name)},
                    {"by_solver", list(complete_means(record))}});
      say(shows_the_finding(record) ? "finding" : "finding_not_shown");
    }
    const TextValues gains = what_gains(record);
    say(best_generated(record, "") ? "gains" : "no_gains", gains);
    section.numbers = headed_section("answer_numbers", gains).numbers;
  }
  if (const std::size_t count = failures(record).size(); count > 0)
    say("failed", {{"count", count}});
  return section;
}

}  // namespace desmo::report
