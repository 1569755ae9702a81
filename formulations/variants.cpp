#include "formulations/variants.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "cases/mechanism/names.h"
#include "formulations/algebra/backend.h"
#include "formulations/equations/lane_kernel.h"

namespace desmo {

namespace {

/// Returns the variants with these libraries, and those whose elimination is generated.
std::vector<Variant> make_variants(std::span<const Backend* const> with) {
  std::vector<Variant> table;
  for (const auto& [partition, partition_name] :
       {std::pair{Partition::global, std::string("global")},
        std::pair{Partition::group, std::string("group")},
        std::pair{Partition::block, std::string("block")}}) {
    for (const auto& [evaluation, evaluation_name] : {std::pair{Evaluation::automatic, "automatic"},
                                                      std::pair{Evaluation::symbolic, "symbolic"}})
      for (const Backend* backend : with)
        table.push_back({partition_name + "_" + evaluation_name + "_" + std::string(backend->name),
                         partition, evaluation, backend->name});
    // Not for `global`: its one part would be of another type for every size of a mechanism.
    if (partition != Partition::global)
      for (const char* algebra : {"inlined", "explicit"})
        table.push_back(
            {partition_name + "_symbolic_" + algebra, partition, Evaluation::symbolic, algebra});
  }
  return table;
}

}  // namespace

std::span<const Variant> variants() {
  static const std::vector<Variant> table = make_variants(backends());
  return table;
}

const Variant& find_variant(std::string_view id) {
  const auto it = std::ranges::find(variants(), id, &Variant::id);
  if (it != variants().end()) return *it;
  if (const std::string reason = unavailable_reason(id); !reason.empty())
    throw std::invalid_argument("formulation " + in_quotes(id) + ": " + reason);
  std::string known;
  for (const Variant& v : variants()) known += "\n  " + v.id;
  throw std::invalid_argument("unknown formulation " + in_quotes(id) + "; there are:" + known);
}

std::string unsupported_reason(const Variant& v, const Settings& s) {
  if (!(s.tolerance > 0) || s.max_iterations < 1 || s.fixed_iterations < 0 ||
      s.fixed_iterations > max_fixed_iterations)
    return "the tolerance must be positive, at least one iteration allowed, and the fixed number "
           "of iterations from 0 to " +
           std::to_string(max_fixed_iterations);
  if (s.stride < 1 || s.stride > max_stride)
    return "a stride is 1 (every instant is solved) or up to " + std::to_string(max_stride);
  if (s.threads < 1 || s.threads > max_threads)
    return "a motion is solved on one thread or several, up to " + std::to_string(max_threads);
  for (const int at_once : {s.lanes, s.segments})
    if (at_once != 1 && (std::ranges::count(lane_counts, at_once) == 0 || !v.is_explicit()))
      return "there is code for four lanes or eight, in explicit order";
  if (s.lanes != 1 && s.segments != 1)
    return "lanes hold parts of one type or segments of the motion, not both";
  if (s.coordinates != Modelling::natural && (s.lanes != 1 || s.segments != 1))
    return "lanes and segments hold parts of natural coordinates";
  if (s.frames == Frames::exact && !has_frames(s.coordinates))
    return "bodies have frames in reference and relative coordinates alone";
  if (s.frames == Frames::exact && v.evaluation == Evaluation::symbolic)
    return "generated equations are evaluated all at once, not frames before the others";
  const Backend* const backend = find_backend(v.algebra);
  if (s.btf != BlockTriangularForm::on && !(backend && backend->has_btf))
    return "block triangular form is KLU's, and there is none to leave out";
  if (!backend && s.jacobian != JacobianUpdate::newton)
    return "a generated elimination keeps no factors that a later iteration could use";
  return {};
}

std::string unavailable_reason(const Settings& s) {
  for (const int at_once : {s.lanes, s.segments})
    if (at_once != 1 && !has_lanes(at_once))
      return std::to_string(at_once) +
             " lanes need a processor with AVX-512 (x86-64-v4), and a build that has code for it";
  return {};
}

std::string unavailable_reason(std::string_view id) {
  for (const Backend* b : absent_backends())
    for (const Variant& v : make_variants({&b, 1}))
      if (v.algebra == b->name && v.id == id) return b->absence().reason;
  return {};
}

std::vector<std::string> faulty_libraries() {
  std::vector<std::string> notes;
  for (const Backend* b : absent_backends())
    if (const Absence absence = b->absence(); absence.faulty)
      notes.push_back("no formulation with " + std::string(b->name) + ": " + absence.reason);
  return notes;
}

std::vector<std::pair<std::string, std::string>> library_versions() {
  std::vector<std::pair<std::string, std::string>> result;
  for (const Backend* b : backends()) result.emplace_back(b->name, b->version());
  return result;
}

}  // namespace desmo
