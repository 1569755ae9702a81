#include "bench/experiments/paper/case_candidate.h"

#include <algorithm>
#include <exception>

#include "bench/experiments/paper/extended_ids.h"
#include "bench/kit/record/model_digest.h"
#include "bench/kit/time/cpu_clock.h"
#include "formulations/modelling/modelling.h"

namespace desmo::paper {

namespace {

constexpr int profiled_coordinates = 558;  // the largest of the paper's tables
constexpr int profiled_instants = 51;

/// What KLU gains by finding irreducible blocks itself shows beside it.
constexpr std::string_view reference_of_one_block = "global_automatic_klu/btf:off";

/// The counterparts of FBL-G and FBL-TP, and the blocks beside the latter: the only ones run at
/// extra sizes.
bool runs_at_extra_sizes(const Variant& v) {
  if (!v.backend) return true;
  return v.partition == Partition::global && v.evaluation == Evaluation::automatic &&
         !is_dense_global(v);
}

/// Why a formulation is not run with so many coordinates; empty when it is.
std::string too_costly(const Variant& v, int n, const Options& options) {
  const auto up_to = [](int limit) {
    return ": run up to " + std::to_string(limit) + " coordinates only";
  };
  if (is_dense_global(v) && n > options.dense_limit)
    return "a dense global solve costs O(n^3) a step" + up_to(options.dense_limit);
  if (n <= options.slow_limit) return {};
  if (algebra_name(v) == "spqr")
    return "orthogonal factorisation serves accuracy, not speed" + up_to(options.slow_limit);
  if ((algebra_name(v) == "umfpack" || algebra_name(v) == "sparselu") &&
      v.partition == Partition::block)
    return "a library's overhead is all there is in blocks this small" + up_to(options.slow_limit);
  return {};
}

}  // namespace

CaseCandidate::CaseCandidate(const Case& d, int n, const Variant& v, const Options& options,
                             const Settings& s, Clock by)
    : Candidate(chosen_grid(d.describe(1).grid, options), s.threads, by),
      definition(d),
      coordinates(n),
      variant(v),
      settings(s),
      delivery_(Delivery(n), windows) {
  if (const std::string reason = too_costly(v, n, options); !reason.empty()) leave_out(reason);
}

std::string CaseCandidate::name() const {
  return std::string(definition.name) + "/" + std::to_string(coordinates) + "/" + id();
}

void CaseCandidate::verify(ReferenceCache& references) {
  if (state != State::untouched) return;
  if (const std::string reason = unavailable_reason(settings); !reason.empty())
    return leave_out(reason);
  try {
    model_ = std::make_unique<Model>(make_model(describe(definition, coordinates)));
    model = model_digest(*model_);
    groups = model_->structural_groups();
    degrees_of_freedom = model_->degrees_of_freedom();
    const double before_setup = cpu_now();
    formulation_ = make_formulation(variant, *model_, settings);
    setup_seconds = cpu_now() - before_setup;
    if (const std::string missing = missing_code(*formulation_); !missing.empty())
      return fail(missing);

    const auto reference = references.get(*model_, grid);
    VerifyingObserver observer(reference);
    const double start = now(clock);
    const Summary summary = formulation_->run(grid, {}, observer);
    analysis_seconds = now(clock) - start;
    errors = observer.errors();
    results = observer.results();
    conclude(summary, *model_, reference.size());
  } catch (const std::exception& e) {
    fail(e.what());
  }
}

void CaseCandidate::profile() {
  if (state != State::verified || coordinates != profiled_coordinates || !has_phases(variant))
    return;
  // The settings are those of the paper, which does not know KLU.
  if (id() != variant.id && id() != reference_of_one_block) return;
  // In blocks of one unknown, reading the clock costs more than what it measures.
  if (variant.partition == Partition::block) return;
  TimeGrid first = grid;
  first.instants = std::min(grid.instants, profiled_instants);
  phases = measure_phases(variant, settings, *model_, first);
}

void CaseCandidate::make() {
  formulation_ = make_formulation(variant, *model_, settings);
  formulation_->assemble(grid.time(0));
  Delivery elsewhere(coordinates);
  wake_threads([&] { formulation_->run(grid, {}, elsewhere); });
}

Summary CaseCandidate::analyse() {
  windows.begin();
  const Summary summary = formulation_->run(grid, {}, delivery_);
  if (!summary.ok()) fail(describe(summary, *model_));
  return summary;
}

std::vector<std::pair<std::string, double>> CaseCandidate::counters() const {
  return {{"coordinates", coordinates},
          {"groups", groups},
          {"iterations/step", iterations_per_step},
          {"residual", residual}};
}

std::vector<std::unique_ptr<CaseCandidate>> make_case_candidates(const Options& options) {
  std::vector<std::unique_ptr<CaseCandidate>> cells;
  for (const Case& c : cases()) {
    for (const int n : c.sizes)
      for (const Variant& v : variants())
        cells.push_back(std::make_unique<CaseCandidate>(c, n, v, options));
    for (const int n : c.extra_sizes)
      for (const Variant& v : variants())
        if (runs_at_extra_sizes(v))
          cells.push_back(std::make_unique<CaseCandidate>(c, n, v, options));
    const auto add_new = [&](std::unique_ptr<CaseCandidate> cell) {
      if (std::ranges::find(cells, cell->name(), &CaseCandidate::name) == cells.end())
        cells.push_back(std::move(cell));
    };
    const auto add = [&](int n, std::string_view id) {
      const auto [variant, settings] = parse_id(id);
      add_new(std::make_unique<CaseCandidate>(c, n, *variant, options, settings));
      if (settings.threads > 1)
        add_new(std::make_unique<CaseCandidate>(c, n, *variant, options, on_one_thread(settings),
                                                Clock::wall));
    };
    for (const std::string_view id : extended_ids) add(c.sizes.back(), id);
    add(c.sizes.back(), reference_of_one_block);
    for (const std::string& id : options.formulations)
      for (const int n : c.sizes) add(n, id);
  }
  return cells;
}

}  // namespace desmo::paper
