#include "bench/experiments/promise/tally.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>
#include <utility>

#include "bench/kit/problem.h"
#include "bench/kit/record/record.h"
#include "cases/mechanism/formatted.h"

namespace desmo::promise {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t printed = 20;  // of the worst scenes

Json finding_json(const SceneResult::Finding& f) {
  const RunVerdict& j = f.details;
  const auto rounded = [](double x) { return bench::rounded(x, 3); };
  return {{"id", f.id},
          {"what", j.what},
          {"level", static_cast<int>(j.level)},
          {"error", rounded(j.error)},
          {"allowed", rounded(j.allowed)},
          {"time", j.time},
          {"condition", rounded(j.condition)}};
}

std::optional<SceneResult::Finding> finding(const Json& j, const char* name,
                                            PromiseVerdict verdict) {
  if (!j.contains(name)) return std::nullopt;
  const Json& f = j[name];
  return SceneResult::Finding{f["id"],
                              {verdict, f["what"], static_cast<Level>(f["level"].get<int>()),
                               f["error"], f["allowed"], f["time"], f["condition"]}};
}

/// Of wrong numbers the one with the largest error over what is allowed.
bool is_worse(const RunVerdict& a, const RunVerdict& b) {
  return a.error * std::max(b.allowed, 1e-300) > b.error * std::max(a.allowed, 1e-300);
}

char letter_of(PromiseVerdict verdict) {
  return verdict_letters[static_cast<std::size_t>(verdict)].second;
}

long count(const SceneResult& r, PromiseVerdict verdict) {
  return std::ranges::count(r.verdicts, letter_of(verdict));
}

void add(Counts& counts, char letter) {
  const auto row =
      std::ranges::find(verdict_letters, letter, &std::pair<PromiseVerdict, char>::second);
  ++counts.at(row - verdict_letters.begin());
}

void print_counts(std::ostream& out, const std::string& name, const Counts& c) {
  out << formatted("%-46s %8ld %8ld %8ld %8ld %8ld %8ld\n", name.c_str(), c[0], c[1], c[2], c[3],
                   c[4], c[5]);
}

void print_finding(std::ostream& out, const char* title, const SceneResult::Finding& f) {
  const RunVerdict& j = f.details;
  out << formatted("    %s %s: %s, %s: %.2e, allowed %.2e, t = %.17g s, condition %.1e\n", title,
                   f.id.c_str(), j.what.c_str(), bench::level_names[j.level], j.error, j.allowed,
                   j.time, j.condition);
}

}  // namespace

SceneResult run_scene(std::uint64_t seed, int number, const std::vector<std::string>& ids) {
  SceneResult r{.number = number};
  std::optional<DrawnScene> scene;
  try {
    scene = draw_scene(seed, number);
  } catch (const std::exception& error) {
    r.failure = error.what();
    return r;
  }
  r.family = scene->family;
  r.aim = scene->aim;
  for (const std::string& id : ids) {
    const RunVerdict j = verdict_on_id(*scene, id);
    r.verdicts += letter_of(j.verdict);
    if (j.verdict == PromiseVerdict::wrong && (!r.wrong || is_worse(j, r.wrong->details)))
      r.wrong = {id, j};
    const bool is_flag =
        j.verdict == PromiseVerdict::false_flag || j.verdict == PromiseVerdict::false_failure;
    if (is_flag && !r.flag) r.flag = {id, j};
  }
  return r;
}

Json to_json(const SceneResult& r) {
  Json j = {{"scene", r.number}};
  if (!r.failure.empty()) j["failure"] = r.failure;
  j["family"] = r.family;
  j["aim"] = r.aim;
  j["verdicts"] = r.verdicts;
  if (r.wrong) j["wrong"] = finding_json(*r.wrong);
  if (r.flag) j["flag"] = finding_json(*r.flag);
  return j;
}

SceneResult from_json(const Json& j) {
  SceneResult r;
  r.number = j["scene"];
  r.failure = j.value("failure", "");
  r.family = j["family"];
  r.aim = j["aim"];
  r.verdicts = j["verdicts"];
  r.wrong = finding(j, "wrong", PromiseVerdict::wrong);
  r.flag = finding(j, "flag", PromiseVerdict::false_flag);
  return r;
}

Tally tally(const std::vector<SceneResult>& results, const std::vector<std::string>& ids) {
  Tally t;
  for (const SceneResult& r : results) {
    ++t.scenes;
    if (!r.failure.empty()) ++t.not_drawn;
    for (std::size_t i = 0; i < r.verdicts.size(); ++i)
      for (Counts* counts : {&t.all, &t.by_family[r.family],
                             &t.by_aim[r.aim.substr(0, r.aim.find(' '))], &t.by_id[ids[i]]})
        add(*counts, r.verdicts[i]);
  }
  return t;
}

std::vector<SceneResult> worst(std::vector<SceneResult> results, std::size_t count_wanted) {
  std::erase_if(results, [](const SceneResult& r) { return !r.wrong && !r.flag; });
  std::ranges::stable_sort(results, [](const SceneResult& a, const SceneResult& b) {
    const auto rank = [](const SceneResult& r) {
      return std::pair(
          count(r, PromiseVerdict::wrong),
          count(r, PromiseVerdict::false_flag) + count(r, PromiseVerdict::false_failure));
    };
    return rank(a) > rank(b);
  });
  results.resize(std::min(results.size(), count_wanted));
  return results;
}

Json record_lists(const std::vector<SceneResult>& results, const std::vector<std::string>& ids) {
  const Tally t = tally(results, ids);
  Json verdicts = Json::array({{{"of", "all"}, {"name", "all"}, {"runs", t.all}}});
  const auto add_all = [&](const char* of, const std::map<std::string, Counts>& part) {
    for (const auto& [name, counts] : part)
      verdicts.push_back({{"of", of}, {"name", name}, {"runs", counts}});
  };
  add_all("family", t.by_family);
  add_all("aim", t.by_aim);
  add_all("id", t.by_id);
  Json findings = Json::array();
  for (const SceneResult& r : worst(results, printed)) findings.push_back(to_json(r));
  return {{"verdicts", std::move(verdicts)}, {"findings", std::move(findings)}};
}

void print(std::ostream& out, const std::vector<SceneResult>& results,
           const std::vector<std::string>& ids, std::uint64_t seed) {
  const Tally t = tally(results, ids);
  out << formatted("%-46s %8s %8s %8s %8s %8s %8s\n", "", "right", "flagged", "falsely", "failed",
                   "WRONG", "n/a");
  print_counts(out, "all", t.all);
  for (const auto* part : {&t.by_family, &t.by_aim, &t.by_id}) {
    out << '\n';
    for (const auto& [name, counts] : *part) print_counts(out, name, counts);
  }
  out << '\n' << t.scenes << " scenes, " << t.not_drawn << " not drawn. The worst:\n";
  for (const SceneResult& r : worst(results, printed)) {
    out << "\nscene " << r.number << ": " << r.family << ", " << r.aim << ": "
        << count(r, PromiseVerdict::wrong) << " wrong, " << count(r, PromiseVerdict::false_flag)
        << " flagged and " << count(r, PromiseVerdict::false_failure)
        << " failed without a cause\n";
    if (r.wrong) print_finding(out, "wrong", *r.wrong);
    if (r.flag) print_finding(out, "flag", *r.flag);
    const std::string file = "scene" + std::to_string(r.number) + ".json";
    out << "    desmo_bench promise --seed " << seed << " --write-scene " << r.number << " > "
        << file << " && desmo solve " << file << " -o out.csv --formulation "
        << (r.wrong ? r.wrong : r.flag)->id << '\n';
  }
}

}  // namespace desmo::promise
