#pragma once

#include <stdexcept>

namespace desmo::load {

/// Why there can be no code, and the remedy: "<thing>: <what is wrong>; <remedy>".
class Unavailable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace desmo::load
