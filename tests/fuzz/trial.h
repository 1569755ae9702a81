#pragma once

#include <array>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#include "formulations/variants.h"

namespace desmo::fuzz {

/// What may become of an input, by how far it got.
enum class Outcome {
  refused_as_file,
  refused_as_mechanism,    ///< by model()
  refused_by_formulation,  ///< by make_formulation()
  not_solved,              ///< a summary says why
  solved,
};
constexpr std::array<const char*, 5> outcome_names = {
    "refused as file", "refused as mechanism", "refused by formulation", "not solved", "solved"};

/// Something that must not happen, whatever the input. The first line of the message is its class:
/// the same for all inputs with the same cause, as far as can be told.
class Finding : public std::runtime_error {
 public:
  Finding(const std::string& kind, const std::string& detail)
      : std::runtime_error(kind + "\n" + detail) {}
};

/// Goes the whole way with a mechanism or scene file: reads it, models it, plans what it asks for,
/// solves a few instants. Files that it names are sought in `folder`. Throws Finding.
Outcome attempt(std::string_view text, const std::filesystem::path& folder, const Variant& variant);

}  // namespace desmo::fuzz
