// Does the paper's conclusion survive another sparse solver? The numbers answer, not the program.
#include <algorithm>

#include "report/digits.h"
#include "report/measurements.h"
#include "report/paper.h"
#include "report/tables/tables.h"
#include "report/tables/verdicts.h"
#include "report/variants.h"

namespace desmo::report {
namespace {

// "holds with umfpack; is reversed with cholmod and klu": families by verdict, in their order.
std::string by_verdict(const std::vector<std::pair<std::string, std::string>>& verdicts) {
  std::vector<std::pair<std::string, std::vector<std::string>>> groups;
  for (const auto& [family, verdict] : verdicts) {
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const auto& known) { return known.first == verdict; });
    if (group == groups.end()) group = groups.insert(group, {verdict, {}});
    group->second.push_back(family);
  }
  std::string text;
  for (const auto& [verdict, families] : groups)
    text += (text.empty() ? "" : "; ") + verdict + " with " + enumeration(families);
  return text;
}

std::string paper_sentence() {
  std::vector<std::string> items;
  for (const std::size_t variant : paper_ranking())
    items.push_back(std::string(variants[variant].paper_name) + " " +
                    published_speed_up().text("mean", variants[variant].paper_name));
  return "The paper, with MA27 (mean speed-up over its global reference, fastest first): " +
         enumeration(items) + ".";
}

std::string family_sentence(const Family& family) {
  if (family.ranking.empty())
    return "With " + family.name +
           " nothing can be said: at none of the paper's sizes were all five truck variants "
           "measured.";
  std::vector<std::string> items;
  bool spread = true;
  for (const std::size_t variant : family.ranking) {
    const SpeedUp& ratio = family.over_global.at(variant);
    items.push_back(family_name(variants[variant], family.name) + " " +
                    write(ratio.value, ratio_digits(ratio.value)));
    spread = spread && ratio.spread;
  }
  std::string text = "With " + family.name;
  if (family.sizes.size() < published_sizes().size())
    text += " (" + std::to_string(family.sizes.size()) + " of the paper's " +
            std::to_string(published_sizes().size()) + " sizes only)";
  if (!spread) text += " (single runs)";
  return text + ": " + enumeration(items) + ".";
}

// The paper's best variant, family by family.
std::string best_sentence(const std::vector<Family>& families) {
  const std::string here = best_by_family(families, " times");
  if (here.empty()) return {};
  const std::string name(variants[paper_ranking().front()].paper_name);
  return name + ", the paper's fastest variant, is " + published_speed_up().text("mean", name) +
         " times as fast as its global reference with MA27; here " + here + ".";
}

std::string summary_sentence(Agreement found, const std::vector<Family>& families) {
  std::vector<std::string> judged;
  for (const Family& family : families)
    if (!family.ranking.empty()) judged.push_back(family.name);
  const bool one = judged.size() == 1;
  const std::string solvers = one ? judged.front() + ", the one sparse solver that can be judged"
                                  : "every sparse solver that can be judged";
  switch (found) {
    case Agreement::nothing_judged:
      return {};
    case Agreement::depends_on_solver:
      return "The choice of the sparse solver changes the conclusion.";
    case Agreement::as_the_paper:
      return "The paper's conclusion holds with " + solvers + ".";
    case Agreement::not_as_the_paper:
      break;
  }
  return "With " + solvers +
         (one ? ", the verdict is not the paper's in every point."
              : " the verdict is the same, and it is not the paper's in every point.");
}

}  // namespace

Section conclusion(const Record& record) {
  Section section{.title = "What the choice of the sparse solver does to the paper's conclusion",
                  .paragraphs = {},
                  .tables = {}};
  Table table{
      .name = "conclusion",
      .title = "The paper's conclusions by sparse solver, truck suspension",
      .notes = {std::string("Mean speed-ups over the paper's sizes; a comparison counts when "
                            "the interval") +
                (record.settings.windows ? "" : " from the spread of the repetitions") +
                " excludes 1."},
      .columns = {{"conclusion of the paper", {}}},
      .rows = {}};
  if (const Sources source = sources(record); !source.ratio_warning.empty())
    table.notes.push_back(source.ratio_warning);
  const std::vector<Family> families = judged_families(record);
  for (const Family& family : families) table.columns.push_back({family.name, {}});

  section.paragraphs.push_back(paper_sentence());
  if (families.empty()) {
    section.paragraphs.push_back("Nothing can be said: the record has no cell of a sparse solver.");
    return section;
  }

  std::string claim_text;
  const auto add_row = [&](const std::string& subject, auto verdict_of) {
    std::vector<Entry> row{text_entry(subject)};
    std::vector<std::pair<std::string, std::string>> verdicts;
    for (const Family& family : families) {
      verdicts.emplace_back(family.name, verdict_of(family));
      row.push_back(text_entry(verdicts.back().second));
    }
    table.rows.push_back(std::move(row));
    return by_verdict(verdicts);
  };
  for (const Claim& claim : claims())
    claim_text +=
        " That " + claim.text + " " +
        add_row(claim.text, [&](const Family& family) { return verdict(record, family, claim); }) +
        ".";
  claim_text += " The ranking of the four variants " +
                add_row("ranking of the four variants",
                        [&](const Family& family) { return ranking_verdict(record, family); }) +
                ".";

  for (const Family& family : families) section.paragraphs.push_back(family_sentence(family));
  if (std::string own = papers_own_verdict(record, families); !own.empty())
    section.paragraphs.push_back(std::move(own));
  std::string last = summary_sentence(agreement(record, families), families);
  if (const std::string best = best_sentence(families); !best.empty()) last += " " + best;
  last += claim_text;
  section.paragraphs.push_back(last.substr(last.find_first_not_of(' ')));
  section.tables.push_back(std::move(table));
  return section;
}

}  // namespace desmo::report
