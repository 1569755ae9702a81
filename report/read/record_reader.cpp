#include "report/read/record_reader.h"

#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "report/read/environment_reader.h"
#include "report/read/extremes_reader.h"
#include "report/read/json_document.h"
#include "report/read/json_node.h"
#include "report/read/one_origin.h"
#include "report/read/paper_reader.h"
#include "report/read/points_reader.h"
#include "report/read/timed_size_reader.h"
#include "report/read/tuning_reader.h"

namespace desmo::report {
namespace {

void read_accuracy(Record& record, const JsonNode& section) {
  read_points(record, section);
  read_tuning(record, section);
}

void read_instructions(Record& record, const JsonNode& section) {
  for (const JsonNode& node : section["counts"].elements()) {
    const CandidateKey key = read_key(node);
    const StepCount count{node["instructions_per_step"].integer(1), node["steps"].integer(1),
                          node["tool"].text()};
    if (!record.instructions.emplace(key, count).second)
      node.complain(name_of(key) + " is given twice");
  }
}

/// Each experiment has the section of its name.
constexpr std::array<std::pair<const char*, void (*)(Record&, const JsonNode&)>, 5> experiments{
    {{"paper", read_paper},
     {"accuracy", read_accuracy},
     {"size", read_sizes},
     {"instructions", read_instructions},
     {"extremes", read_extremes}}};

bool is_empty(const Record& record) {
  return !has_paper(record) && record.points.empty() && record.tuning.empty() &&
         !has_sizes(record) && record.instructions.empty() && record.extremes.empty();
}

Record read_head(const JsonNode& root) {
  const JsonNode node = root["record"], blas = node["blas"];
  Record record;
  record.date = node["date"].utc();
  record.commit = node["commit"].text();
  record.dirty = node["dirty"].boolean();
  record.command = node["command"].text();
  record.machine = read_machine(node["machine"]);
  record.build = read_build(node["build"]);
  for (const auto& [name, version] : node["libraries"].members())
    record.libraries.emplace(name, version.text());
  record.blas = {blas["core"].text(), blas["threads"].integer(1)};
  record.settings = read_settings(node["settings"]);
  return record;
}

}  // namespace

Record read_record(const JsonNode& root) {
  check_schema(root, "desmo-results");
  Record record = read_head(root);
  record.version = root["schema_version"].text();
  for (const auto& [name, read] : experiments)
    if (const auto section = root.find(name)) read(record, *section);
  if (is_empty(record))
    root.complain(
        "nothing was measured: \"paper\", \"accuracy\", \"size\", \"instructions\" and "
        "\"extremes\" are missing or empty");
  require_one_origin(record);
  return record;
}

Record parse_record(std::string_view text) {
  const nlohmann::json document = parse_json(text);
  return read_record(JsonNode(document));
}

Record read_record(const std::filesystem::path& file) { return parse_record(read_whole(file)); }

}  // namespace desmo::report
