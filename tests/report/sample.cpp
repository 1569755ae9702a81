#include "tests/report/sample.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "cases/io/text_file.h"

namespace desmo::report {

std::filesystem::path data_file(const std::string& name) {
  return std::filesystem::path(DESMO_REPORT_DATA) / name;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != text.npos; at += part.size()) ++found;
  return found;
}

bool says(const std::vector<std::string>& texts, const std::string& part) {
  return std::ranges::any_of(
      texts, [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

Json complete_record() { return Json::parse(read_text(data_file("complete.json"))); }
Json requests_record() { return Json::parse(read_text(data_file("requests.json"))); }
Json origins_record() { return in_known_schema(Json::parse(read_text(data_file(origins)))); }

Json in_known_schema(Json record) {
  record["schema_version"] = schema_version;
  record["paper"]["candidates"] = record["paper"]["cells"];
  record["paper"].erase("cells");
  return record;
}

std::string later_version(int major, int minor, int patch) {
  std::istringstream known(schema_version);
  std::string version;
  for (const int added : {major, minor, patch}) {
    int number = 0;
    known >> number;
    known.ignore();
    version += (version.empty() ? "" : ".") + std::to_string(number + added);
  }
  return version;
}

std::string versions_read() {
  const int major = std::stoi(schema_version);
  return std::to_string(major - 1) + ".x and " + std::to_string(major) + ".x";
}

Json levels(double position, double velocity, double acceleration) {
  return {{"position", position}, {"velocity", velocity}, {"acceleration", acceleration}};
}

Json step_time(double microseconds) {
  return {{"clock", "cpu"},
          {"seconds", {1.5e-6 * microseconds, 1e-6 * microseconds, 1.02e-6 * microseconds}}};
}

Json empty_record() {
  Json record = requests_record();
  record.erase("paper");
  return record;
}

Json changed(Json record, const std::string& place, const Json& value) {
  if (value.is_discarded())
    return record.patch(Json::array({Json{{"op", "remove"}, {"path", place}}}));
  record[Json::json_pointer(place)] = value;
  return record;
}

namespace {

/// Calls `change` with the time of everything in the paper's experiment that has one.
template <class Change>
void for_each_time(Json& record, const Change& change) {
  for (const char* list : {"candidates", "requests", "peers"})
    if (record["paper"].contains(list))
      for (Json& timed : record["paper"][list])
        if (timed.contains("time")) change(timed["time"]);
}

/// Divides a time into windows of increasing length.
std::vector<double> divided(double seconds, int windows) {
  std::vector<double> each;
  for (int i = 1; i <= windows; ++i) each.push_back(seconds * 2 * i / (windows * (windows + 1)));
  return each;
}

}  // namespace

Json with_windows(Json record, int windows) {
  record["record"]["settings"]["windows"] = windows;
  for_each_time(record, [&](Json& time) {
    const std::vector<double> samples = time["seconds"];
    time["windows"] = {{"least", divided(std::ranges::min(samples), windows)}};
  });
  return record;
}

Json with_samples_of_windows(Json record, int windows) {
  record["record"]["settings"]["windows"] = windows;
  for_each_time(record, [&](Json& time) {
    Json updates = Json::array(), samples = Json::array();
    for (int i = 1; i <= windows; ++i) updates.push_back(1000 * i);
    for (const double sample : time["seconds"]) samples.push_back(divided(sample, windows));
    time["windows"] = {{"updates", updates}, {"samples", samples}};
  });
  return record;
}

void keep_samples(Json& record, std::size_t repetitions) {
  for_each_time(record, [&](Json& time) {
    std::vector<double> seconds = time["seconds"];
    seconds.resize(std::min(seconds.size(), repetitions));
    time["seconds"] = seconds;
  });
}

Json& element_with(Json& list, const Json& members) {
  for (Json& element : list) {
    Json with_members = element;
    with_members.update(members);
    if (with_members == element) return element;
  }
  throw std::runtime_error("nothing has " + members.dump());
}

Json& candidate_of(Json& record, int coordinates, const std::string& id) {
  return element_with(record["paper"]["candidates"],
                      {{"case", truck}, {"coordinates", coordinates}, {"id", id}});
}

void erase_candidate(Json& record, int coordinates, const std::string& id) {
  const Json& erased = candidate_of(record, coordinates, id);
  Json& candidates = record["paper"]["candidates"];
  candidates.erase(static_cast<std::size_t>(&erased - &candidates.front()));
}

void fail(Json& measurement) {
  measurement["status"] = "failed";
  measurement["message"] = "wrong by design";
}

void fail_candidate(Json& record, int coordinates, const std::string& id) {
  fail(candidate_of(record, coordinates, id));
}

void erase_family(Json& record, const std::string& family) {
  Json kept = Json::array();
  for (const Json& candidate : record["paper"]["candidates"]) {
    const std::string id = candidate["id"];
    if (!id.substr(0, id.find('/')).ends_with("_" + family)) kept.push_back(candidate);
  }
  record["paper"]["candidates"] = kept;
}

void set_motion(Json& record, double duration, double step) {
  Json& settings = record["record"]["settings"];
  settings["duration_seconds"] = duration;
  settings["step_seconds"] = step;
  settings["instants"] = std::lround(duration / step) + 1;
}

void set_samples(Json& record, int coordinates, const std::string& id,
                 std::vector<double> samples) {
  candidate_of(record, coordinates, id)["time"]["seconds"] = std::move(samples);
}

void set_family(Json& json, const std::string& id, double seconds, double spread) {
  for (const int size : {114, 225, 336, 447, 558})
    set_samples(json, size, id, {seconds * (1 + spread), seconds, seconds * (1 - spread)});
}

Record record_from(const Json& json) { return parse_record(json.dump()); }

std::string complaint(const Json& json) {
  const std::string said = refusal<InputError>([&] { record_from(json); }), file = "record: ";
  return said.starts_with(file) ? said.substr(file.size()) : said;
}

void expect_refusals(const Json& record, const std::vector<Refusal>& refusals) {
  EXPECT_EQ(complaint(record), "accepted");
  for (const auto& [place, value, message] : refusals)
    EXPECT_CONTAINS(complaint(changed(record, place, value)),
                    message.starts_with(":") ? place + message : message);
}

Entry entry_at(const Table& table, const std::vector<std::string>& labels,
               const std::string& column) {
  for (const auto& row : table.rows) {
    bool found = true;
    for (std::size_t i = 0; i < labels.size(); ++i) found = found && row[i].shown == labels[i];
    for (std::size_t i = 0; found && i < row.size(); ++i)
      if (table.columns[i].name == column) return row[i];
  }
  throw std::runtime_error("table " + table.name + " has no such place in column " + column);
}

void expect_row(const Table& table, const std::vector<std::string>& labels,
                const std::vector<std::pair<std::string, std::string>>& entries) {
  const std::string any = " …";
  for (const auto& [column, text] : entries) {
    std::string shown = entry_at(table, labels, column).shown;
    if (text.ends_with(any)) shown = shown.substr(0, shown.find(' ')) + any;
    EXPECT_EQ(shown, text) << column;
  }
}

const Table& table_named(const Document& document, const std::string& name) {
  for (const Table& table : tables_of(document))
    if (table.name == name) return table;
  throw std::runtime_error("no table " + name);
}

Table table_of(const Json& record, const std::string& name) {
  return table_named(make_report(record_from(record)), name);
}

}  // namespace desmo::report
