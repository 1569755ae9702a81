// Instructions of a step: repeatable where times are not.
#include <algorithm>
#include <optional>
#include <set>

#include "report/statistics/selection.h"
#include "report/statistics/variants.h"
#include "report/tables/entries.h"
#include "report/tables/size.h"
#include "report/text/digits.h"

namespace desmo::report {
namespace {

using Counted = std::pair<const CandidateKey, StepCount>;

/// The paper's name of a formulation, where it has one.
std::string paper_name(const CandidateKey& key) {
  for (const Variant& variant : variants)
    for (const std::string_view family : sparse_families)
      if (variant.case_name == key.case_name &&
          family_key(variant, key.coordinates, family).id == key.id)
        return family_name(variant, family);
  return {};
}

/// Of one case at one size, the fewest first.
std::vector<const Counted*> sorted(const Record& record, const CandidateKey& place) {
  std::vector<const Counted*> counts;
  for (const Counted& counted : record.instructions)
    if (counted.first.case_name == place.case_name &&
        counted.first.coordinates == place.coordinates)
      counts.push_back(&counted);
  std::ranges::stable_sort(counts, {}, [](const Counted* c) { return c->second.instructions; });
  return counts;
}

/// "15.71": the reference's over these.
Entry ratio_entry_of(const std::optional<StepCount>& reference, const Counted& counted) {
  if (!reference) return note_entry(missing_mark);
  if (counted.first.id == usual_reference) return {"1.00 reference", {"1.00"}, "reference"};
  const double ratio = static_cast<double>(reference->instructions) /
                       static_cast<double>(counted.second.instructions);
  const std::string digits = write(ratio, ratio_digits(ratio));
  return {digits, {digits}, {}};
}

std::optional<StepCount> reference_of(const Record& record, const CandidateKey& place) {
  const auto found =
      record.instructions.find({place.case_name, place.coordinates, std::string(usual_reference)});
  return found == record.instructions.end() ? std::nullopt : std::optional(found->second);
}

Table table_of(const Record& record, const CandidateKey& place) {
  const std::string size = std::to_string(place.coordinates);
  Table table{.name = "instructions_" + place.case_name + "_" + size,
              .title = "Instructions a step: " + place.case_name + ", " + size + " coordinates",
              .notes = {"Delivery included, with as many Newton iterations as a step takes; the "
                        "mean over the steps counted. Times fewer: " +
                        std::string(usual_reference) + " over the formulation. Counted by " +
                        sorted(record, place).front()->second.tool +
                        ", which shows every program the same processor, without AVX-512."},
              .columns = {{"id", {}},
                          {"paper", {}},
                          {"instructions/step", {"instructions"}},
                          {"times fewer", {"ratio"}},
                          {"steps", {"steps"}}},
              .rows = {}};
  const std::optional<StepCount> reference = reference_of(record, place);
  for (const Counted* counted : sorted(record, place))
    table.rows.push_back({text_entry(counted->first.id), text_entry(paper_name(counted->first)),
                          count_entry(static_cast<std::size_t>(counted->second.instructions)),
                          ratio_entry_of(reference, *counted),
                          count_entry(static_cast<std::size_t>(counted->second.steps))});
  return table;
}

std::string sentence(const Record& record, const CandidateKey& place) {
  const Counted& fewest = *sorted(record, place).front();
  const std::optional<StepCount> reference = reference_of(record, place);
  return place.case_name + ", " + std::to_string(place.coordinates) +
         " coordinates: " + std::to_string(fewest.second.instructions) +
         " instructions a step are the fewest, with " + fewest.first.id +
         (reference ? "; " + std::string(usual_reference) + " takes " +
                          std::to_string(reference->instructions) + "."
                    : ".");
}

}  // namespace

Section instructions(const Record& record) {
  Section section{.title = "Instructions a step", .paragraphs = {}, .tables = {}};
  std::set<CandidateKey> places;
  for (const auto& [key, count] : record.instructions)
    places.insert({key.case_name, key.coordinates, {}});
  for (const CandidateKey& place : places) {
    section.paragraphs.push_back(sentence(record, place));
    section.tables.push_back(table_of(record, place));
  }
  return section;
}

}  // namespace desmo::report
