#include "formulations/variants.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "formulations/algebra/backend.h"
#include "formulations/inlined_part.h"
#include "formulations/magnitudes.h"

namespace desmo {

namespace {

std::vector<Variant> make_variants() {
  std::vector<Variant> table;
  for (const auto& [partition, partition_name] :
       {std::pair{Partition::global, std::string("global")},
        std::pair{Partition::group, std::string("group")},
        std::pair{Partition::block, std::string("block")}}) {
    for (const auto& [evaluation, evaluation_name] : {std::pair{Evaluation::automatic, "automatic"},
                                                      std::pair{Evaluation::symbolic, "symbolic"}})
      for (const Backend* backend : backends())
        table.push_back({partition_name + "_" + evaluation_name + "_" + std::string(backend->name),
                         partition, evaluation, backend});
    // All unknowns at once would be one type of part for every size of a mechanism.
    if (partition != Partition::global)
      table.push_back(
          {partition_name + "_symbolic_inlined", partition, Evaluation::symbolic, nullptr});
  }
  return table;
}

/// What inlined parts fall back to: it pivots, and allocates nothing.
const Backend& pivoting_backend() {
  return **std::ranges::find(backends(), "eigen", [](const Backend* b) { return b->name; });
}

}  // namespace

std::span<const Variant> variants() {
  static const std::vector<Variant> table = make_variants();
  return table;
}

const Variant& find_variant(std::string_view id) {
  const auto it = std::ranges::find(variants(), id, &Variant::id);
  if (it != variants().end()) return *it;
  std::string known;
  for (const Variant& v : variants()) known += "\n  " + v.id;
  throw std::invalid_argument("unknown formulation '" + std::string(id) + "'; there are:" + known);
}

std::string_view algebra_name(const Variant& v) { return v.backend ? v.backend->name : "inlined"; }

bool is_dense_global(const Variant& v) {
  return v.partition == Partition::global && v.backend && v.backend->dense;
}

bool has_phases(const Variant& v) { return v.backend != nullptr; }

std::string why_not(const Variant& v, const Settings& s) {
  if (!(s.tolerance > 0) || s.max_iterations < 1 || s.fixed_iterations < 0)
    return "the tolerance must be positive, at least one iteration allowed, and the fixed number "
           "of "
           "iterations not negative";
  const bool other_scalar = s.scalar != Scalar::double_precision;
  if (!v.backend) {
    if (s.jacobian != JacobianUpdate::newton)
      return "a generated elimination keeps no factors that a later iteration could use";
    if (s.factorisation != Factorisation::shared)
      return "a generated elimination serves velocity and acceleration in one piece of code";
    if (other_scalar) return "generated code is in double precision";
    return {};
  }
  if (other_scalar && !v.backend->dense)
    return "the sparse library " + std::string(v.backend->name) + " factorises in double precision";
  if (s.scalar == Scalar::single_precision) {
    if (v.evaluation == Evaluation::symbolic) return "generated code is in double precision";
    if (s.fixed_iterations == 0 && s.tolerance < 10 * std::numeric_limits<float>::epsilon())
      return "single precision cannot meet this tolerance; ask for 1e-5, or for a number of "
             "iterations";
  }
  if (s.jacobian == JacobianUpdate::chord && s.factorisation == Factorisation::per_level)
    return "a chord keeps its factors: no level makes its own";
  return {};
}

std::unique_ptr<Formulation> make_formulation(const Variant& v, const Mechanism& m,
                                              const Settings& settings, Profile* profile) {
  if (const std::string reason = why_not(v, settings); !reason.empty())
    throw std::invalid_argument(v.id + ": " + reason);
  std::vector<PartDefinition> definitions = make_partition(m, v.partition);
  // With p parts, each within tolerance/√p, the whole mechanism is within the tolerance.
  Settings own = settings;
  own.tolerance /= std::sqrt(static_cast<double>(definitions.size()));
  const Magnitudes magnitudes(m);
  std::shared_ptr<SinglePrecisionState> single;
  if (settings.scalar == Scalar::single_precision)
    single = std::make_shared<SinglePrecisionState>(m.state_size());

  std::vector<Formulation::DefinedPart> parts;
  for (PartDefinition& d : definitions) {
    PartContext context{m, d, magnitudes.weights(d), std::nullopt, own, profile, single};
    if (v.evaluation == Evaluation::symbolic) context.kernels = bind_kernels(m, d);
    const bool as_named = v.evaluation == Evaluation::automatic || context.kernels;
    const Backend& backend = v.backend ? *v.backend : pivoting_backend();
    std::unique_ptr<Part> part = backend.make_part(context);
    if (!v.backend && context.kernels)
      part = std::make_unique<InlinedPart>(std::move(context.kernels->front()),
                                           std::move(context.weights), own, std::move(part),
                                           d.unknowns);
    parts.push_back({std::move(d), std::move(part), as_named});
  }
  return std::make_unique<Formulation>(m, std::move(parts), settings);
}

std::vector<std::pair<std::string, std::string>> library_versions() {
  std::vector<std::pair<std::string, std::string>> result;
  for (const Backend* b : backends()) result.emplace_back(b->name, b->version());
  return result;
}

}  // namespace desmo
