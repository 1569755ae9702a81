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
  Derived read(const JsonValue& value) const { return exact * value.number(); }
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

class MotionReader {
 public:
  MotionReader(const JsonValue& value, const Mechanism& mechanism,
               const Mechanism::Coordinate& coordinate, const FileUnits& units, NamedFiles& files)
      : value_(value),
        mechanism_(mechanism),
        coordinate_(coordinate),
        is_angle_(coordinate.type == Mechanism::CoordinateType::angle),
        units_(units),
        unit_(is_angle_ ? ExactUnit::of_angle(angle_unit(value, units))
                        : ExactUnit(length_unit(value, units))),
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
    if (from.is_number()) return unit_.read(from);
    constexpr std::array<std::string_view, 1> names{"drawing"};
    from.choose("start", names);
    return drawn();
  }

  Motion constant() const {
    value_.allow({"type", "value", "from"});
    Polynomial constant;
    constant.coefficients.push_back(unit_.read(value_["value"], constant.remainders));
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
      polynomial.coefficients.push_back(unit_.read(c, polynomial.remainders));
    return polynomial;
  }

  Motion harmonic() const {
    value_.allow({"type", "mean", "terms", "from"});
    const ExactUnit hertz{2 * std::numbers::pi, Derived::pi() * 2};
    HarmonicSum sum;
    std::vector<Remainder>& remainders = sum.remainders;
    if (const auto mean = value_.find("mean"))
      sum.mean = unit_.read(*mean, remainders);
    else
      remainders.emplace_back();
    const JsonValue terms = value_["terms"];
    for (const JsonValue& term : terms.elements()) {
      term.allow({"amplitude", "frequency", "phase"});
      HarmonicSum::Term& t = sum.terms.emplace_back();
      t.amplitude = unit_.read(term["amplitude"], remainders);
      t.angular_frequency = hertz.read(term["frequency"], remainders);
      if (const auto phase = term.find("phase"))
        t.phase = ExactUnit::of_angle(angle_unit(*phase, units_)).read(*phase, remainders);
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
    const ExactUnit unit =
        is_angle_ ? ExactUnit::of_angle(values.unit.in_si) : ExactUnit(values.unit.in_si);
    try {
      Spline spline = make_spline(std::move(times.numbers), std::move(values.numbers),
                                  read_ends(value_, false));
      if (unit.rounded != 1) spline.scale(unit.exact);
      return spline;
    } catch (const std::invalid_argument& error) {
      value_.complain(std::string(error.what()) + "; change the table or its ends");
    }
  }

  Motion speed() const {
    value_.allow({"type", "value", "acceleration", "unit", "from"});
    const auto named = value_.find("unit"), acceleration = value_.find("acceleration");
    const ExactUnit unit = named ? read_rate(*named) : unit_;
    Polynomial motion{{0}, {Remainder()}};
    motion.coefficients.push_back(unit.read(value_["value"], motion.remainders));
    if (!acceleration) return motion;
    const Derived half = (unit.read(*acceleration) / 2).rounded();
    motion.coefficients.push_back(half.value);
    motion.remainders.push_back(half.remainder());
    return motion;
  }

  ExactUnit read_rate(const JsonValue& name) const {
    const DisplayUnit unit = read_rate_unit(name, is_angle_, units_.base_length());
    if (unit.name == "rpm") return {unit.in_si, Derived::pi() / 30};
    return is_angle_ ? ExactUnit::of_angle(unit.in_si) : ExactUnit(unit.in_si);
  }

  Motion trapezoid() const {
    value_.allow({"type", "by", "velocity", "acceleration", "start", "from"});
    const auto limit = [&](const char* key) {
      const JsonValue value = value_[key];
      if (!(value.number() > 0)) value.complain("is a limit, and not above 0; give one that is");
      return unit_.read(value);
    };
    const JsonValue by = value_["by"];
    if (by.number() == 0) by.complain("is 0, no motion; give one of type 'constant'");
    const auto start = value_.find("start");
    try {
      return make_spline(Trapezoid{unit_.read(by), limit("velocity"), limit("acceleration"),
                                   start ? start->number() : 0});
    } catch (const std::invalid_argument& error) {
      value_.complain(std::string(error.what()) + "; change its limits");
    }
  }

  const JsonValue& value_;
  const Mechanism& mechanism_;
  const Mechanism::Coordinate& coordinate_;
  bool is_angle_;
  const FileUnits& units_;
  ExactUnit unit_;
  NamedFiles& files_;
};

}  // namespace

Motion read_motion(const JsonValue& value, const Mechanism& mechanism,
                   const Mechanism::Coordinate& coordinate, const FileUnits& units,
                   NamedFiles& files) {
  return MotionReader(value, mechanism, coordinate, units, files).read();
}

}  // namespace desmo
