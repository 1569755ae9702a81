#pragma once

#include <stdexcept>

namespace desmo::load {

/// An error that prevents generated code. Its message names the thing, the error and, where there
/// is one, a remedy: "<thing>: <error>; <remedy>".
class Unavailable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace desmo::load
