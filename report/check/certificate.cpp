#include "report/check/certificate.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "report/check/check_reader.h"
#include "report/check/judgement.h"
#include "report/json_document.h"
#include "report/json_node.h"

namespace desmo::report {
namespace {

/// What a trial has to show: no alarm, or that what was done to its cell is found and named.
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

/// The only cell with this outcome; empty when there are none or several.
template <class Findings>
std::string only(const Findings& findings, Outcome outcome) {
  const auto has = [outcome](const auto& f) { return f.outcome == outcome; };
  if (std::ranges::count_if(findings, has) != 1) return {};
  return std::ranges::find_if(findings, has)->cell;
}

bool is_shown(Shows shows, const Judgement& j, const std::string& cell) {
  switch (shows) {
    case Shows::no_alarm:
      return j.verdict == Verdict::pass || j.verdict == Verdict::inconclusive;
    case Shows::slower:
      return j.verdict == Verdict::regression && only(j.time.cells, Outcome::regression) == cell;
    case Shows::more_work:
      return j.verdict == Verdict::regression && only(j.work.cells, Outcome::regression) == cell;
    case Shows::faster:
      return j.verdict == Verdict::pass && only(j.time.cells, Outcome::gain) == cell;
  }
  return false;
}

class Trials {
 public:
  void add(const JsonNode& line) {
    const JsonNode trial = line["trial"];
    const std::string kind = trial["kind"].text(), load = trial["load"].text();
    const auto claim = std::ranges::find_if(
        claims, [&](const Claim& c) { return kind == c.kind && load == c.load; });
    if (claim == claims.end()) trial.complain("no such trial: " + kind + ", " + load);
    const CheckRecord check = read_check(line["check"]);
    require_same_machine(check.head);
    const Judgement judgement = judge(check);
    Tally& tally = tallies_[static_cast<std::size_t>(claim - claims.begin())];
    ++tally.trials;
    tally.shown += is_shown(claim->shows, judgement, trial.find_text("cell").value_or(""));
    tally.inconclusive += judgement.verdict == Verdict::inconclusive;
  }

  const std::optional<Record>& first() const { return first_; }
  const Tally& tally(std::size_t claim) const { return tallies_[claim]; }

 private:
  void require_same_machine(const Record& record) {
    if (!first_) first_ = record;
    if (first_->machine.cpu != record.machine.cpu ||
        first_->build.compiler != record.build.compiler ||
        first_->build.flags != record.build.flags)
      throw MixedRecord("trials of different machines or compilers do not make one certificate");
  }

  std::array<Tally, claims.size()> tallies_{};
  std::optional<Record> first_;
};

Trials read_trials(const std::string& text) {
  Trials trials;
  int number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string row = text.substr(begin, end - begin);
    begin = end + 1;
    ++number;
    if (row.find_first_not_of(" \t\r") == row.npos) continue;  // as JSON Lines are read elsewhere
    const auto named = [&](const InvalidRecord& error) {
      return "line " + std::to_string(number) + ": " + error.what();
    };
    try {
      const nlohmann::json line = parse_json(row);
      trials.add(JsonNode(line));
    } catch (const MixedRecord& error) {
      throw MixedRecord(named(error));
    } catch (const UnsupportedVersion& error) {
      throw UnsupportedVersion(named(error));
    } catch (const InvalidRecord& error) {
      throw InvalidRecord(named(error));
    }
  }
  return trials;
}

Entry number(int value) {
  const std::string text = std::to_string(value);
  return {text, {text}, {}};
}

}  // namespace

Certificate read_certificate(const std::filesystem::path& file) {
  const Trials trials = read_trials(read_whole(file));
  Certificate certificate{true, false, {}};
  Table table{.name = "certificate",
              .title = "What the trials show",
              .notes = {"A false alarm is an exit code 1; what was made slower or faster counts as "
                        "found when it, and nothing else, is named. Inconclusive trials are no "
                        "alarms; where something is to be found, they count as missed."},
              .columns = {{"trial", {}},
                          {"machine", {}},
                          {"needed", {"trials"}},
                          {"done", {"trials"}},
                          {"as claimed", {"trials"}},
                          {"inconclusive", {"trials"}},
                          {"claim", {}}},
              .rows = {}};
  for (std::size_t i = 0; i < claims.size(); ++i) {
    const Claim& c = claims[i];
    const Tally& t = trials.tally(i);
    const bool refuted = t.trials - t.shown > c.misses, enough = t.trials >= c.trials;
    certificate.refuted = certificate.refuted || refuted;
    certificate.holds = certificate.holds && enough && !refuted;
    const std::string claim = c.misses == 0 ? "every one" : "all but " + std::to_string(c.misses);
    table.rows.push_back({text_entry(c.title), text_entry(c.load), number(c.trials),
                          number(t.trials), number(t.shown), number(t.inconclusive),
                          text_entry(claim + (refuted  ? ": DOES NOT HOLD"
                                              : enough ? ": holds"
                                                       : ": trials are missing"))});
  }
  Section section{certificate.holds     ? "Every claim holds"
                  : certificate.refuted ? "A claim does not hold"
                                        : "Trials are missing",
                  {},
                  {std::move(table)}};
  if (const auto& first = trials.first())
    section.paragraphs.push_back("From " + first->date + " on, " + first->machine.cpu + ", " +
                                 std::to_string(first->machine.cores) + " cores, " +
                                 first->build.compiler + ".");
  certificate.document = {"Certificate of the regression check", {std::move(section)}};
  return certificate;
}

}  // namespace desmo::report
