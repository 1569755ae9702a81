#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "formulations/algebra/backend.h"
#include "formulations/explicit_part.h"
#include "formulations/inlined_part.h"
#include "formulations/lane_part.h"
#include "formulations/magnitudes.h"
#include "formulations/schedule.h"
#include "formulations/variants.h"

namespace desmo {

namespace {

using DefinedPart = Formulation::DefinedPart;

/// What generated eliminations fall back to: it pivots, and allocates nothing.
const Backend& pivoting_backend() {
  return **std::ranges::find(backends(), "eigen", [](const Backend* b) { return b->name; });
}

/// What all parts of a formulation are made of.
struct Common {
  const Mechanism& m;
  const Variant& v;
  const Settings settings;  // with a part's tolerance
  const Magnitudes magnitudes;
  std::shared_ptr<SinglePrecisionState> single;
  Profile* profile;
};

DefinedPart make_part(const Common& common, PartDefinition d) {
  const auto& [m, v, settings, magnitudes, single, profile] = common;
  PartContext context{m, d, magnitudes.weights(d), std::nullopt, settings, profile, single};
  if (v.evaluation == Evaluation::symbolic) context.kernels = bind_kernels(m, d);
  bool as_named = v.evaluation == Evaluation::automatic || context.kernels;
  const Backend& backend = v.backend ? *v.backend : pivoting_backend();
  std::unique_ptr<Part> part = backend.make_part(context);
  if (!v.backend && context.kernels) {
    const BoundKernel bound = std::move(context.kernels->front());
    part = std::make_unique<InlinedPart>(bound, context.weights, settings, std::move(part),
                                         d.unknowns);
    if (v.explicit_order) {
      const ExplicitKernel* kernel = find_explicit_kernel(bound.kernel->fingerprint);
      if (kernel)
        part = std::make_unique<ExplicitPart>(*kernel, bound, std::move(context.weights), settings,
                                              std::move(part));
      as_named = kernel != nullptr;
    }
  }
  return {std::move(d), std::move(part), as_named};
}

/// What belongs to the parts of a run, as of one part.
PartDefinition join(std::vector<DefinedPart>& run) {
  PartDefinition all;
  all.constant = run.front().definition.constant;
  for (const DefinedPart& p : run) {
    const PartDefinition& d = p.definition;
    all.groups.insert(all.groups.end(), d.groups.begin(), d.groups.end());
    all.unknowns.insert(all.unknowns.end(), d.unknowns.begin(), d.unknowns.end());
    all.equations.insert(all.equations.end(), d.equations.begin(), d.equations.end());
  }
  std::ranges::sort(all.unknowns);
  std::ranges::sort(all.equations, {}, [](const Equation& e) {
    return std::pair{e.constraint, e.row};
  });
  return all;
}

/// The run as one part on lanes, where there is code for its type.
std::vector<DefinedPart> on_lanes(std::vector<DefinedPart> run) {
  auto* first = dynamic_cast<ExplicitPart*>(run.front().solver.get());
  if (run.size() < 2 || !first) return run;
  const LaneKernel* kernel = find_lane_kernel(first->kernel().fingerprint);
  if (!kernel) return run;
  PartDefinition definition = join(run);
  std::vector<std::unique_ptr<ExplicitPart>> members;
  for (DefinedPart& p : run) members.emplace_back(static_cast<ExplicitPart*>(p.solver.release()));
  std::vector<DefinedPart> one;
  one.push_back({std::move(definition), std::make_unique<LanePart>(*kernel, std::move(members)),
                 run.front().as_named});
  return one;
}

}  // namespace

std::unique_ptr<Formulation> make_formulation(const Variant& v, const Mechanism& m,
                                              const Settings& settings, Profile* profile) {
  if (const std::string reason = why_not(v, settings); !reason.empty())
    throw std::invalid_argument(v.id + ": " + reason);
  std::vector<PartDefinition> definitions = make_partition(m, v.partition);
  std::vector<int> run_ends{static_cast<int>(definitions.size())};
  if (!v.backend) run_ends = gather_types(m, definitions);
  // With p parts, each within tolerance/√p, the whole mechanism is within the tolerance.
  Settings own = settings;
  own.tolerance /= std::sqrt(static_cast<double>(definitions.size()));
  std::shared_ptr<SinglePrecisionState> single;
  if (settings.scalar == Scalar::single_precision)
    single = std::make_shared<SinglePrecisionState>(m.state_size());
  const Common common{m, v, own, Magnitudes(m), std::move(single), profile};

  std::vector<DefinedPart> parts;
  int i = 0;
  for (const int end : run_ends) {
    std::vector<DefinedPart> run;
    for (; i < end; ++i) run.push_back(make_part(common, std::move(definitions[i])));
    if (settings.lanes > 1) run = on_lanes(std::move(run));
    std::ranges::move(run, std::back_inserter(parts));
  }
  return std::make_unique<Formulation>(m, std::move(parts), settings);
}

}  // namespace desmo
