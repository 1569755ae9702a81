// The question, what the numbers answer, and what was fastest of all: one sentence each.
#include <functional>

#include "report/digits.h"
#include "report/measurements.h"
#include "report/paper.h"
#include "report/tables/tables.h"
#include "report/tables/verdicts.h"

namespace desmo::report {
namespace {

std::string best_name() { return std::string(variants[paper_ranking().front()].paper_name); }

std::string question() {
  return "Is a mechanism solved faster one structural group after the other than all at once, as a "
         "paper found, whose best variant, " +
         best_name() + ", was " + published_speed_up().text("mean", best_name()) +
         " times as fast as its global reference with the sparse solver MA27?";
}

std::string answer_of(const Record& record) {
  const std::vector<Family> families = judged_families(record);
  const std::string here = " that speed-up is " + best_by_family(families) + ".";
  switch (agreement(record, families)) {
    case Agreement::depends_on_solver:
      return "It depends on the sparse solver in the global reference: here" + here;
    case Agreement::as_the_paper:
      return "Yes, and for the paper's reasons, with every sparse solver that can be judged: here" +
             here;
    case Agreement::not_as_the_paper:
      return "Not in every point as the paper found, whichever sparse solver can be judged: here" +
             here;
    case Agreement::nothing_judged:
      break;
  }
  return "This record cannot say: with no sparse solver were all five truck variants measured at "
         "one of the paper's sizes.";
}

// Of the truck's cells of a size, the one that is worth most.
const CellKey* best_of(const Record& record, std::int64_t size,
                       const std::function<double(const CellKey&, const Summary&)>& worth) {
  const CellKey* found = nullptr;
  double most = 0;
  for (const auto& [key, cell] : record.cells) {
    if (key.case_name != variants[truck_global].case_name || key.coordinates != size) continue;
    const Measured time = measured(record, key);
    if (!time.seconds) continue;
    const double its = worth(key, *time.seconds);
    if (its <= most) continue;
    found = &key;
    most = its;
  }
  return found;
}

std::string fastest_of_all(const Record& record) {
  const std::string_view name = variants[truck_global].case_name;
  const std::vector<std::int64_t> sizes = recorded_sizes(record, name);
  if (sizes.empty()) return "The record has no cell of " + std::string(name) + ".";
  const std::string of_all = "Of everything measured on " + std::string(name) + " with " +
                             std::to_string(sizes.back()) + " coordinates, ";
  const CellKey* const global =
      best_of(record, sizes.back(), [](const CellKey& key, const Summary& seconds) {
        return key.id.starts_with("global_") ? 1 / seconds.value : 0;
      });
  // By what it is worth at least: a time that was disturbed may have any.
  const CellKey* const best =
      best_of(record, sizes.back(), [&](const CellKey& key, const Summary& seconds) {
        if (!global) return 1 / seconds.value;
        const SpeedUp ratio = *measured_speed_up(record, *global, key).speed_up;
        return ratio.spread ? ratio.low : ratio.value;
      });
  if (!best) return of_all + "nothing has a time.";
  if (!global) return of_all + best->id + " is the fastest; no global formulation has a time.";
  if (best == global) return of_all + "the global " + best->id + " is the fastest.";
  const SpeedUp ratio = *measured_speed_up(record, *global, *best).speed_up;
  const DigitStyle style = ratio_digits(ratio.value);
  return of_all + best->id + " is the fastest, " + write(ratio.value, style) +
         (ratio.spread ? " [" + write(ratio.low, style) + ", " + write(ratio.high, style) + "]"
                       : "") +
         (ratio.inconclusive() ? " (inconclusive)" : "") +
         " times as fast as the fastest global formulation, " + global->id + ".";
}

}  // namespace

Section answer(const Record& record) {
  std::string text = question() + " " + answer_of(record) + " " + fastest_of_all(record);
  if (const std::size_t count = failures(record).size(); count > 0)
    text += " " + std::to_string(count) + (count == 1 ? " formulation" : " formulations") +
            " failed the verification and " + (count == 1 ? "has" : "have") +
            " no time: the last section says which and why.";
  return {"The question and its answer", {text}, {}};
}

}  // namespace desmo::report
