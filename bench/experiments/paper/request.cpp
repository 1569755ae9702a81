#include "bench/experiments/paper/request.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "bench/experiments/paper/extended_ids.h"
#include "bench/kit/digests.h"
#include "bench/kit/problem.h"
#include "cases/io/files.h"
#include "cases/library/library.h"
#include "formulations/modelling/modelling.h"

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
void compare(Errors& largest, std::span<const AskedComponent> asked, const Instant& whole,
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
class VerifyingRequest final : public DeliveryAtReference {
 public:
  VerifyingRequest(std::span<const ReferenceInstant> reference, const PlannedRequest& request)
      : DeliveryAtReference(request.coordinates.size(), request.plan.level(), reference),
        request_(request) {}

  Comparison compare() const {
    Errors errors;
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
        compare(Level::position, errors.position, came.q, r.q, allowed.position);
        compare(Level::velocity, errors.velocity, came.qd, r.qd, allowed.velocity);
        compare(Level::acceleration, errors.acceleration, came.qdd, r.qdd, allowed.acceleration);
      }
    });
    return {errors, results.hex()};
  }

 private:
  const PlannedRequest& request_;
};

std::string difference_message(double difference) {
  char text[120];
  std::snprintf(text, sizeof text,
                "differs from the solution of the whole mechanism by %.1e (allowed: %.0e)",
                difference, allowed_request_difference);
  return text;
}

}  // namespace

PlannedRequest::PlannedRequest(std::string_view short_name, const Scene& scene,
                               const Options& options)
    : name(short_name),
      title(scene.name),
      whole(make_model(scene)),
      definition(find_case(scene.mechanism.name)),
      grid(chosen_grid(scene.grid, options)) {
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

Errors max_differences(Formulation& whole, Formulation& kept, std::span<const AskedComponent> asked,
                       Level level, const TimeGrid& grid) {
  Errors largest;
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
    : Candidate(request->grid, s.threads, by),
      variant(v),
      settings(s),
      request_(std::move(request)),
      delivery_(request_->coordinates.size(), request_->plan.level(), windows) {}

std::string RequestCandidate::name() const {
  return std::string(request_->definition.name) + "/" +
         std::to_string(request_->whole.coordinates()) + "/" + id() + "/request:" + request_->name;
}

std::unique_ptr<Formulation> RequestCandidate::made_with_tolerance(double tolerance) const {
  Settings own = settings;
  own.tolerance = tolerance;
  std::unique_ptr<Formulation> f = make_formulation(variant, request_->plan.model, own);
  f->solve_only(request_->plan.levels);
  return f;
}

void RequestCandidate::verify(ReferenceCache& references) {
  if (state != State::unverified) return;
  if (const std::string reason = unavailable_reason(settings); !reason.empty())
    return leave_out(reason);
  try {
    model = model_digest(request_->whole);
    const double before_setup = cpu_now();
    formulation_ = made_with_tolerance(settings.tolerance);
    setup_seconds = cpu_now() - before_setup;
    if (const std::string missing = missing_code(*formulation_); !missing.empty())
      return leave_out(missing);
    if (const std::string wrong = compare_with_whole(); !wrong.empty()) return fail(wrong);

    const auto reference = references.get(request_->whole, request_->grid);
    VerifyingRequest observer(reference, *request_);
    const double start = now(clock);
    const Summary summary = run(observer);
    analysis_seconds = now(clock) - start;
    const Comparison found = observer.compare();
    errors = found.errors;
    results = found.results;
    conclude(summary, request_->plan.model, reference.size());
  } catch (const std::exception& e) {
    fail(e.what());
  }
}

std::string RequestCandidate::compare_with_whole() {
  Settings own = settings;
  own.tolerance = converged;
  const auto whole = make_formulation(variant, request_->whole, own);
  // Each part stops at tolerance/√parts: the same residual in both, so that equal parts do the
  // same.
  const double share = static_cast<double>(formulation_->parts().size()) /
                       static_cast<double>(whole->parts().size());
  const auto kept = made_with_tolerance(converged * std::sqrt(share));
  const Errors largest =
      max_differences(*whole, *kept, request_->asked, request_->plan.level(), request_->grid);
  difference = std::max({largest.position, largest.velocity, largest.acceleration});
  return difference <= allowed_request_difference ? "" : difference_message(difference);
}

Summary RequestCandidate::run(Observer& observer) {
  return formulation_->run(request_->grid, {request_->plan.level(), request_->coordinates},
                           observer);
}

void RequestCandidate::make() {
  formulation_ = made_with_tolerance(settings.tolerance);
  formulation_->assemble(grid.time(0), request_->plan.level());
  Delivery elsewhere(request_->coordinates.size(), request_->plan.level());
  wake_threads([&] { run(elsewhere); });
}

Summary RequestCandidate::analyse() {
  windows.begin();
  const Summary summary = run(delivery_);
  if (!summary.ok()) fail(describe(summary, request_->plan.model));
  return summary;
}

std::vector<std::pair<std::string, double>> RequestCandidate::counters() const {
  return {{"unknowns", request_->unknowns},
          {"of", request_->all_unknowns},
          {"iterations/step", iterations_per_step},
          {"residual", residual}};
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
