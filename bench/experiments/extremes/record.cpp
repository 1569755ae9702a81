#include "bench/experiments/extremes/record.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>

namespace desmo::extremes {

namespace {

using Json = nlohmann::ordered_json;

constexpr PerLevel<const char*> level_names{"position", "velocity", "acceleration"};

const char* name(Outcome outcome) {
  switch (outcome) {
    case Outcome::converged:
      return "converged";
    case Outcome::degraded:
      return "degraded";
    case Outcome::failed:
      return "failed";
    case Outcome::refused:
      return "refused";
    case Outcome::not_applicable:
      break;
  }
  return "not_applicable";
}

const char* name(Verdict verdict) {
  switch (verdict) {
    case Verdict::as_expected:
      return "as_expected";
    case Verdict::missed:
      return "missed";
    case Verdict::defect:
      return "defect";
    case Verdict::not_applicable:
      break;
  }
  return "not_applicable";
}

/// To four digits, and at most the largest that a record holds: infinite errors are no numbers of
/// JSON's.
double rounded(double value) {
  constexpr double largest = 1e100;
  if (!(value <= largest)) return largest;
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return std::strtod(text, nullptr);
}

Json worst_json(const PerLevel<WorstError>& worst) {
  Json j;
  for (const Level level : levels) {
    const WorstError& e = worst[level];
    j[level_names[level]] = {
        {"error", rounded(e.error)}, {"floor", rounded(e.floor)}, {"allowed", rounded(e.allowed)}};
  }
  return j;
}

}  // namespace

Json row_json(const Extreme& row) {
  return {{"row", row.number},
          {"name", row.name},
          {"extreme", row.extreme},
          {"expected", row.expected}};
}

Json result_json(const Result& r) {
  const Judgement& judged = r.judgement;
  Json j = {{"row", r.row->number},
            {"case", r.case_name},
            {"id", r.id},
            {"outcome", name(judged.outcome)},
            {"verdict", name(judged.verdict)}};
  if (!judged.reason.empty()) j["reason"] = judged.reason;
  if (judged.instants > 0) {
    j["instants"] = judged.instants;
    j["iterations"] = judged.iterations;
    j["refactorisations"] = judged.refactorisations;
  }
  if (!judged.worst) return j;
  j["condition"] = rounded(r.condition);
  j["worst"] = worst_json(*judged.worst);
  return j;
}

}  // namespace desmo::extremes
