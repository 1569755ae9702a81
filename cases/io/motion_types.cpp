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

double read_number(const JsonValue& value, const DisplayUnit& unit,
                   std::vector<Remainder>& remainders) {
  const double number = value.number(), result = unit.to_si(number);
  const bool is_number = std::isfinite(result);
  remainders.push_back(is_number ? (exact_size(unit) * number).about(result).remainder()
                                 : Remainder());
  return result;
}

Derived read_exactly(const JsonValue& value, const DisplayUnit& unit) {
  return exact_size(unit) * value.number();
}

// What is open is refused where it would be used.
[[noreturn]] void complain_of_open_unit(const JsonValue& value, const std::string& kind,
                                        std::string_view name) {
  value.complain("the mechanism has its " + kind + "s in '" + std::string(name) +
                 "', and the scene does not say in what this is; give \"version\": 2, in which the "
                 "mechanism's units hold, or \"units\": {\"" +
                 kind + "\": \"" + std::string(name) + "\"}");
}

const DisplayUnit& angle_unit(const JsonValue& value, const FileUnits& units) {
  if (units.angle_is_open) complain_of_open_unit(value, "angle", units.angle.name);
  return units.angle;
}

const DisplayUnit& length_unit(const JsonValue& value, const FileUnits& units) {
  if (units.length_is_open) complain_of_open_unit(value, "length", units.length.name);
  return units.length;
}

class MotionReader {
 public:
  MotionReader(const JsonValue& value, const Mechanism& mechanism,
               const Mechanism::Coordinate& coordinate, const FileUnits& units, NamedFiles& files)
      : value_(value),
        mechanism_(mechanism),
        coordinate_(coordinate),
        is_angle_(coordinate.type == Mechanism::CoordinateType::angle),
        units_(units),
        unit_(is_angle_ ? angle_unit(value, units) : length_unit(value, units)),
        files_(files) {}

  Motion read() const {
    static constexpr std::array<std::string_view, 6> types{"constant", "polynomial", "harmonic",
                                                           "table",    "speed",      "trapezoid"};
    static constexpr std::array readers{&MotionReader::constant, &MotionReader::polynomial,
                                        &MotionReader::harmonic, &MotionReader::table,
                                        &MotionReader::speed,    &MotionReader::trapezoid};
    const std::size_t type = value_["type"].choose("type of motion", types);
    Motion motion = (this->*readers[type])();
    const auto from = value_.find("from");
    const bool moves_from_drawing = types[type] == "speed" || types[type] == "trapezoid";
    if (!from && !moves_from_drawing) return motion;
    return shifted(std::move(motion), from ? read_from(*from) : drawn());
  }

 private:
  Derived drawn() const { return Drawing<Derived>{mechanism_}.value(coordinate_); }

  Derived read_from(const JsonValue& from) const {
    if (from.is_number()) return read_exactly(from, unit_);
    constexpr std::array<std::string_view, 1> names{"drawing"};
    from.choose("start", names);
    return drawn();
  }

  Motion constant() const {
    value_.allow({"type", "value", "from"});
    Polynomial constant;
    constant.coefficients.push_back(read_number(value_["value"], unit_, constant.remainders));
    return constant;
  }

  Motion polynomial() const {
    value_.allow({"type", "coefficients", "from"});
    const JsonValue coefficients = value_["coefficients"];
    const std::size_t count = coefficients.elements().size();
    if (count < 1 || count > max_coefficients)
      coefficients.complain("has " + std::to_string(count) + " coefficients; give 1 to " +
                            std::to_string(max_coefficients));
    Polynomial polynomial;
    for (const JsonValue& c : coefficients.elements())
      polynomial.coefficients.push_back(read_number(c, unit_, polynomial.remainders));
    return polynomial;
  }

  Motion harmonic() const {
    value_.allow({"type", "mean", "terms", "from"});
    const DisplayUnit hertz{"Hz", 2 * std::numbers::pi};
    HarmonicSum sum;
    std::vector<Remainder>& remainders = sum.remainders;
    if (const auto mean = value_.find("mean"))
      sum.mean = read_number(*mean, unit_, remainders);
    else
      remainders.emplace_back();
    const JsonValue terms = value_["terms"];
    for (const JsonValue& term : terms.elements()) {
      term.allow({"amplitude", "frequency", "phase"});
      HarmonicSum::Term& t = sum.terms.emplace_back();
      t.amplitude = read_number(term["amplitude"], unit_, remainders);
      t.angular_frequency = read_number(term["frequency"], hertz, remainders);
      if (const auto phase = term.find("phase"))
        t.phase = read_number(*phase, angle_unit(*phase, units_), remainders);
      else
        remainders.emplace_back();
    }
    if (sum.terms.empty()) terms.complain("has no terms; give one, or a motion of type 'constant'");
    return sum;
  }

  Motion table() const {
    value_.allow({"type", "times", "values", "file", "ends", "from"});
    static const DisplayUnit second{"s", 1};
    TableColumn times{"times", "t", second, {&second, 1}},
        values = column_of("values", coordinate_, units_);
    read_table(value_, files_, mechanism_.coordinates, times, values);
    try {
      Spline spline = make_spline(std::move(times.numbers), std::move(values.numbers),
                                  read_ends(value_, false));
      if (values.unit.in_si != 1) spline.scale(exact_size(values.unit));
      return spline;
    } catch (const std::invalid_argument& error) {
      value_.complain(std::string(error.what()) + "; change the table or its ends");
    }
  }

  Motion speed() const {
    value_.allow({"type", "value", "acceleration", "unit", "from"});
    const auto named = value_.find("unit"), acceleration = value_.find("acceleration");
    const DisplayUnit unit =
        named ? read_rate_unit(*named, is_angle_, units_.base_length()) : unit_;
    Polynomial motion{{0}, {Remainder()}};
    motion.coefficients.push_back(read_number(value_["value"], unit, motion.remainders));
    if (!acceleration) return motion;
    const Derived half = (read_exactly(*acceleration, unit) / 2).rounded();
    motion.coefficients.push_back(half.value);
    motion.remainders.push_back(half.remainder());
    return motion;
  }

  Motion trapezoid() const {
    value_.allow({"type", "by", "velocity", "acceleration", "start", "from"});
    const auto limit = [&](const char* key) {
      const JsonValue value = value_[key];
      if (!(value.number() > 0)) value.complain("is a limit, and not above 0; give one that is");
      return read_exactly(value, unit_);
    };
    const JsonValue by = value_["by"];
    if (by.number() == 0) by.complain("is 0, no motion; give one of type 'constant'");
    const auto start = value_.find("start");
    try {
      return make_spline(Trapezoid{read_exactly(by, unit_), limit("velocity"),
                                   limit("acceleration"), start ? start->number() : 0});
    } catch (const std::invalid_argument& error) {
      value_.complain(std::string(error.what()) + "; change its limits");
    }
  }

  const JsonValue& value_;
  const Mechanism& mechanism_;
  const Mechanism::Coordinate& coordinate_;
  bool is_angle_;
  const FileUnits& units_;
  const DisplayUnit& unit_;
  NamedFiles& files_;
};

}  // namespace

Motion read_motion(const JsonValue& value, const Mechanism& mechanism,
                   const Mechanism::Coordinate& coordinate, const FileUnits& units,
                   NamedFiles& files) {
  return MotionReader(value, mechanism, coordinate, units, files).read();
}

}  // namespace desmo
