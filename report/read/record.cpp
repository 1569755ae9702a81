// The reader of a record: its head (machine, build, settings), then its experiments.
#include <cmath>
#include <utility>

#include "cases/io/text_file.h"
#include "report/read/readers.h"
#include "report/read/record_file.h"
#include "report/text/digits.h"

namespace desmo::report {
namespace {

LevelNumbers read_allowed(const RecordValue& node) {
  return read_levels(node, &RecordValue::positive);
}

Machine read_machine(const RecordValue& node) {
  const auto loads = node.maybe(
      "load_before", [](const RecordValue& list) { return list.list(&RecordValue::not_negative); });
  return {.cpu = node["cpu"].text(),
          .cores = node["cores"].integer(1),
          .caches = node["caches"].list(&RecordValue::text),
          .governor = node["governor"].text(),
          .load_before = loads && !loads->empty() ? loads->front() : 0};
}

Build read_build(const RecordValue& node) {
  Build build{node["type"].text(), node["compiler"].text(), node["flags"].text(), std::nullopt};
  if (const auto link = node.find("link")) {
    const std::string flags = (*link)["flags"].text();
    build.link = (*link)["type"].text() + (flags.empty() ? "" : " " + flags);
  }
  return build;
}

RecordSettings read_settings(const RecordValue& node) {
  RecordSettings settings{.tolerance = node["tolerance"].positive(),
                          .max_iterations = node["max_iterations"].integer(1),
                          .guess = node["guess"].text(),
                          .step_seconds = node["step_seconds"].positive(),
                          .duration_seconds = node["duration_seconds"].positive(),
                          .instants = node["instants"].integer(1),
                          .allowed = node.maybe("allowed", read_allowed),
                          .windows = node.maybe("windows", [](const RecordValue& windows) {
                            return windows.integer(2);
                          })};
  const double steps = settings.duration_seconds / settings.step_seconds;
  if (std::abs(steps - static_cast<double>(settings.instants - 1)) > 0.01)
    node["instants"].complain(std::to_string(settings.instants) + " instants do not make " +
                              write_shortest(settings.duration_seconds) + " s in steps of " +
                              write_shortest(settings.step_seconds) + " s");
  return settings;
}

/// Reads all of `record` but version and experiments.
Record read_environment(const RecordValue& node) {
  const RecordValue blas = node["blas"];
  Record record;
  record.date = node["date"].utc();
  record.commit = node["commit"].text();
  record.dirty = node["dirty"].boolean();
  record.machine = read_machine(node["machine"]);
  record.build = read_build(node["build"]);
  for (const RecordValue library : node["libraries"].members())
    record.libraries.emplace(library.key(), library.text());
  record.blas = {blas["core"].text(), blas["threads"].integer(1)};
  record.settings = read_settings(node["settings"]);
  record.provenance = node.leaves();
  return record;
}

/// Throws MixedRecord unless all was measured on one machine. All of a case and size must have one
/// model, and one set of results for each request.
void require_one_origin(const Record& record) {
  using Place = std::pair<CaseSize, std::string>;  // second: "model", or "results" and a request
  std::map<Place, std::pair<std::string, std::string>> first;  // digest, and name of its candidate
  const auto agree = [&](const CandidateKey& key, const std::string& what,
                         const std::optional<std::string>& digest, const std::string& problem) {
    if (!digest) return;
    const auto& [other, name] = first.try_emplace({key, what}, *digest, name_of(key)).first->second;
    if (other != *digest) throw MixedRecord(name_of(key) + ": " + problem + " than " + name);
  };
  for (const auto& [key, solved] : measurements(record)) {
    const Origin& origin = solved->origin;
    if (origin.machine && *origin.machine != record.machine.cpu)
      throw MixedRecord(name_of(key) + ": measured on \"" + *origin.machine +
                        "\", the record on \"" + record.machine.cpu +
                        "\": a record is of one machine");
    agree(key, "model", origin.model, "solves another model");
    if (solved->status == Status::ok)
      agree(key, "results" + std::string(request_of(key.id)), origin.results, "has other results");
  }
}

}  // namespace

std::vector<NamedMeasurement> measurements(const Record& record) {
  std::vector<NamedMeasurement> all;
  for (const auto* candidates : {&record.candidates, &record.wall_candidates})
    for (const auto& [key, candidate] : *candidates) all.emplace_back(key, &candidate);
  for (const MeasuredRequest& request : record.requests) {
    all.emplace_back(request.key, &request);
    all.back().first.id += "/request:" + request.name;
  }
  for (const Peer& peer : record.peers) all.emplace_back(peer.key, &peer);
  return all;
}

Record read_record(const RecordValue& root) {
  check_schema(root, "desmo-results");
  Record record = read_environment(root["record"]);
  record.version = root["schema_version"].text();
  std::string names;
  for (const Experiment& experiment : experiments) {
    names += (names.empty() ? "\"" : ", \"") + std::string(experiment.name) + "\"";
    if (const auto measured = root.find(experiment.name)) experiment.read(record, *measured);
  }
  if (std::ranges::none_of(experiments, [&](const Experiment& e) { return e.is_in(record); }))
    root.complain("nothing was measured: all of " + names + " are missing or empty");
  require_one_origin(record);
  return record;
}

Record parse_record(std::string_view text, const std::string& file) {
  return read_document(text, file, [](const RecordValue& root) { return read_record(root); });
}

Record read_record(const std::filesystem::path& file) {
  return parse_record(read_record_text(file), file.string());
}

std::map<std::string, Record> read_records(const std::filesystem::path& folder) {
  std::error_code error;
  if (!is_directory(folder, error)) throw UnreadableFile(folder.string() + ": there is no folder");
  const std::filesystem::directory_iterator files(folder, error);
  if (error) throw UnreadableFile(folder.string() + ": " + error.message());
  std::map<std::string, Record> records;
  for (const auto& file : files) {
    const std::string name = file.path().filename().string();
    const std::size_t end = name.find(".json");
    if (end == name.npos) continue;
    if (!records.emplace(name.substr(0, end), read_record(file.path())).second)
      throw InputError(folder.string() + ": has two files of the record " + name.substr(0, end) +
                       "; keep one");
  }
  return records;
}

}  // namespace desmo::report
