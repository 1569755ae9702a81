#pragma once

#include <stdexcept>
#include <string>

namespace desmo {

/// Returns the message of the Error by which some work is refused; "accepted": it is not.
template <class Error = std::invalid_argument>
std::string refusal(const auto& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace desmo
