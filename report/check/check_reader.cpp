#include <algorithm>

#include "report/check/check_record.h"
#include "report/read/readers.h"
#include "report/read/record_file.h"

namespace desmo::report {
namespace {

Rounds read_rounds(const RecordValue& node) {
  Rounds rounds{read_samples(node["base"]), read_samples(node["head"])};
  if (rounds.base.size() != rounds.head.size())
    node.complain("base and head differ in their number of rounds");
  return rounds;
}

Work read_work(const RecordValue& node, bool two_sides) {
  Work work{node["tool"].text(), node["steps"].integer(1), node["iterations"].integer(1), {}};
  for (const RecordValue sides : node["instructions"].members()) {
    Instructions& counts = work.instructions[std::string(sides.key())];
    counts.head = sides["head"].count();
    if (two_sides) counts.base = sides["base"].count();
  }
  return work;
}

// Checks that both sides have the same candidates, and that a candidate that is timed on both sides
// has as many rounds in base as in head.
void check_pairs(const CheckRecord& check, const RecordValue& root) {
  for (const auto& [key, head] : check.head.candidates) {
    const auto base = check.base->candidates.find(key);
    if (base == check.base->candidates.end())
      root["base"].complain("the candidate " + name_of(key) + " of head is missing");
    if (base->second.status == Status::ok && head.status == Status::ok &&
        base->second.time.seconds.size() != head.time.seconds.size())
      root["head"].complain("the candidate " + name_of(key) +
                            " has another number of rounds in base");
  }
  for (const auto& [key, base] : check.base->candidates)
    if (!check.head.candidates.contains(key))
      root["head"].complain("the candidate " + name_of(key) + " of base is missing");
}

// Returns whether a candidate's answers are right, whether it was timed or not.
bool is_sound(const Measurement& candidate) {
  return candidate.status != Status::failed && candidate.verification;
}

// Refuses a candidate of head that is neither wrong nor verified. Where a candidate is sound on all
// sides, refuses missing times in a check with times, and missing counts in a check with counts.
void check_complete(const CheckRecord& check, const RecordValue& root) {
  const RecordValue head = root["head"];
  const bool timed = root.find(control_name).has_value();
  if (check.head.candidates.empty())
    head["paper"]["candidates"].complain("at least one candidate is needed");
  if (!timed && !check.work) root.complain("nothing was measured: neither times nor work");
  for (const auto& [key, candidate] : check.head.candidates) {
    const std::string name = name_of(key);
    if (candidate.status == Status::failed) continue;
    if (!is_sound(candidate))
      head.complain("the candidate " + name + " was not run: " + candidate.message);
    if (check.base && !is_sound(check.base->candidates.at(key))) continue;
    if (timed && candidate.status != Status::ok)
      head.complain("the candidate " + name + " has no times: " + candidate.message);
    if (check.work && !check.work->instructions.contains(name))
      root["work"]["instructions"].complain("the candidate " + name + " is missing");
  }
}

CheckRecord read_root(const RecordValue& root) {
  check_schema(root, "desmo-check");
  CheckRecord check;
  check.head = read_record(root["head"]);
  if (const auto base = root.find("base")) check.base = read_record(*base);
  const bool two_sides = check.base.has_value();
  if (two_sides) check_pairs(check, root);
  if (has_times(check.head)) check.control = read_rounds(root[control_name]);
  if (const auto second = root.find("second"))
    for (const RecordValue rounds : second->members())
      check.second.emplace(rounds.key(), read_rounds(rounds));
  if (!check.second.empty() && !check.second.contains(control_name))
    root["second"].complain("the control is missing");
  if (const auto work = root.find("work")) check.work = read_work(*work, two_sides);
  check_complete(check, root);
  check.slowed = root["settings"].maybe("slowed", &RecordValue::text).value_or("");
  return check;
}

}  // namespace

bool has_times(const Record& side) {
  return std::ranges::any_of(
      side.candidates, [](const auto& candidate) { return candidate.second.status == Status::ok; });
}

CheckRecord parse_check(std::string_view text, const std::string& file) {
  return read_document(text, file, read_root);
}

CheckRecord read_check(const std::filesystem::path& file) {
  return parse_check(read_record_text(file), file.string());
}

}  // namespace desmo::report
