#pragma once

#include <string>
#include <string_view>

#include "formulations/base/settings.h"
#include "formulations/variants.h"

namespace desmo {

/// A formulation with its settings:
///
///   const Configuration c = parse_id("group_symbolic_explicit/guess:hermite5/lanes:4");
///   const auto formulation = make_formulation(*c.variant, model, c.settings);
struct Configuration {
  const Variant* variant;  ///< entry of variants()
  Settings settings;
};

/// Returns the id of a variant with these settings. Settings that differ from the defaults, which
/// are the paper's, follow as suffixes in this order; max_iterations has none:
///   <partition>_<equations>_<algebra>
///     /coordinates:basis|reference|relative  /frames:exact
///     /guess:linear|quadratic|hermite3|hermite5|adams8  /jacobian:step  /btf:off  /lanes:4|8
///     /segments:4|8  /threads:2…  /stride:2…64  /iterations:1…1000  /tolerance:1e-6
std::string id_with(const Variant& variant, const Settings& settings);

/// Returns the variant and the settings that an id names, its suffixes in any order. base: values
/// of the settings that the id does not name. Throws std::invalid_argument:
/// - for an unknown formulation, suffix or value, naming what could stand there
/// - for a suffix that is given twice
/// - with the reason, for a formulation that this machine cannot run (unavailable_reason) or
///   settings that it does not offer (unsupported_reason)
Configuration parse_id(std::string_view id, const Settings& base = {});

}  // namespace desmo
