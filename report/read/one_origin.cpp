#include "report/read/one_origin.h"

#include <map>
#include <tuple>

#include "report/read/record_reader.h"

namespace desmo::report {
namespace {

std::string label(const CandidateKey& key, const std::string& request) {
  return name_of(key) + (request.empty() ? "" : "/request:" + request);
}

class OneOrigin {
 public:
  explicit OneOrigin(std::string cpu) : cpu_(std::move(cpu)) {}

  void take(const CandidateKey& key, const std::string& request, Status status,
            const Origin& origin) {
    const std::string name = label(key, request);
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
                    const std::string& complaint) {
    if (!digest) return;
    if (first.digest.empty()) first = {*digest, name};
    if (first.digest != *digest) throw MixedRecord(name + ": " + complaint + " than " + first.name);
  }

  std::string cpu_;
  std::map<Place, First> models_, results_;
};

}  // namespace

void require_one_origin(const Record& record) {
  OneOrigin one(record.machine.cpu);
  for (const auto* candidates : {&record.candidates, &record.wall_candidates})
    for (const auto& [key, candidate] : *candidates)
      one.take(key, {}, candidate.status, candidate.origin);
  for (const auto* requests : {&record.requests, &record.wall_requests})
    for (const Request& request : *requests)
      one.take(request.candidate, request.name, request.status, request.origin);
  for (const Peer& peer : record.peers)  // they find other coordinates: no results to compare
    one.take(key_of(peer), {}, peer.candidate.status, peer.candidate.origin);
}

}  // namespace desmo::report
