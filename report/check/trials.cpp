// Trials of bench/check --certify, and what they show of the check itself.
#include "report/check/trials.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cases/io/new_files.h"
#include "report/check/check_outcome.h"
#include "report/read/record_file.h"
#include "report/tables/entries.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* schema = "desmo-certificate";

std::vector<std::string> read_candidates(const RecordValue& line, const char* key) {
  const auto list = line.find(key);
  return list ? list->list(&RecordValue::text) : std::vector<std::string>();
}

TrialsHead read_head(const RecordValue& line) {
  check_schema(line, schema);
  return {line["date"].utc(), line["cpu"].text(), line["compiler"].text(), line["flags"].text(),
          line["cores"].integer(1)};
}

Trial read_trial(const RecordValue& line) {
  const RecordValue trial = line["trial"];
  return {trial["kind"].text(),
          trial["load"].text(),
          trial["cell"].text(),
          line["verdict"].text(),
          read_candidates(line, "slower"),
          read_candidates(line, "faster"),
          read_candidates(line, "more_work")};
}

template <class Findings>
void add_candidates(Json& line, const char* key, const Findings& findings, Finding outcome) {
  for (const auto& finding : findings)
    if (finding.outcome == outcome) line[key].push_back(finding.candidate);
}

Json head_line(const Record& head) {
  return {{"schema", schema},
          {"schema_version", schema_version},
          {"date", head.date},
          {"cpu", head.machine.cpu},
          {"cores", head.machine.cores},
          {"compiler", head.build.compiler},
          {"flags", head.build.flags}};
}

Json read_what(const RecordValue& trial) {
  return {{"kind", trial["kind"].text()},
          {"load", trial["load"].text()},
          {"number", trial["number"].integer(1)},
          {"cell", trial["cell"].text()}};
}

Json trial_line(const Json& what, const CheckOutcome& found) {
  Json line{{"trial", what}, {"verdict", verdict_names[static_cast<std::size_t>(found.verdict)]}};
  add_candidates(line, "slower", found.time.candidates, Finding::regression);
  add_candidates(line, "faster", found.time.candidates, Finding::improvement);
  add_candidates(line, "more_work", found.work.candidates, Finding::regression);
  return line;
}

}  // namespace

Trials read_trials(const std::string& text, const std::string& file) {
  Trials trials;
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == line.npos) continue;  // as JSON Lines are read elsewhere
    const JsonDocument document(line, file + ": line " + std::to_string(number));
    const RecordValue root(document.root());
    if (trials.head)
      trials.all.push_back(read_trial(root));
    else
      trials.head = read_head(root);
  }
  return trials;
}

void add_trial(const std::filesystem::path& certificate, const std::filesystem::path& trial) {
  const JsonDocument document(read_record_text(trial), trial.string());
  const RecordValue root(document.root());
  const Json what = read_what(root["trial"]);
  const CheckRecord check = read_check(root["check"]);
  std::optional<TrialsHead> head;
  if (std::filesystem::exists(certificate))
    head = read_trials(read_record_text(certificate), certificate.string()).head;
  if (head && (head->cpu != check.head.machine.cpu || head->compiler != check.head.build.compiler ||
               head->flags != check.head.build.flags))
    throw MixedRecord("trials of different machines or compilers do not make one certificate");
  std::string text = head ? "" : head_line(check.head).dump() + "\n";
  text += trial_line(what, compare_sides(check)).dump() + "\n";
  std::ofstream out(certificate, std::ios::app);
  out << text << std::flush;
  if (!out) throw OutputError(certificate.string() + " cannot be written");
}

namespace {

/// What a trial has to show: no alarm, or that what was done to its candidate is found and named.
enum class Shows { no_alarm, slower, more_work, faster };

/// Trials of a kind and load, how many there must be, and how many may not show it.
struct Claim {
  const char* kind;
  const char* load;
  const char* title;
  Shows shows;
  int trials, misses;
};

constexpr std::array claims{
    Claim{"unchanged", "idle", "unchanged tree", Shows::no_alarm, 30, 0},
    Claim{"unchanged", "loaded", "unchanged tree", Shows::no_alarm, 30, 0},
    Claim{"relinked", "idle", "unchanged tree, linked in another order", Shows::no_alarm, 6, 0},
    Claim{"relinked", "loaded", "unchanged tree, linked in another order", Shows::no_alarm, 6, 0},
    Claim{"aligned", "idle", "unchanged tree, code aligned otherwise", Shows::no_alarm, 6, 0},
    Claim{"aligned", "loaded", "unchanged tree, code aligned otherwise", Shows::no_alarm, 6, 0},
    Claim{"slower", "idle", "10 % more work in a cell, by Time", Shows::slower, 60, 1},
    Claim{"slower", "loaded", "10 % more work in a cell, by Time", Shows::slower, 60, 1},
    Claim{"more_work", "idle", "5 % more work in a cell, by Work", Shows::more_work, 60, 0},
    Claim{"faster", "idle", "10 % less work in a cell", Shows::faster, 6, 0},
    Claim{"faster", "loaded", "10 % less work in a cell", Shows::faster, 6, 0},
};

struct Tally {
  int trials = 0, shown = 0, inconclusive = 0;
};

bool is_only(const std::vector<std::string>& candidates, const std::string& candidate) {
  return candidates.size() == 1 && candidates.front() == candidate;
}

bool is_shown(Shows shows, const Trial& t) {
  const bool regression = t.verdict == "regression", pass = t.verdict == "pass";
  switch (shows) {
    case Shows::no_alarm:
      return pass || t.verdict == "inconclusive";
    case Shows::slower:
      return regression && is_only(t.slower, t.candidate);
    case Shows::more_work:
      return regression && is_only(t.more_work, t.candidate);
    case Shows::faster:
      return pass && is_only(t.faster, t.candidate);
  }
  return false;
}

using Tallies = std::array<Tally, claims.size()>;

Tallies tallied(const std::vector<Trial>& trials, const std::string& file) {
  Tallies tallies{};
  for (const Trial& trial : trials) {
    const auto claim = std::ranges::find_if(
        claims, [&](const Claim& c) { return trial.kind == c.kind && trial.load == c.load; });
    if (claim == claims.end())
      throw InputError(file + ": no such trial: " + trial.kind + ", " + trial.load);
    Tally& tally = tallies[static_cast<std::size_t>(claim - claims.begin())];
    ++tally.trials;
    tally.shown += is_shown(claim->shows, trial);
    tally.inconclusive += trial.verdict == "inconclusive";
  }
  return tallies;
}

}  // namespace

CheckCertificate read_certificate(const std::filesystem::path& file) {
  const Trials trials = read_trials(read_record_text(file), file.string());
  const Tallies tallies = tallied(trials.all, file.string());
  CheckCertificate certificate{true, false, {}};
  Table table = headed_table("certificate");
  for (std::size_t i = 0; i < claims.size(); ++i) {
    const Claim& c = claims[i];
    const Tally& t = tallies[i];
    const bool refuted = t.trials - t.shown > c.misses, enough = t.trials >= c.trials;
    certificate.refuted = certificate.refuted || refuted;
    certificate.holds = certificate.holds && enough && !refuted;
    const std::string state = sentence(refuted  ? "certificate.state_refuted"
                                       : enough ? "certificate.state_holds"
                                                : "certificate.state_incomplete");
    std::vector<Entry> row{c.title, c.load};
    for (const int count : {c.trials, t.trials, t.shown, t.inconclusive})
      row.push_back(digits_entry(std::to_string(count)));
    row.push_back(sentence(c.misses == 0 ? "certificate.every_one" : "certificate.all_but",
                           {{"misses", c.misses}, {"state", state}}));
    table.rows.push_back(std::move(row));
  }
  Section section{sentence(certificate.holds     ? "certificate.holds"
                           : certificate.refuted ? "certificate.refuted"
                                                 : "certificate.incomplete"),
                  {},
                  {std::move(table)}};
  if (const auto& head = trials.head)
    section.paragraphs.push_back(sentence("certificate.machine", {{"date", head->date},
                                                                  {"cpu", head->cpu},
                                                                  {"cores", head->cores},
                                                                  {"compiler", head->compiler}}));
  certificate.document = {sentence("certificate.document"), {std::move(section)}};
  return certificate;
}

}  // namespace desmo::report
