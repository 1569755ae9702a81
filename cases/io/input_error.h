#pragma once

#include <stdexcept>

namespace desmo {

/// Bad input. The message is "<file>: <place>: <what is wrong>; <remedy>"; the place is a line and
/// a column where the text is not JSON, otherwise a JSON pointer such as /joints/2/points/0, "top
/// level" for the whole document, and left out when the file cannot be read at all. Names from the
/// input are shortened, and escaped for terminals.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace desmo
