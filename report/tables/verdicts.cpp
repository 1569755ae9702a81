#include "report/tables/verdicts.h"

#include <algorithm>
#include <set>

#include "report/digits.h"
#include "report/measurements.h"
#include "report/paper.h"
#include "report/variants.h"

namespace desmo::report {
namespace {

enum class Order { faster, slower, within_spread };

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

// How `variant` stands to `reference`; the spread of the repetitions must not reach equality.
Order order(const Record& record, const Family& family, std::size_t reference,
            std::size_t variant) {
  const SpeedUp ratio =
      *mean_speed_up(record, family.name, reference, variant, family.sizes).speed_up;
  if (ratio.low > 1) return Order::faster;
  if (ratio.high < 1) return Order::slower;
  return Order::within_spread;
}

/// On all claims.
std::vector<std::string> verdicts(const Record& record, const Family& family) {
  std::vector<std::string> all;
  for (const Claim& claim : claims()) all.push_back(verdict(record, family, claim));
  return all;
}

}  // namespace

const std::vector<Claim>& claims() {
  static const std::vector<Claim> all{
      {"solving by groups beats solving globally",
       {{truck_global, 3}, {truck_global, 4}, {truck_global, 5}, {truck_global, 6}}},
      {"symbolic equations beat automatic ones", {{3, 5}, {4, 6}}},
      {"in the groups, LAPACK beats the sparse solver", {{3, 4}, {5, 6}}}};
  return all;
}

std::vector<Family> judged_families(const Record& record) {
  std::vector<Family> families;
  for (const std::string_view name : recorded_families(record))
    families.push_back(judge(record, name));
  return families;
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

Agreement agreement(const Record& record, const std::vector<Family>& families) {
  std::set<std::vector<std::string>> found;
  for (const Family& family : families)
    if (!family.ranking.empty()) found.insert(verdicts(record, family));
  if (found.empty()) return Agreement::nothing_judged;
  if (found.size() > 1) return Agreement::depends_on_solver;
  const bool all_hold = std::all_of(found.begin()->begin(), found.begin()->end(),
                                    [](const std::string& text) { return text == "holds"; });
  return all_hold ? Agreement::as_the_paper : Agreement::not_as_the_paper;
}

std::string papers_own_verdict(const Record& record, const std::vector<Family>& families) {
  const auto own = std::ranges::find(families, papers_own, &Family::name);
  if (own == families.end() || own->ranking.empty()) return {};
  std::vector<std::string> same, other;
  for (const Family& family : families)
    if (family.name != papers_own && !family.ranking.empty())
      (verdicts(record, family) == verdicts(record, *own) ? same : other).push_back(family.name);
  const bool as_the_paper = agreement(record, {*own}) == Agreement::as_the_paper;
  std::string text = "With MA27, the paper's own solver, the verdict is " +
                     std::string(as_the_paper ? "the paper's" : "not the paper's in every point");
  if (!same.empty()) text += "; it is the same with " + enumeration(same);
  if (!other.empty()) text += "; it is another with " + enumeration(other);
  return text + ".";
}

std::string enumeration(const std::vector<std::string>& items) {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i)
    text += (i == 0 ? "" : i + 1 == items.size() ? " and " : ", ") + items[i];
  return text;
}

std::string best_by_family(const std::vector<Family>& families, const std::string& unit) {
  const std::size_t best = paper_ranking().front();
  std::vector<std::string> items;
  for (const Family& family : families) {
    if (family.ranking.empty()) continue;
    const double ratio = family.over_global.at(best).value;
    items.push_back(write(ratio, ratio_digits(ratio)) + unit + " with " + family.name +
                    (family.name == papers_own ? " (the paper's own)" : ""));
  }
  return enumeration(items);
}

}  // namespace desmo::report
