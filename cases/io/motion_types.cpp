#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "cases/io/readers.h"
#include "cases/mechanism/drawing.h"

namespace desmo {
namespace {

constexpr std::size_t max_coefficients = 100;

Derived read_number(const JsonValue& value, const DisplayUnit& unit) {
  const double number = value.number(), result = unit.to_si(number);
  if (!std::isfinite(result)) return result;
  return {result, (exact_size(unit) * number).about(result).remainder()};
}

Derived read_exactly(const JsonValue& value, const DisplayUnit& unit) {
  return exact_size(unit) * value.number();
}

/// Returns the unit of lengths or angles. Throws InputError where the file leaves it open; value:
/// the number, or the motion, that needs it.
const DisplayUnit& unit_of(const JsonValue& value, bool is_angle, const FileUnits& units) {
  const DisplayUnit& unit = units.of(is_angle);
  if (!(is_angle ? units.angle_is_open : units.length_is_open)) return unit;
  const std::string kind = is_angle ? "angle" : "length";
  value.complain("the mechanism has its " + kind + "s in '" + unit.name +
                 "', and the scene does not say in what this is; give \"version\": 2, in which the "
                 "mechanism's units hold, or \"units\": {\"" +
                 kind + "\": \"" + unit.name + "\"}");
}

struct MotionReader {
  const JsonValue& value;
  const Mechanism& mechanism;
  const Mechanism::Coordinate& coordinate;
  const FileUnits& units;
  NamedFiles& files;
  bool is_angle = coordinate.is_angle();
  const DisplayUnit& unit = unit_of(value, is_angle, units);

  Motion read() const {
    static constexpr std::array<std::string_view, 6> types{"constant", "polynomial", "harmonic",
                                                           "table",    "speed",      "trapezoid"};
    static constexpr std::array readers{&MotionReader::constant, &MotionReader::polynomial,
                                        &MotionReader::harmonic, &MotionReader::table,
                                        &MotionReader::speed,    &MotionReader::trapezoid};
    value.require_object(R"({"type": "speed", "value": 360})");
    const std::size_t type = value["type"].choose("type of motion", types);
    Motion motion = (this->*readers[type])();
    const auto from = value.find("from");
    const bool moves_from_drawing = types[type] == "speed" || types[type] == "trapezoid";
    if (!from && !moves_from_drawing) return motion;
    const auto start = from ? read_from(*from, unit) : std::nullopt;
    return shifted(std::move(motion),
                   start ? *start : Drawing<Derived>{mechanism}.value(coordinate));
  }

  Motion constant() const {
    value.allow({"type", "value", "from"});
    return Polynomial{{read_number(value["value"], unit)}};
  }

  Motion polynomial() const {
    value.allow({"type", "coefficients", "from"});
    const JsonValue coefficients = value["coefficients"];
    const std::size_t count = coefficients.elements().size();
    if (count < 1 || count > max_coefficients)
      coefficients.complain("has " + std::to_string(count) + " coefficients; give 1 to " +
                            std::to_string(max_coefficients));
    Polynomial polynomial;
    for (const JsonValue& c : coefficients.elements())
      polynomial.coefficients.push_back(read_number(c, unit));
    return polynomial;
  }

  Motion harmonic() const {
    value.allow({"type", "mean", "terms", "from"});
    const DisplayUnit hertz{"Hz", 2 * std::numbers::pi};
    HarmonicSum sum;
    if (const auto mean = value.find("mean")) sum.mean = read_number(*mean, unit);
    const JsonValue terms = value["terms"];
    for (const JsonValue& term : terms.elements()) {
      term.allow({"amplitude", "frequency", "phase"});
      HarmonicSum::Term& t = sum.terms.emplace_back();
      t.amplitude = read_number(term["amplitude"], unit);
      t.angular_frequency = read_number(term["frequency"], hertz);
      if (const auto phase = term.find("phase"))
        t.phase = read_number(*phase, unit_of(*phase, true, units));
    }
    if (sum.terms.empty()) terms.complain("has no terms; give one, or a motion of type 'constant'");
    return sum;
  }

  Motion table() const {
    value.allow({"type", "times", "values", "file", "ends", "from"});
    static const DisplayUnit second{"s", 1};
    TableColumn times{"times", "t", second, {&second, 1}},
        values = column_of("values", coordinate, units);
    read_table(value, files, mechanism.coordinates, times, values);
    try {
      Spline spline =
          make_spline(std::move(times.numbers), std::move(values.numbers), read_ends(value, false));
      if (values.unit.in_si != 1) spline.scale(exact_size(values.unit));
      return spline;
    } catch (const std::invalid_argument& error) {
      value.complain(std::string(error.what()) + "; change the table or its ends");
    }
  }

  Motion speed() const {
    value.allow({"type", "value", "acceleration", "unit", "from"});
    const auto named = value.find("unit"), acceleration = value.find("acceleration");
    const DisplayUnit rate = named ? read_rate_unit(*named, is_angle, units.base_length()) : unit;
    Polynomial motion{{0, read_number(value["value"], rate)}};
    if (acceleration)
      motion.coefficients.push_back((read_exactly(*acceleration, rate) / 2).rounded());
    return motion;
  }

  Motion trapezoid() const {
    value.allow({"type", "by", "velocity", "acceleration", "start", "from"});
    const auto limit = [&](const char* key) {
      const JsonValue given = value[key];
      if (!(given.number() > 0)) given.complain("is a limit, and not above 0; give one that is");
      return read_exactly(given, unit);
    };
    const JsonValue by = value["by"];
    if (by.number() == 0) by.complain("is 0, no motion; give one of type 'constant'");
    const auto start = value.find("start");
    try {
      return make_spline(Trapezoid{read_exactly(by, unit), limit("velocity"), limit("acceleration"),
                                   start ? start->number() : 0});
    } catch (const std::invalid_argument& error) {
      value.complain(std::string(error.what()) + "; change its limits");
    }
  }
};

}  // namespace

std::optional<Derived> read_from(const JsonValue& from, const DisplayUnit& unit) {
  if (from.is_number()) return read_exactly(from, unit);
  constexpr std::array<std::string_view, 1> names{"drawing"};
  from.choose("start", names);
  return std::nullopt;
}

Motion read_motion(const JsonValue& value, const Mechanism& mechanism,
                   const Mechanism::Coordinate& coordinate, const FileUnits& units,
                   NamedFiles& files) {
  return MotionReader{value, mechanism, coordinate, units, files}.read();
}

}  // namespace desmo
