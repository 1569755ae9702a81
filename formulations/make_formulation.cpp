#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "formulations/algebra/backend.h"
#include "formulations/batch/batch_part.h"
#include "formulations/batch/segments_in_lanes.h"
#include "formulations/batch/segments_on_threads.h"
#include "formulations/id.h"
#include "formulations/model/magnitudes.h"
#include "formulations/model/part_type.h"
#include "formulations/motion/time_stepping.h"
#include "formulations/parts/explicit_part.h"
#include "formulations/parts/inlined_part.h"
#include "formulations/parts/newton_part.h"
#include "formulations/variants.h"

namespace desmo {

namespace {

/// Returns the library that solves steps which generated eliminations refuse: dense, with pivoting,
/// without heap memory in steps. Every build has it.
const Backend& pivoting_backend() { return *find_backend("eigen"); }

/// Ingredients that all parts of a formulation share.
struct Common {
  const Model& model;
  const Variant& variant;
  const Settings settings;  // their tolerance is the share of one part
  const Magnitudes magnitudes;
  Profile* profile;
  const KernelTable& table;
};

/// An unfinished part: solved by Newton's method at first, with what a generated elimination needs.
struct Draft {
  DefinedPart part;
  std::optional<BoundKernel> bound;  // kernel of the elimination; nothing: no such kernel
  std::vector<double> weights;
  PartSettings settings;
};

/// Makes a part solved by Newton's method; generated eliminations fall back to it.
Draft make_newton(const Common& common, PartDefinition d) {
  const Variant& v = common.variant;
  PartContext context{.model = common.model,
                      .definition = d,
                      .weights = common.magnitudes.weights(d),
                      .kernels = std::nullopt,
                      .analysis = common.settings,
                      .settings = PartSettings(common.settings, common.magnitudes.rounding(d)),
                      .profile = common.profile,
                      .magnitudes = common.magnitudes.of_unknowns(d)};
  if (v.evaluation == Evaluation::symbolic)
    context.kernels = bind_kernels(common.model, d, common.table);
  const Backend* const backend = find_backend(v.algebra);
  std::unique_ptr<Part> solver = make_newton_part(context, backend ? *backend : pivoting_backend());
  Draft draft{.part = {.definition = std::move(d),
                       .solver = std::move(solver),
                       .as_named = v.evaluation == Evaluation::automatic || context.kernels,
                       .tolerance = context.settings.tolerance},
              .bound = std::nullopt,
              .weights = std::move(context.weights),
              .settings = context.settings};
  if (v.is_generated() && context.kernels) draft.bound = std::move(context.kernels->front());
  return draft;
}

void make_inlined(Draft& d) {
  d.part.solver = std::make_unique<InlinedPart>(
      *d.bound, d.weights, d.settings, std::move(d.part.solver), d.part.definition.unknowns);
}

void make_explicit(const Common& common, Draft& d) {
  const ExplicitKernel* kernel = common.table.find_explicit_kernel(d.bound->kernel->fingerprint);
  d.part.as_named = kernel != nullptr;
  if (!kernel) return;
  d.part.solver = std::make_unique<ExplicitPart>(*kernel, *d.bound, d.weights, d.settings,
                                                 std::move(d.part.solver));
}

/// Makes the parts kind by kind: Newton parts, then inlined, then explicit ones. So the memory that
/// every step uses lies together, separate from the workspaces of fallbacks.
std::vector<DefinedPart> make_parts(const Common& common, std::vector<PartDefinition> definitions) {
  std::vector<Draft> drafts;
  drafts.reserve(definitions.size());
  for (PartDefinition& d : definitions) drafts.push_back(make_newton(common, std::move(d)));
  for (Draft& d : drafts)
    if (d.bound) make_inlined(d);
  for (Draft& d : drafts)
    if (d.bound && common.variant.is_explicit()) make_explicit(common, d);
  std::vector<DefinedPart> parts;
  parts.reserve(drafts.size());
  for (Draft& d : drafts) parts.push_back(std::move(d.part));
  return parts;
}

/// Returns the settings of parts: with p parts, each within tolerance/√p, the whole mechanism is
/// within the tolerance, unless rounding leaves a part more than its share.
Settings share_of(Settings whole, std::size_t parts) {
  whole.tolerance /= std::sqrt(static_cast<double>(parts));
  return whole;
}

// Declared here, since make_segments() calls it: a thread's solver is made like the whole, and may
// have segments in lanes. Its settings ask for one thread, which ends the recursion.
std::unique_ptr<TimeStepping> make_solver(const Variant& v, const Model& m,
                                          const Settings& settings, Profile* profile,
                                          const KernelTable& table);

/// Makes the executor that solves segments of a motion at once: on threads, each with a solver that
/// takes one segment, or in lanes, each with parts of its own. Returns null where the settings ask
/// for neither.
std::unique_ptr<SegmentExecutor> make_segments(const Common& common,
                                               const std::vector<PartDefinition>& definitions,
                                               const Settings& settings) {
  if (settings.threads > 1) {
    Settings of_worker = settings;
    of_worker.threads = of_worker.stride = 1;
    std::vector<std::unique_ptr<TimeStepping>> workers(settings.threads);
    for (auto& worker : workers)
      worker = make_solver(common.variant, common.model, of_worker, nullptr, common.table);
    return std::make_unique<SegmentsOnThreads>(std::move(workers), min_segment * settings.segments);
  }
  if (settings.segments > 1) {
    std::vector<SegmentsInLanes::Parts> lanes(settings.segments);
    for (SegmentsInLanes::Parts& parts : lanes) parts = make_parts(common, definitions);
    return std::make_unique<SegmentsInLanes>(common.model, std::move(lanes), settings,
                                             common.table);
  }
  return nullptr;
}

/// Makes a formulation with settings that the variant supports.
std::unique_ptr<TimeStepping> make_solver(const Variant& v, const Model& m,
                                          const Settings& settings, Profile* profile,
                                          const KernelTable& table) {
  std::vector<PartDefinition> definitions = make_partition(m, v.partition);
  std::vector<int> type_ends{static_cast<int>(definitions.size())};
  if (v.is_generated()) type_ends = gather_types(m, definitions);
  const Common common{.model = m,
                      .variant = v,
                      .settings = share_of(settings, definitions.size()),
                      .magnitudes = Magnitudes(m),
                      .profile = profile,
                      .table = table};
  std::unique_ptr<SegmentExecutor> segments = make_segments(common, definitions, settings);
  std::vector<DefinedPart> parts = make_parts(common, std::move(definitions));
  if (settings.lanes > 1) parts = make_batches(m, std::move(parts), type_ends, settings, table);
  return std::make_unique<TimeStepping>(m, std::move(parts), settings, std::move(segments));
}

/// Makes a formulation. Throws as make_formulation() says. profile: null: no phases are measured.
std::unique_ptr<Formulation> make(const Variant& v, const Model& m, const Settings& settings,
                                  Profile* profile, const KernelTable& table) {
  if (const std::string reason = unsupported_reason(v, settings); !reason.empty())
    throw std::invalid_argument(v.id + ": " + reason);
  if (const std::string reason = unavailable_reason(settings); !reason.empty())
    throw std::invalid_argument(id_with(v, settings) + ": " + reason);
  if (m.modelling != settings.coordinates)
    throw std::invalid_argument(id_with(v, settings) + ": '" + m.name +
                                "' is modelled in other coordinates; give make_model() those of "
                                "the settings");
  return make_solver(v, m, settings, profile, table);
}

}  // namespace

std::unique_ptr<Formulation> make_formulation(const Variant& v, const Model& m,
                                              const Settings& settings) {
  return make(v, m, settings, nullptr, KernelTable::built_in());
}

std::unique_ptr<Formulation> make_formulation(const Variant& v, const Model& m,
                                              const Settings& settings, const KernelTable& table) {
  return make(v, m, settings, nullptr, table);
}

std::unique_ptr<Formulation> make_profiled_formulation(const Variant& v, const Model& m,
                                                       const Settings& settings, Profile& profile) {
  return make(v, m, settings, &profile, KernelTable::built_in());
}

}  // namespace desmo
