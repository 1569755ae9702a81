#include "bench/experiments/paper/request.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "bench/experiments/paper/entry_json.h"
#include "bench/experiments/paper/extended_ids.h"
#include "bench/kit/digests.h"
#include "bench/kit/problem.h"
#include "cases/io/files.h"
#include "cases/library/library.h"
#include "cases/mechanism/formatted.h"
#include "formulations/modelling/modelling.h"
#include "formulations/stepping/formulation_core.h"
#include "formulations/structure/partition.h"

namespace desmo::paper {

namespace {

/// Formulations with which requests are timed: the reference, and others that can leave out more
/// and more.
constexpr std::array<std::string_view, 6> requested_ids{
    "global_automatic_klu",   "global_symbolic_klu",     "group_symbolic_inlined",
    "block_symbolic_inlined", "group_symbolic_explicit", "block_symbolic_explicit"};

/// The tolerance as far as double precision goes, for the whole mechanism.
constexpr double converged = 1e-13;

/// Returns what is asked, component by component; what never moves needs no solving and no
/// delivery.
std::vector<AskedComponent> components(const Model& whole, const Plan& plan,
                                       std::span<const Asked> asked) {
  std::vector<AskedComponent> result;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const Entity& from = whole.entities[asked[i].entity];
    const Entity& to = plan.model.entities[plan.outputs[i].entity];
    for (int k = 0; !from.fixed && k < from.size; ++k)
      result.push_back({from.first + k, to.first + k, asked[i].level});
  }
  return result;
}

/// Widens `largest` by the differences of what is asked between an instant of the whole mechanism
/// and one of what is kept of it.
void compare(Differences& largest, std::span<const AskedComponent> asked, const Instant& whole,
             const Instant& kept) {
  ++largest.instants;
  for (const AskedComponent& a : asked) {
    widen(largest.position, whole.q[a.whole], kept.q[a.kept]);
    if (a.level >= Level::velocity) widen(largest.velocity, whole.qd[a.whole], kept.qd[a.kept]);
    if (a.level >= Level::acceleration)
      widen(largest.acceleration, whole.qdd[a.whole], kept.qdd[a.kept]);
  }
}

Instant instant_of(const Formulation& f, double t) { return {0, t, f.q(), f.qd(), f.qdd()}; }

/// Compares a request with a reference of the whole mechanism.
class VerifyingRequest final : public ComparingObserver {
 public:
  VerifyingRequest(std::span<const ReferenceInstant> reference, const PlannedRequest& request)
      : ComparingObserver(request.coordinates.size(), request.plan.level(), reference),
        request_(request) {}

  Comparison compare() const override {
    Differences errors;
    ResultDigest results;
    for_each([&](const ReferenceInstant& r, const State& came) {
      ++errors.instants;
      for (const AskedComponent& a : request_.asked) {
        const std::size_t place =
            std::ranges::lower_bound(request_.coordinates, a.kept) - request_.coordinates.begin();
        const auto compare = [&](Level level, double& largest, const std::vector<double>& found,
                                 const std::vector<double>& reference, double unit) {
          if (a.level < level) return;
          const double value = found[place];
          widen(largest, value, reference[a.whole]);
          results.add(value, reference[a.whole], unit);
        };
        compare(Level::position, errors.position, came.q, r.q, allowed_difference.position);
        compare(Level::velocity, errors.velocity, came.qd, r.qd, allowed_difference.velocity);
        compare(Level::acceleration, errors.acceleration, came.qdd, r.qdd,
                allowed_difference.acceleration);
      }
    });
    return {errors, results.hex()};
  }

 private:
  const PlannedRequest& request_;
};

}  // namespace

PlannedRequest::PlannedRequest(std::string_view short_name, const Scene& scene,
                               const Options& options)
    : name(short_name),
      title(scene.name),
      whole(make_model(scene)),
      definition(find_case(scene.mechanism.name)) {
  grid = chosen_grid(scene.grid, options);
  const std::vector<Asked> everything_asked = asked_by(scene, whole);
  plan = make_plan(whole, everything_asked);
  asked = components(whole, plan, everything_asked);
  if (asked.empty())
    throw std::invalid_argument("request " + name + ": asks for nothing that moves");
  for (const AskedComponent& a : asked) coordinates.push_back(a.kept);
  std::ranges::sort(coordinates);
  coordinates.erase(std::ranges::unique(coordinates).begin(), coordinates.end());
  unknowns = moving_unknowns(plan.model);
  all_unknowns = moving_unknowns(whole);
}

Differences max_differences(Formulation& whole, Formulation& kept,
                            std::span<const AskedComponent> asked, Level level,
                            const TimeGrid& grid) {
  Differences largest;
  for (int i = 0; i < grid.instants; ++i) {
    const double t = grid.time(i);
    const Summary all = i == 0 ? whole.assemble(t) : whole.step(t);
    if (!all.ok()) throw std::runtime_error("the whole mechanism: " + describe(all, whole.model()));
    const Summary some = i == 0 ? kept.assemble(t, level) : kept.step(t, level);
    if (!some.ok()) throw std::runtime_error(describe(some, kept.model()));
    compare(largest, asked, instant_of(whole, t), instant_of(kept, t));
  }
  return largest;
}

RequestCandidate::RequestCandidate(std::shared_ptr<const PlannedRequest> request, const Variant& v,
                                   const Settings& s, Clock by)
    : FormulationCandidate(request->grid, request->definition.name, request->whole.coordinates(),
                           id_with(v, s), {&v, s}, by,
                           {request->plan.level(), request->coordinates}),
      request_(std::move(request)) {}

std::string RequestCandidate::name() const {
  return FormulationCandidate::name() + "/request:" + request_->name;
}

RequestCandidate::Checked RequestCandidate::check(ReferenceCache& references, VerifyingRun& found) {
  std::string reason = unavailable_reason(settings());
  if (!reason.empty()) return not_run(std::move(reason));
  found.model = model_digest(request_->whole);
  const auto formulation = make_formulation();
  reason = missing_code(*formulation);
  if (!reason.empty()) return not_run(std::move(reason));
  compare_with_whole(parts_of(*formulation).size());
  if (difference_ > allowed_request_difference)
    return failed(
        formatted("differs from the solution of the whole mechanism by %.1e (allowed: %.0e)",
                  difference_, allowed_request_difference));
  return compare_with([&] { return references.get(request_->whole, grid(), settings().stride); },
                      found);
}

void RequestCandidate::add_to(nlohmann::ordered_json& lists) const {
  lists["requests"].push_back(
      with_measurement({{"case", request_->definition.name},
                        {"coordinates", coordinates},
                        {"id", id()},
                        {"request", request_->name},
                        {"title", request_->title},
                        {"level", level_names[request_->plan.level()]},
                        {"unknowns", request_->unknowns},
                        {"all_unknowns", request_->all_unknowns}},
                       *this, {.level = request_->plan.level(), .difference = difference_}));
}

std::unique_ptr<ComparingObserver> RequestCandidate::comparing(
    std::span<const ReferenceInstant> reference) const {
  return std::make_unique<VerifyingRequest>(reference, *request_);
}

void RequestCandidate::compare_with_whole(std::size_t parts) {
  Settings own = settings();
  own.tolerance = converged;
  const auto whole = desmo::make_formulation(variant(), request_->whole, own);
  // Each part stops at tolerance/√parts: the same residual in both, so that equal parts do the
  // same.
  own.tolerance *=
      std::sqrt(static_cast<double>(parts) / static_cast<double>(parts_of(*whole).size()));
  const auto kept = desmo::make_formulation(variant(), request_->plan.model, own);
  kept->solve_only(request_->plan.levels);
  const Differences largest =
      max_differences(*whole, *kept, request_->asked, request_->plan.level(), grid());
  difference_ = std::max({largest.position, largest.velocity, largest.acceleration});
}

std::vector<std::unique_ptr<RequestCandidate>> make_request_candidates(const Options& options) {
  std::vector<std::unique_ptr<RequestCandidate>> candidates;
  for (const RequestScene& source : request_scenes()) {
    const Scene scene = parse_scene(source.scene, std::string(source.name), {});
    const auto request = std::make_shared<const PlannedRequest>(source.name, scene, options);
    const auto add = [&](std::string_view id) {
      const auto [variant, settings] = parse_id(id);
      candidates.push_back(std::make_unique<RequestCandidate>(request, *variant, settings));
      if (settings.threads > 1)
        candidates.push_back(std::make_unique<RequestCandidate>(
            request, *variant, on_one_thread(settings), Clock::wall));
    };
    std::ranges::for_each(requested_ids, add);
    if (source.name == extended_request) std::ranges::for_each(extended_ids, add);
  }
  return candidates;
}

}  // namespace desmo::paper
