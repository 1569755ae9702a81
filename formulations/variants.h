#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formulations/formulation.h"
#include "formulations/model/model.h"

namespace desmo {

class KernelTable;  // defined in equations/kernel_table.h

/// A formulation of the suite: a partition of the unknowns, a way to evaluate the equations, and an
/// algebra that solves the linear systems.
struct Variant {
  std::string id;  ///< <partition>_<equations>_<algebra>
  Partition partition;
  Evaluation evaluation;
  std::string_view algebra;  ///< a library, such as "klu", or "inlined" or "explicit"

  /// Returns whether the elimination is generated, too (inlined, explicit).
  bool is_generated() const { return algebra == "inlined" || is_explicit(); }
  /// Returns whether generated code solves one unknown after the other, in closed form where it
  /// can.
  bool is_explicit() const { return algebra == "explicit"; }
};

/// Returns every variant of this build whose library is present on this machine. Tests, benchmarks
/// and documents iterate this table.
std::span<const Variant> variants();

/// Returns the variant of that id. Throws std::invalid_argument: with the reason where the variant
/// cannot be had on this machine (unavailable_reason), else with a list of all ids.
const Variant& find_variant(std::string_view id);

/// Returns why a variant does not offer these settings, in a sentence without a full stop; empty
/// when it does. Settings that are not offered are refused, never silently replaced.
std::string unsupported_reason(const Variant& variant, const Settings& settings);

/// Returns why this machine cannot run settings that a variant offers; empty when it can.
std::string unavailable_reason(const Settings& settings);

/// Returns why this machine cannot run the variant of that id: its library is absent. Empty when it
/// can, and when there is no such variant.
std::string unavailable_reason(std::string_view id);

/// Returns a line for each library that was found, or named by the user, and cannot be used: the
/// variants that are missing, and why. Libraries that are not installed are not listed.
std::vector<std::string> faulty_libraries();

/// Makes a formulation: analyses the model, which must outlive it, and allocates what steps need.
/// Parts for which desmo was built without generated code are inlined or evaluated automatically.
/// Throws std::invalid_argument, naming the place, for a model that it cannot solve, and with the
/// reason for settings that it does not offer (unsupported_reason, unavailable_reason).
std::unique_ptr<Formulation> make_formulation(const Variant& variant, const Model& model,
                                              const Settings& settings = {});
std::unique_ptr<Formulation> make_formulation(const Variant& variant, const Model&& model,
                                              const Settings& settings = {}) = delete;

/// Makes a formulation like the function above, with code that was generated for the model
/// (generate_code). table: must outlive the formulation.
std::unique_ptr<Formulation> make_formulation(const Variant& variant, const Model& model,
                                              const Settings& settings, const KernelTable& table);
std::unique_ptr<Formulation> make_formulation(const Variant& variant, const Model&& model,
                                              const Settings& settings,
                                              const KernelTable& table) = delete;
std::unique_ptr<Formulation> make_formulation(const Variant& variant, const Model& model,
                                              const Settings& settings,
                                              const KernelTable&& table) = delete;

/// Returns the libraries of linear algebra that are present, by backend name, and their versions.
std::vector<std::pair<std::string, std::string>> library_versions();

}  // namespace desmo
