#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

#include "cases/io/units.h"
#include "cases/mechanism/formatted.h"

namespace desmo {

/// Returns an SI amount in a unit: "0.02 mm"; "0.02" where the unit is "1".
inline std::string in_unit(double amount, const DisplayUnit& unit) {
  return formatted("%.2g", unit.from_si(amount)) + (unit.name == "1" ? "" : " " + unit.name);
}

/// Refusal of a mechanism whose constraints contradict each other or the drawing. Its message says
/// by how much: what() in the model's units, text() in any others, such as those of a file.
class ContradictionError : public std::invalid_argument {
 public:
  using Text = std::function<std::string(const DisplayUnits&)>;

  /// written: writes the text in any units. length: unit of the model's lengths.
  ContradictionError(Text written, const std::string& length)
      : std::invalid_argument(written({.length = {length}})), text(std::move(written)) {}

  const Text text;  ///< function that returns the message in other units
};

}  // namespace desmo
