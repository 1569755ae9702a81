#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "formulations/algebra/linear_solver.h"
#include "formulations/base/settings.h"
#include "formulations/equations/pattern.h"

namespace desmo {

/// Reason why a library that is loaded at run time is absent.
struct Absence {
  std::string reason;   ///< text for unavailable_reason; empty: it is present
  bool faulty = false;  ///< a library was found or named, but cannot be used
};

/// Library that solves linear systems.
struct Backend {
  std::string_view name;
  bool dense = false;
  /// Makes a solver of systems with this pattern, as the settings say. Throws std::invalid_argument
  /// when the library cannot analyse the pattern.
  std::unique_ptr<LinearSolver> (*make_solver)(const Pattern&, const Settings&);
  std::string (*version)();               ///< returns the library's version as text
  Absence (*absence)() = nullptr;         ///< null: it is linked, so always present
  bool allocates = false;                 ///< takes memory from the heap in every factorisation
  bool has_btf = false;                   ///< offers Settings::btf
  std::string_view slow_reason{};         ///< why it is slow in any partition; empty: it is not
  std::string_view slow_blocks_reason{};  ///< why it is slow in blocks; empty: it is not
};

/// Backend::slow_blocks_reason of libraries that have much to do before they factorise.
inline constexpr std::string_view slow_in_blocks =
    "a library's overhead is all there is in blocks this small";

/// Returns a version as text: "5.10.1".
inline std::string version_text(int major, int minor, int patch) {
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

/// Makes a solver of a class whose constructor takes only the pattern.
template <class Solver>
std::unique_ptr<LinearSolver> make_solver(const Pattern& pattern, const Settings&) {
  return std::make_unique<Solver>(pattern);
}

/// Returns the libraries of this build that are present on this machine, in a fixed order.
std::span<const Backend* const> backends();

/// Returns the present library of that name; null: there is none.
const Backend* find_backend(std::string_view name);

/// Returns the libraries of this build that are absent on this machine.
std::span<const Backend* const> absent_backends();

}  // namespace desmo
