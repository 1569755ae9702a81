#include "report/tables/time_words.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace desmo::report {

bool has_samples_of_windows(const Record& record) {
  return std::ranges::any_of(record.candidates, [](const auto& candidate) {
    return !candidate.second.time.windows.samples.empty();
  });
}

TimeWords time_words(const Record& record) {
  if (!record.settings.windows) return {"median", "medians", "", {}};
  const std::string windows =
      std::to_string(*record.settings.windows) + " equal pieces of the motion";
  return {"undisturbed time", "undisturbed times", " (and median)",
          has_samples_of_windows(record)
              ? "Undisturbed time: of " + windows +
                    " in all repetitions, the lower convex envelope of CPU time over Newton "
                    "updates, both an instant, at the updates of the whole motion. Interval of a "
                    "ratio: without the best repetition of either side."
              : "Undisturbed time: of each of " + windows +
                    " the least CPU time that any repetition took, summed. Interval of a ratio: "
                    "95 %, from how it varies from piece to piece."};
}

std::string capitalised(std::string text) {
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

void define_time(Table& table, const Record& record) {
  const TimeWords words = time_words(record);
  if (!words.definition.empty()) table.notes.push_back(words.definition);
}

std::string repetitions(const Record& record) {
  std::set<std::size_t> counts;
  for (const auto& [key, candidate] : record.candidates)
    if (candidate.status == Status::ok) counts.insert(candidate.time.seconds.size());
  if (counts.empty()) return "no repetitions";
  const std::string least = std::to_string(*counts.begin());
  const std::string largest = std::to_string(*counts.rbegin());
  return (least == largest ? least : least + " to " + largest) +
         (largest == "1" ? " repetition" : " repetitions");
}

}  // namespace desmo::report
