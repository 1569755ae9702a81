#pragma once

#include <stdexcept>

namespace desmo {

/// Error of bad input. The message is "<file>: <place>: <what is wrong>; <remedy>"; the remedy may
/// be missing. The place is
/// - a line and a column, where the text is not JSON
/// - a JSON pointer such as /joints/2/points/0, or "top level" for the whole document
/// - left out, when the file cannot be read or decompressed
/// Names from the input are shortened, and escaped for terminals.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace desmo
