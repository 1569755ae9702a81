#include "report/statistics/measurements.h"

#include <algorithm>
#include <stdexcept>

#include "report/statistics/paper.h"
#include "report/text/document.h"
#include "report/text/texts.h"

namespace desmo::report {

Measured measured(const Record& record, const CandidateKey& key) {
  const auto candidate = record.candidates.find(key);
  if (candidate == record.candidates.end()) return {std::nullopt, missing_mark};
  return measured(candidate->second);
}

Measured measured(const Measurement& candidate) {
  if (candidate.status != Status::ok)
    return {std::nullopt, candidate.status == Status::failed ? failed_mark : not_run_mark};
  return {summarise(candidate.time), {}, candidate.time.clock};
}

Measurements measurements_by(Clock clock, const Record& record) {
  Measurements all;
  for (const auto& [key, candidate] : measurements(record))
    if (is_by_wall(key.id) == (clock == Clock::wall)) all[key] = candidate;
  return all;
}

MeasuredSpeedUp measured_speed_up(const Record& record,
                                  const std::optional<CandidateKey>& reference,
                                  const CandidateKey& variant) {
  if (!reference) return {std::nullopt, missing_mark};
  return measured_speed_up(measured(record, *reference), measured(record, variant));
}

MeasuredSpeedUp measured_speed_up(const Measured& reference, const Measured& variant) {
  if (!variant.seconds) return {std::nullopt, variant.mark};
  if (!reference.seconds) return {std::nullopt, "reference " + reference.mark};
  if (reference.clock != variant.clock)
    throw std::logic_error("CPU time and wall-clock time make no ratio");
  return {speed_up(*reference.seconds, *variant.seconds), {}};
}

MeanSpeedUp mean_speed_up(const Record& record, std::string_view family,
                          const PaperVariant& variant) {
  std::vector<SpeedUp> found;
  for (const std::int64_t size : published_sizes()) {
    const auto one = measured_speed_up(record, family_key(truck_global, size, family),
                                       family_key(variant, size, family));
    if (one.speed_up) found.push_back(*one.speed_up);
  }
  if (found.empty()) return {};
  return {mean(found), found.size()};
}

std::vector<CandidateKey> candidates_at(const Record& record, const CaseSize& place,
                                        const std::function<bool(const std::string&)>& holds) {
  std::vector<CandidateKey> keys;
  for (const auto& [key, candidate] : record.candidates)
    if (key.is_at(place) && holds(key.id)) keys.push_back(key);
  return keys;
}

std::optional<CandidateKey> fastest_of(const Record& record,
                                       const std::vector<CandidateKey>& candidates) {
  std::optional<CandidateKey> found;
  double least = 0;
  for (const CandidateKey& key : candidates) {
    const Measured time = measured(record, key);
    if (!time.seconds || (found && time.seconds->value >= least)) continue;
    found = key;
    least = time.seconds->value;
  }
  return found;
}

std::optional<CandidateKey> fastest(const Record& record, const CaseSize& place,
                                    const std::function<bool(const Configuration&)>& holds) {
  return fastest_of(record, candidates_at(record, place, [&](const std::string& id) {
                      const auto configuration = parse_configuration(id);
                      return configuration && holds(*configuration) && !is_beside_peers(record, id);
                    }));
}

std::optional<CandidateKey> papers_reference(const Record& record, const CaseSize& place) {
  return fastest(record, place,
                 [](const Configuration& c) { return is_reference(c) && c.is_papers(); });
}

std::optional<CandidateKey> reference_like(const Record& record, const CandidateKey& key) {
  const auto like = parse_configuration(key.id);
  if (!like) return std::nullopt;
  return fastest(record, key,
                 [&](const Configuration& c) { return is_reference(c) && c.iterates_like(*like); });
}

std::vector<std::string_view> recorded_families(const Record& record, std::string_view case_name) {
  std::vector<std::string_view> families;
  for (const std::string_view family : sparse_families)
    if (std::ranges::any_of(record.candidates, [&](const auto& candidate) {
          const CandidateKey& key = candidate.first;
          return std::ranges::any_of(paper_variants, [&](const PaperVariant& variant) {
            return variant.id.ends_with("<sparse>") &&
                   (case_name.empty() || variant.case_name == case_name) &&
                   key == family_key(variant, key.coordinates, family);
          });
        }))
      families.push_back(family);
  return families;
}

std::string remark(const Measurement& candidate) {
  if (candidate.status == Status::ok) return {};
  return candidate.message.empty() ? sentence("common.no_reason") : candidate.message;
}

}  // namespace desmo::report
