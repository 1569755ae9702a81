#pragma once

#include <array>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#include "formulations/variants.h"

namespace desmo::fuzz {

/// The permitted outcomes of an input, by how far it got.
enum class TrialOutcome {
  refused_as_file,
  refused_as_mechanism,    ///< by model()
  refused_by_formulation,  ///< by make_formulation()
  not_solved,              ///< a summary says why
  solved,
};
constexpr std::array<const char*, 5> outcome_names = {
    "refused as file", "refused as mechanism", "refused by formulation", "not solved", "solved"};

/// A finding: behaviour that no input may cause. The first line of the message is its class, which
/// inputs with the same cause should share.
class Finding : public std::runtime_error {
 public:
  Finding(const std::string& kind, const std::string& detail)
      : std::runtime_error(kind + "\n" + detail) {}
};

/// Reads a mechanism or scene file, models it, plans its requests and solves a few instants. Throws
/// Finding. folder: location of the files that it refers to.
TrialOutcome attempt(std::string_view text, const std::filesystem::path& folder,
                     const Variant& variant);

}  // namespace desmo::fuzz
