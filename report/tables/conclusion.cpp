// Does the paper's conclusion survive another sparse solver? The numbers answer, not the program.
#include <algorithm>
#include <map>

#include "report/digits.h"
#include "report/measurements.h"
#include "report/paper.h"
#include "report/tables/tables.h"
#include "report/variants.h"

namespace desmo::report {
namespace {

enum class Order { faster, slower, within_spread };

// What the paper concludes: in each pair of variants, the second is the faster.
struct Claim {
  std::string text;
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
};

const std::vector<Claim>& claims() {
  static const std::vector<Claim> all{
      {"solving by groups beats solving globally",
       {{truck_global, 3}, {truck_global, 4}, {truck_global, 5}, {truck_global, 6}}},
      {"symbolic equations beat automatic ones", {{3, 5}, {4, 6}}},
      {"in the groups, LAPACK beats the sparse solver", {{3, 4}, {5, 6}}}};
  return all;
}

// One family over the sizes at which it can be judged.
struct Family {
  std::string name;
  std::vector<std::int64_t> sizes;   // of the paper's, all five truck variants measured
  std::vector<std::size_t> ranking;  // fastest first; empty when there is no such size
  std::map<std::size_t, SpeedUp> over_global;
};

Family judge(const Record& record, std::string_view name) {
  Family family{std::string(name), {}, {}, {}};
  for (const std::int64_t size : published_sizes())
    if (std::all_of(variants.begin() + truck_global, variants.end(), [&](const Variant& variant) {
          return measured(record, family_key(variant, size, name)).seconds.has_value();
        }))
      family.sizes.push_back(size);
  if (family.sizes.empty()) return family;
  for (const std::size_t variant : topological)
    family.over_global[variant] =
        *mean_speed_up(record, name, truck_global, variant, family.sizes).speed_up;
  family.ranking.assign(topological.begin(), topological.end());
  std::stable_sort(family.ranking.begin(), family.ranking.end(), [&](std::size_t a, std::size_t b) {
    return family.over_global[a].value > family.over_global[b].value;
  });
  return family;
}

std::vector<std::size_t> paper_ranking() {
  std::vector<std::size_t> ranking(topological.begin(), topological.end());
  const auto mean = [](std::size_t variant) {
    return published_speed_up().number("mean", variants[variant].paper_name).value_or(0);
  };
  std::stable_sort(ranking.begin(), ranking.end(),
                   [&](std::size_t a, std::size_t b) { return mean(a) > mean(b); });
  return ranking;
}

// How `variant` stands to `reference`; the spread of the repetitions must not reach equality.
Order order(const Record& record, const Family& family, std::size_t reference,
            std::size_t variant) {
  const SpeedUp ratio =
      *mean_speed_up(record, family.name, reference, variant, family.sizes).speed_up;
  if (ratio.low > 1) return Order::faster;
  if (ratio.high < 1) return Order::slower;
  return Order::within_spread;
}

std::string verdict(const Record& record, const Family& family, const Claim& claim) {
  if (family.ranking.empty()) return "cannot be said";
  std::size_t held = 0, reversed = 0;
  std::string exceptions;
  for (const auto& [slower, faster] : claim.pairs) {
    const Order found = order(record, family, slower, faster);
    held += found == Order::faster;
    reversed += found == Order::slower;
    if (found != Order::faster)
      exceptions += (exceptions.empty() ? "" : ", ") + family_name(variants[faster], "<sparse>") +
                    (found == Order::slower ? " (slower)" : " (within the spread)");
  }
  if (held == claim.pairs.size()) return "holds";
  if (reversed == claim.pairs.size()) return "is reversed";
  if (held + reversed == 0) return "is undecided within the spread";
  return (held > 0 ? "holds except for " : "does not hold: ") + exceptions;
}

std::string ranking_verdict(const Record& record, const Family& family) {
  if (family.ranking.empty()) return "cannot be said";
  const std::vector<std::size_t> paper = paper_ranking();
  if (family.ranking == paper) return "is the paper's";
  for (std::size_t i = 0; i < paper.size(); ++i)
    for (std::size_t j = i + 1; j < paper.size(); ++j)
      if (order(record, family, paper[j], paper[i]) == Order::slower)
        return "is another than the paper's";
  return "is the paper's within the spread";
}

std::string enumeration(const std::vector<std::string>& items) {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i)
    text += (i == 0 ? "" : i + 1 == items.size() ? " and " : ", ") + items[i];
  return text;
}

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
  const std::size_t best = paper_ranking().front();
  const std::string name(variants[best].paper_name);
  std::vector<std::string> items;
  for (const Family& family : families) {
    if (family.ranking.empty()) continue;
    const double ratio = family.over_global.at(best).value;
    items.push_back(write(ratio, ratio_digits(ratio)) + " times with " + family.name);
  }
  if (items.empty()) return {};
  return name + ", the paper's fastest variant, is " + published_speed_up().text("mean", name) +
         " times as fast as its global reference with MA27; here " + enumeration(items) + ".";
}

// Whether the verdicts depend on the solver, and whether they are the paper's.
std::string summary_sentence(const std::vector<std::vector<std::string>>& verdicts_by_family,
                             const std::vector<std::string>& judged) {
  if (verdicts_by_family.empty()) return {};
  const auto& first = verdicts_by_family.front();
  if (std::any_of(verdicts_by_family.begin(), verdicts_by_family.end(),
                  [&](const auto& verdicts) { return verdicts != first; }))
    return "The choice of the sparse solver changes the conclusion.";
  const bool one = judged.size() == 1;
  const std::string solvers = one ? judged.front() + ", the one sparse solver that can be judged"
                                  : "every sparse solver that can be judged";
  if (std::all_of(first.begin(), first.end(),
                  [](const std::string& verdict) { return verdict == "holds"; }))
    return "The paper's conclusion holds with " + solvers + ".";
  return "With " + solvers +
         (one ? ", the verdict is not the paper's in every point."
              : " the verdict is the same, and it is not the paper's in every point.");
}

}  // namespace

Section conclusion(const Record& record) {
  Section section{.title = "What the choice of the sparse solver does to the paper's conclusion",
                  .paragraphs = {},
                  .tables = {}};
  Table table{.name = "conclusion",
              .title = "The paper's conclusions by sparse solver, truck suspension",
              .notes = {"Mean speed-ups over the paper's sizes; a comparison counts when the "
                        "interval from the spread of the repetitions excludes 1."},
              .columns = {{"conclusion of the paper", {}}},
              .rows = {}};
  if (const Sources source = sources(record); !source.ratio_warning.empty())
    table.notes.push_back(source.ratio_warning);
  std::vector<Family> families;
  for (const std::string_view name : recorded_families(record)) {
    families.push_back(judge(record, name));
    table.columns.push_back({std::string(name), {}});
  }

  section.paragraphs.push_back(paper_sentence());
  if (families.empty()) {
    section.paragraphs.push_back("Nothing can be said: the record has no cell of a sparse solver.");
    return section;
  }

  std::vector<std::vector<std::string>> by_family(families.size());
  std::vector<std::string> sentences;
  const auto add_row = [&](const std::string& subject, auto verdict_of) {
    std::vector<Entry> row{text_entry(subject)};
    std::vector<std::pair<std::string, std::string>> verdicts;
    for (const Family& family : families) {
      verdicts.emplace_back(family.name, verdict_of(family));
      row.push_back(text_entry(verdicts.back().second));
    }
    table.rows.push_back(std::move(row));
    sentences.push_back(by_verdict(verdicts));
    return verdicts;
  };
  std::string claim_text;
  for (const Claim& claim : claims()) {
    const auto verdicts =
        add_row(claim.text, [&](const Family& family) { return verdict(record, family, claim); });
    for (std::size_t i = 0; i < verdicts.size(); ++i) by_family[i].push_back(verdicts[i].second);
    claim_text += " That " + claim.text + " " + sentences.back() + ".";
  }
  add_row("ranking of the four variants",
          [&](const Family& family) { return ranking_verdict(record, family); });
  claim_text += " The ranking of the four variants " + sentences.back() + ".";

  for (std::size_t i = families.size(); i-- > 0;)  // what cannot be judged has no say
    if (families[i].ranking.empty()) by_family.erase(by_family.begin() + i);
  std::vector<std::string> judged;
  for (const Family& family : families)
    if (!family.ranking.empty()) judged.push_back(family.name);

  for (const Family& family : families) section.paragraphs.push_back(family_sentence(family));
  std::string last = summary_sentence(by_family, judged);
  if (const std::string best = best_sentence(families); !best.empty()) last += " " + best;
  last += claim_text;
  section.paragraphs.push_back(last.substr(last.find_first_not_of(' ')));
  section.tables.push_back(std::move(table));
  return section;
}

}  // namespace desmo::report
