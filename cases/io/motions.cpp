#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "cases/io/readers.h"
#include "cases/mechanism/formatted.h"
#include "cases/mechanism/names.h"

namespace desmo {
namespace {

constexpr std::size_t max_coefficients = 100;

std::vector<double> read_numbers(const JsonValue& list, double unit) {
  std::vector<double> numbers;
  for (const JsonValue& value : list.elements()) numbers.push_back(value.number() * unit);
  return numbers;
}

/// A unit of numbers in a file, and exactly. Lengths count as the doubles nearest to them.
struct ExactUnit {
  double rounded;
  Derived exact;

  explicit ExactUnit(double unit) : rounded(unit), exact(unit) {}
  ExactUnit(double unit, const Derived& exactly) : rounded(unit), exact(exactly) {}
  static ExactUnit of_angle(double unit) {
    return {unit, unit == 1 ? Derived(1) : Derived::pi() / 180};
  }

  double read(const JsonValue& value, std::vector<Remainder>& remainders) const {
    const double number = value.number(), result = number * rounded;
    const bool is_number = std::isfinite(result);
    remainders.push_back(is_number ? (exact * number).about(result).remainder() : Remainder());
    return result;
  }
};

// What is open is refused where it would be used.
[[noreturn]] void complain_of_open_unit(const JsonValue& value, const std::string& kind,
                                        std::string_view name) {
  value.complain("the mechanism has its " + kind + "s in '" + std::string(name) +
                 "', and the scene does not say in what this is; give \"version\": 2, in which the "
                 "mechanism's units hold, or \"units\": {\"" +
                 kind + "\": \"" + std::string(name) + "\"}");
}

double angle_unit(const JsonValue& value, const FileUnits& units) {
  if (units.angle_is_open) complain_of_open_unit(value, "angle", units.angle.name);
  return units.angle.in_si;
}

double length_unit(const JsonValue& value, const FileUnits& units) {
  if (units.length_is_open) complain_of_open_unit(value, "length", units.length.name);
  return units.length.in_si;
}

Motion read_constant(const JsonValue& value, const ExactUnit& unit) {
  value.allow({"type", "value"});
  Polynomial constant;
  constant.coefficients.push_back(unit.read(value["value"], constant.remainders));
  return constant;
}

Motion read_polynomial(const JsonValue& value, const ExactUnit& unit) {
  value.allow({"type", "coefficients"});
  const JsonValue coefficients = value["coefficients"];
  const std::size_t count = coefficients.elements().size();
  if (count < 1 || count > max_coefficients)
    coefficients.complain("has " + std::to_string(count) + " coefficients; give 1 to " +
                          std::to_string(max_coefficients));
  Polynomial polynomial;
  for (const JsonValue& c : coefficients.elements())
    polynomial.coefficients.push_back(unit.read(c, polynomial.remainders));
  return polynomial;
}

Motion read_harmonic(const JsonValue& value, const ExactUnit& unit, const FileUnits& units) {
  value.allow({"type", "mean", "terms"});
  const ExactUnit hertz{2 * std::numbers::pi, Derived::pi() * 2};
  HarmonicSum sum;
  std::vector<Remainder>& remainders = sum.remainders;
  if (const auto mean = value.find("mean"))
    sum.mean = unit.read(*mean, remainders);
  else
    remainders.emplace_back();
  const JsonValue terms = value["terms"];
  for (const JsonValue& term : terms.elements()) {
    term.allow({"amplitude", "frequency", "phase"});
    HarmonicSum::Term& t = sum.terms.emplace_back();
    t.amplitude = unit.read(term["amplitude"], remainders);
    t.angular_frequency = hertz.read(term["frequency"], remainders);
    if (const auto phase = term.find("phase"))
      t.phase = ExactUnit::of_angle(angle_unit(*phase, units)).read(*phase, remainders);
    else
      remainders.emplace_back();
  }
  if (sum.terms.empty()) terms.complain("has no terms; give one, or a motion of type 'constant'");
  return sum;
}

SplineEnds read_ends(const JsonValue& value) {
  constexpr std::array<std::string_view, 3> names{"natural", "clamped", "periodic"};
  constexpr std::array ends{SplineEnds::natural, SplineEnds::clamped, SplineEnds::periodic};
  return ends[value.choose("ends", names)];
}

Motion read_table(const JsonValue& value, double unit) {
  value.allow({"type", "times", "values", "ends"});
  const JsonValue times = value["times"], values = value["values"];
  std::vector<double> t = read_numbers(times, 1), z = read_numbers(values, unit);
  if (t.size() != z.size())
    values.complain("has " + std::to_string(z.size()) + " values for " + std::to_string(t.size()) +
                    " times; give as many");
  if (t.size() < 2)
    times.complain("has " + std::to_string(t.size()) + " times; a table needs 2 or more");
  for (std::size_t i = 1; i < t.size(); ++i)
    if (!(t[i] > t[i - 1]))
      times.elements()[i].complain("is not after the time before it; give ascending times");
  const auto given = value.find("ends");
  try {
    return make_spline(std::move(t), std::move(z), given ? read_ends(*given) : SplineEnds::natural);
  } catch (const std::invalid_argument& error) {
    value.complain(std::string(error.what()) + "; change the table or its ends");
  }
}

std::vector<int> driven_coordinates(const Mechanism& mechanism) {
  std::vector<int> driven;
  for (int i = 0; i < static_cast<int>(mechanism.coordinates.size()); ++i)
    if (mechanism.coordinates[i].driven) driven.push_back(i);
  return driven;
}

[[noreturn]] void complain_not_driven(const JsonValue& value, const Mechanism& mechanism,
                                      const NameTable& drivers) {
  for (const Mechanism::Coordinate& c : mechanism.coordinates)
    if (c.name == value.key())
      value.complain("the coordinate " + in_quotes(c.name) +
                     " is not driven; name it in the mechanism's drivers or leave its motion out");
  drivers.find(value, value.key());
  value.complain("is not driven; leave it out");
}

Motion read_motion(const JsonValue& value, Mechanism::CoordinateType coordinate,
                   const FileUnits& units) {
  const ExactUnit unit = coordinate == Mechanism::CoordinateType::angle
                             ? ExactUnit::of_angle(angle_unit(value, units))
                             : ExactUnit(length_unit(value, units));
  constexpr std::array<std::string_view, 4> types{"constant", "polynomial", "harmonic", "table"};
  switch (value["type"].choose("type of motion", types)) {
    case 0:
      return read_constant(value, unit);
    case 1:
      return read_polynomial(value, unit);
    case 2:
      return read_harmonic(value, unit, units);
    default:
      return read_table(value, unit.rounded);
  }
}

}  // namespace

std::vector<Motion> read_motions(const JsonValue& root, const Mechanism& mechanism,
                                 const FileUnits& units, std::vector<Motion> known) {
  const std::vector<int> driven = driven_coordinates(mechanism);
  std::vector<bool> has_motion(driven.size(), known.size() == driven.size());
  known.resize(driven.size());
  const auto given = root.find("motion");
  if (given) {
    NameTable drivers("driven coordinate");
    for (const int c : driven) drivers.add(mechanism.coordinates[c].name);
    for (const JsonValue& value : given->members()) {
      const auto i = drivers.position(value.key());
      if (!i) complain_not_driven(value, mechanism, drivers);
      known[*i] = read_motion(value, mechanism.coordinates[driven[*i]].type, units);
      has_motion[*i] = true;
    }
  }
  for (std::size_t i = 0; i < driven.size(); ++i)
    if (!has_motion[i])
      given.value_or(root).complain("the driven coordinate " +
                                    in_quotes(mechanism.coordinates[driven[i]].name) +
                                    " has no motion; give one in \"motion\"");
  return known;
}

void check_tables(const JsonValue& root, const Mechanism& mechanism,
                  const std::vector<Motion>& motions, const TimeGrid& grid) {
  const std::vector<int> driven = driven_coordinates(mechanism);
  const double rounding = 1e-6 * grid.step;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const auto* const spline = std::get_if<Spline>(&motions[i]);
    if (!spline || (grid.time(0) >= spline->first_time() - rounding &&
                    grid.time(grid.instants - 1) <= spline->last_time() + rounding))
      continue;
    const std::string& name = mechanism.coordinates[driven[i]].name;
    root.find("time").value_or(root).complain(
        "the table of " + in_quotes(name) +
        formatted(" reaches only from %g s to %g s; analyse no other times or extend it",
                  spline->first_time(), spline->last_time()));
  }
}

}  // namespace desmo
