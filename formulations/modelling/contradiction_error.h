#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "cases/io/units.h"
#include "cases/mechanism/formatted.h"

namespace desmo {

/// Refusal of a mechanism whose constraints contradict each other or the drawing. Its text says by
/// how much, in the unit of lengths inside or, for people, in that of their file.
class ContradictionError : public std::invalid_argument {
 public:
  /// before, after: the text around the amount. unit: "m"; "1" where the amount is no length in a
  /// known unit.
  ContradictionError(std::string before, double amount, std::string after, const std::string& unit)
      : std::invalid_argument(before + written(amount, {unit}) + after),
        before_(std::move(before)),
        after_(std::move(after)),
        amount_(amount),
        has_unit_(unit != "1") {}

  /// Returns the text with the amount in another unit of lengths.
  std::string text(const DisplayUnit& length) const {
    return has_unit_ ? before_ + written(amount_, length) + after_ : what();
  }

 private:
  static std::string written(double amount, const DisplayUnit& unit) {
    return formatted("%.2g", unit.from_si(amount)) + (unit.name == "1" ? "" : " " + unit.name);
  }

  std::string before_, after_;
  double amount_;
  bool has_unit_;
};

}  // namespace desmo
