#include "bench/kit/digests.h"

#include <cmath>
#include <limits>
#include <variant>

#include "cases/mechanism/formatted.h"
#include "formulations/runtime/digest.h"

namespace desmo::bench {

namespace {

// text_of() returns numbers as text, with a blank before each. A list begins with its size.

std::string text_of(int value) { return ' ' + std::to_string(value); }

std::string text_of(double value) {
  const std::string text = formatted(" %.9f", value);
  return text == " -0.000000000" ? " 0.000000000" : text;
}

std::string text_of(const Derived& number) { return text_of(number.value); }

std::string text_of(const auto& values) {
  std::string text = ' ' + std::to_string(values.size());
  for (const auto& value : values) text += text_of(value);
  return text;
}

std::string described(const Polynomial& motion) {
  return " polynomial" + text_of(motion.coefficients);
}

std::string described(const HarmonicSum& motion) {
  std::string text = " harmonics" + text_of(motion.mean);
  for (const HarmonicSum::Term& term : motion.terms)
    text += text_of(term.amplitude) + text_of(term.angular_frequency) + text_of(term.phase);
  return text;
}

std::string described(const Spline& motion) {
  std::string text = " spline" + text_of(motion.knots());
  for (const Spline::Piece& piece : motion.pieces()) text += text_of(piece);
  return text;
}

}  // namespace

std::string model_digest(const Model& m) {
  std::string text = "mechanism " + m.name + ' ' + m.length_unit + '\n';
  for (const Entity& e : m.entities)
    text += formatted("entity %d %d %d %d %d\n", static_cast<int>(e.kind), e.fixed, e.first, e.size,
                      e.group);
  for (const Constraint& c : m.constraints)
    text += "constraint " + std::string(constraint_kind_name(c.kind)) + text_of(c.operands) +
            text_of(c.constants) + formatted(" %d %u\n", c.group, c.left_out);
  for (const Group& g : m.groups)
    text += "group" + text_of(g.entities) + text_of(g.after) + formatted(" %d\n", g.constant);
  for (const Driver& driver : m.drivers)
    text += "driver" + text_of(driver.coordinate) +
            std::visit([](const auto& motion) { return described(motion); }, driver.motion) + '\n';
  text += "estimate" + text_of(m.estimate) + "\nfixed" + text_of(m.fixed_values) + '\n';
  return Digest().add(text).hex();
}

std::int64_t nearest_multiple(double value, double reference, double unit) {
  const double counted = std::abs(value - reference) <= unit ? reference : value;
  const double multiple = std::nearbyint(counted / unit);
  return std::abs(multiple) <= 1e18 ? static_cast<std::int64_t>(multiple)
                                    : std::numeric_limits<std::int64_t>::max();
}

}  // namespace desmo::bench
