
#include <array>
#include <map>
#include <tuple>
#include <utility>

#include "report/read/readers.h"
#include "report/read/record_file.h"

namespace desmo::report {
namespace {

/// Throws MixedRecord unless all was measured on one machine, and all of a case and size has one
/// model, and one set of results for each request.
void require_one_origin(const Record& record) {
  using Place = std::tuple<std::string, std::int64_t, std::string>;  // case, size, what
  std::map<Place, std::pair<std::string, std::string>> first;        // digest, and whose
  const auto agree = [&](const CandidateKey& key, const std::string& what,
                         const std::optional<std::string>& digest, const std::string& problem) {
    if (!digest) return;
    const auto& [other, name] =
        first.try_emplace({key.case_name, key.coordinates, what}, *digest, name_of(key))
            .first->second;
    if (other != *digest) throw MixedRecord(name_of(key) + ": " + problem + " than " + name);
  };
  const auto take = [&](CandidateKey key, const std::string& request, const Candidate& solved) {
    const Origin& origin = solved.origin;
    key.id += request;
    if (origin.machine && *origin.machine != record.machine.cpu)
      throw MixedRecord(name_of(key) + ": measured on \"" + *origin.machine +
                        "\", the record on \"" + record.machine.cpu +
                        "\": a record is of one machine");
    agree(key, "model", origin.model, "solves another model");
    if (solved.status == Status::ok)
      agree(key, "results" + request, origin.results, "has other results");
  };
  for (const auto* candidates : {&record.candidates, &record.wall_candidates})
    for (const auto& [key, candidate] : *candidates) take(key, "", candidate);
  for (const auto* requests : {&record.requests, &record.wall_requests})
    for (const Request& request : *requests)
      take(request.key, "/request:" + request.name, request.solved);
  for (const Peer& peer : record.peers) take(key_of(peer), "", peer.solved);
}

/// The objects of a record, and what reads them.
constexpr std::pair<const char*, void (*)(Record&, const RecordValue&)> readers[] = {
    {"paper", read_paper},
    {"accuracy", read_accuracy},
    {"size", read_sizes},
    {"instructions", read_instructions},
    {"extremes", read_extremes}};

}  // namespace

Record read_record(const RecordValue& root) {
  check_schema(root, "desmo-results");
  Record record = read_environment(root["record"]);
  record.version = root["schema_version"].text();
  std::string names;
  for (const auto& [name, read] : readers) {
    names += (names.empty() ? "\"" : ", \"") + std::string(name) + "\"";
    if (const auto measured = root.find(name)) read(record, *measured);
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

}  // namespace desmo::report
