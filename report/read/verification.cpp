#include "report/read/verification.h"

#include "report/text/digits.h"

namespace desmo::report {

std::string excess(const std::string& what, double difference, double limit) {
  if (difference <= limit) return {};
  return what + " differs by " + write_shortest(difference) + ", " + write_shortest(limit) +
         " is allowed";
}

std::string excess(const Verification& found, const Allowed& allowed) {
  std::string text;
  const auto compare = [&text](const char* what, double difference, double limit) {
    const std::string reason = excess(what, difference, limit);
    if (!reason.empty()) text += (text.empty() ? "" : "; ") + reason;
  };
  compare("position", found.position, allowed.position);
  compare("velocity", found.velocity, allowed.velocity);
  compare("acceleration", found.acceleration, allowed.acceleration);
  return text;
}

}  // namespace desmo::report
