#pragma once

#include <stdexcept>
#include <string>

namespace desmo {

/// Error that validate(const Mechanism&) throws. It names the wrong entry, so that a parser can
/// point at its position in the file.
class MechanismError : public std::invalid_argument {
 public:
  enum class Part { description, point, vector, body, joint, coordinate };

  MechanismError(Part part, int index, const std::string& message)
      : std::invalid_argument(message), part_(part), index_(index) {}

  Part part() const { return part_; }
  int index() const { return index_; }  ///< index in the part's list

 private:
  Part part_;
  int index_;
};

}  // namespace desmo
