#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formulations/base/part.h"
#include "formulations/formulation.h"
#include "formulations/model/model.h"
#include "formulations/parts/profile.h"
#include "formulations/structure/partition.h"

namespace desmo {

enum class Partition;
enum class Evaluation;
struct Profile;
struct Backend;
class KernelTable;

/// A formulation of the suite: a point on the three axes of the design.
struct Variant {
  std::string id;  ///< <partition>_<equations>_<algebra>
  Partition partition;
  Evaluation evaluation;
  const Backend* backend;       ///< null: the elimination is generated (inlined, explicit)
  bool explicit_order = false;  ///< unknowns in closed form one after the other, as far as may be
};

/// Every variant of this build that this machine has the libraries for. Tests, benchmarks and
/// documents iterate this table.
std::span<const Variant> variants();

/// Returns the variant of that id. Throws std::invalid_argument: with the reason where the variant
/// cannot be had on this machine (unavailable_reason), else with a list of all ids.
const Variant& find_variant(std::string_view id);

/// "lapack", "klu", …, "inlined", "explicit".
std::string_view algebra_name(const Variant& variant);

/// Returns whether it solves all unknowns at once with dense matrices, at O(n³) a step.
bool is_dense_global(const Variant& variant);

/// Returns whether its phases can be measured apart (generated elimination has none).
bool has_phases(const Variant& variant);

/// Why a variant does not offer these settings, in a sentence without a full stop; empty when it
/// does. What it names is not applicable: it is refused, never silently replaced.
std::string unsupported_reason(const Variant& variant, const Settings& settings);

/// Why settings that a variant offers cannot be had on this machine, as unsupported_reason says it;
/// empty when they can.
std::string unavailable_reason(const Settings& settings);

/// Why the variant of that id, which this build has, cannot be had on this machine; empty when it
/// can, and when there is no such variant.
std::string unavailable_reason(std::string_view id);

/// Returns which variants are missing because a library that was found, or named, does not serve,
/// and why: a line each. A library that is simply not there is none.
std::vector<std::string> faulty_libraries();

/// Analyses the mechanism and allocates everything. Parts of types for which there is no generated
/// code are evaluated automatically and are not `as_named`. `profile`, when given, receives the
/// time of its phases on the caller's thread; `table`, when given, has generated code beside what
/// desmo was built with; both must outlive the formulation. Throws std::invalid_argument, naming
/// the place, for a mechanism that it cannot solve, and with the reason for settings that it does
/// not offer (unsupported_reason, unavailable_reason).
std::unique_ptr<Formulation> make_formulation(const Variant& variant, const Model& model,
                                              const Settings& settings = {},
                                              Profile* profile = nullptr,
                                              const KernelTable* table = nullptr);

/// Libraries of the linear algebra in this build and their versions, by backend name.
std::vector<std::pair<std::string, std::string>> library_versions();

}  // namespace desmo
