#include "report/check/trials.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cases/io/new_files.h"
#include "report/check/check_outcome.h"

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

}  // namespace desmo::report
