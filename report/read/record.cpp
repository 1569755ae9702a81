
#include <array>
#include <map>
#include <tuple>
#include <utility>

#include "report/read/readers.h"
#include "report/read/record_reader.h"

namespace desmo::report {
namespace {

/// The first model and results of each case and size, which all others have to share.
class OneOrigin {
 public:
  explicit OneOrigin(std::string cpu) : cpu_(std::move(cpu)) {}

  void take(const CandidateKey& key, const std::string& request, Status status,
            const Origin& origin) {
    const std::string name = name_of(key) + (request.empty() ? "" : "/request:" + request);
    if (origin.machine && *origin.machine != cpu_)
      throw MixedRecord(name + ": measured on \"" + *origin.machine + "\", the record on \"" +
                        cpu_ + "\": a record is of one machine");
    agree(models_[{key.case_name, key.coordinates, {}}], origin.model, name,
          "solves another model");
    if (status == Status::ok)
      agree(results_[{key.case_name, key.coordinates, request}], origin.results, name,
            "has other results");
  }

 private:
  struct First {
    std::string digest, name;
  };
  using Place = std::tuple<std::string, std::int64_t, std::string>;  // case, size, request

  static void agree(First& first, const std::optional<std::string>& digest, const std::string& name,
                    const std::string& problem) {
    if (!digest) return;
    if (first.digest.empty()) first = {*digest, name};
    if (first.digest != *digest) throw MixedRecord(name + ": " + problem + " than " + first.name);
  }

  std::string cpu_;
  std::map<Place, First> models_, results_;
};

void require_one_origin(const Record& record) {
  OneOrigin one(record.machine.cpu);
  for (const auto* candidates : {&record.candidates, &record.wall_candidates})
    for (const auto& [key, candidate] : *candidates)
      one.take(key, {}, candidate.status, candidate.origin);
  for (const auto* requests : {&record.requests, &record.wall_requests})
    for (const Request& request : *requests)
      one.take(request.key, request.name, request.solved.status, request.solved.origin);
  for (const Peer& peer : record.peers)  // they find other coordinates: no results to compare
    one.take(key_of(peer), {}, peer.solved.status, peer.solved.origin);
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
