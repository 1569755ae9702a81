#include "tests/report/sample.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "report/read/record.h"
#include "report/read/record_file.h"

namespace desmo::report {

std::filesystem::path data_file(const std::string& name) {
  return std::filesystem::path(DESMO_REPORT_DATA) / name;
}

std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error("no file " + file.string());
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

Json complete_record() { return Json::parse(read_text(data_file("complete.json"))); }

Json with_windows(Json record, int windows) {
  record["record"]["settings"]["windows"] = windows;
  for (const char* list : {"cells", "requests", "peers"}) {
    if (!record["paper"].contains(list)) continue;
    for (Json& timed : record["paper"][list]) {
      if (!timed.contains("time")) continue;
      const auto samples = timed["time"]["seconds"].get<std::vector<double>>();
      const double least = *std::ranges::min_element(samples);
      Json each = Json::array();
      for (int i = 1; i <= windows; ++i) each.push_back(least * 2 * i / (windows * (windows + 1)));
      timed["time"]["windows"] = {{"least", each}};
    }
  }
  return record;
}

Json with_samples_of_windows(Json record, int count) {
  record = with_windows(std::move(record), count);
  for (const char* list : {"cells", "requests"}) {
    if (!record["paper"].contains(list)) continue;
    for (Json& timed : record["paper"][list]) {
      if (!timed.contains("time")) continue;
      const auto samples = timed["time"]["seconds"].get<std::vector<double>>();
      const double least = *std::ranges::min_element(samples);
      Json updates = Json::array(), of_all = Json::array();
      for (int i = 1; i <= count; ++i) updates.push_back(1000 * i);
      for (const double sample : samples) {
        Json of_one = Json::array();
        for (const double seconds : timed["time"]["windows"]["least"])
          of_one.push_back(sample == least ? seconds : seconds * (sample / least));
        of_all.push_back(std::move(of_one));
      }
      timed["time"]["windows"] = {{"updates", updates}, {"samples", of_all}};
    }
  }
  return record;
}

Json structured_record() { return Json::parse(read_text(data_file("structured.json"))); }

namespace {

std::size_t position(const Json& record, const std::string& case_name, int coordinates,
                     const std::string& id) {
  const Json& candidates = record["paper"]["cells"];
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (candidates[i]["case"] == case_name && candidates[i]["coordinates"] == coordinates &&
        candidates[i]["id"] == id)
      return i;
  throw std::runtime_error("no cell " + case_name + "/" + std::to_string(coordinates) + "/" + id);
}

}  // namespace

Json& candidate_of(Json& record, const std::string& case_name, int coordinates,
                   const std::string& id) {
  return record["paper"]["cells"][position(record, case_name, coordinates, id)];
}

void erase_candidate(Json& record, const std::string& case_name, int coordinates,
                     const std::string& id) {
  record["paper"]["cells"].erase(position(record, case_name, coordinates, id));
}

void fail_candidate(Json& record, const std::string& case_name, int coordinates,
                    const std::string& id) {
  Json& candidate = candidate_of(record, case_name, coordinates, id);
  candidate["status"] = "failed";
  candidate["message"] = "wrong by design";
}

void erase_family(Json& record, const std::string& family) {
  Json kept = Json::array();
  for (const Json& candidate : record["paper"]["cells"]) {
    const std::string id = candidate["id"];
    if (!id.substr(0, id.find('/')).ends_with("_" + family)) kept.push_back(candidate);
  }
  record["paper"]["cells"] = kept;
}

void set_motion(Json& record, double duration, double step) {
  Json& settings = record["record"]["settings"];
  settings["duration_seconds"] = duration;
  settings["step_seconds"] = step;
  settings["instants"] = std::lround(duration / step) + 1;
}

void set_samples(Json& record, int coordinates, const std::string& id,
                 std::vector<double> samples) {
  candidate_of(record, "truck_suspension", coordinates, id)["time"]["seconds"] = std::move(samples);
}

void set_family(Json& json, const std::string& id, double seconds, double spread) {
  for (const int size : {114, 225, 336, 447, 558})
    set_samples(json, size, id, {seconds * (1 + spread), seconds, seconds * (1 - spread)});
}

Record record_from(const Json& json) { return parse_record(json.dump()); }

std::string complaint(const std::string& text) {
  try {
    parse_record(text);
  } catch (const InputError& error) {
    return std::string(error.what()).substr(std::string("record: ").size());
  }
  return "accepted";
}

std::string complaint(const Json& json) { return complaint(json.dump()); }

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

const Table& table_named(const Document& document, const std::string& name) {
  for (const Section& section : document.sections)
    for (const Table& table : section.tables)
      if (table.name == name) return table;
  throw std::runtime_error("no table " + name);
}

}  // namespace desmo::report
