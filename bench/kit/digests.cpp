#include "bench/kit/digests.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>
#include <variant>

namespace desmo::bench {

namespace {

/// Writes a model as text that depends on nothing else: a word and numbers a line.
class ModelText {
 public:
  ModelText& word(std::string_view text) {
    text_ += text;
    text_ += ' ';
    return *this;
  }

  ModelText& whole(long long value) { return word(std::to_string(value)); }

  ModelText& real(double value) {
    std::array<char, 400> digits;  // the largest double has 309 before the point
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                   std::chars_format::fixed, 9)
                         .ptr;
    const std::string_view written(digits.data(), end);
    return word(written == "-0.000000000" ? written.substr(1) : written);
  }

  ModelText& reals(std::span<const double> values) {
    whole(static_cast<long long>(values.size()));
    for (const double value : values) real(value);
    return *this;
  }

  ModelText& wholes(std::span<const int> values) {
    whole(static_cast<long long>(values.size()));
    for (const int value : values) whole(value);
    return *this;
  }

  void end_line() { text_.back() = '\n'; }

  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

void describe(ModelText& d, const Polynomial& motion) {
  d.word("polynomial").reals(motion.coefficients);
}

void describe(ModelText& d, const HarmonicSum& motion) {
  d.word("harmonics").real(motion.mean);
  for (const HarmonicSum::Term& term : motion.terms)
    d.real(term.amplitude).real(term.angular_frequency).real(term.phase);
}

void describe(ModelText& d, const Spline& motion) {
  d.word("spline").reals(motion.knots());
  for (const Spline::Piece& piece : motion.pieces()) d.reals(piece);
}

}  // namespace

std::string model_digest(const Model& m) {
  ModelText d;
  d.word("mechanism").word(m.name).word(m.length_unit).end_line();
  for (const Entity& e : m.entities) {
    d.word("entity").whole(static_cast<int>(e.kind)).whole(e.fixed).whole(e.first).whole(e.size);
    d.whole(e.group).end_line();
  }
  for (const Constraint& c : m.constraints) {
    d.word("constraint").word(constraint_kind_name(c.kind)).wholes(c.operands).reals(c.constants);
    d.whole(c.group).whole(c.left_out).end_line();
  }
  for (const Group& g : m.groups)
    d.word("group").wholes(g.entities).wholes(g.after).whole(g.constant).end_line();
  for (const Driver& driver : m.drivers) {
    d.word("driver").whole(driver.coordinate);
    std::visit([&](const auto& motion) { describe(d, motion); }, driver.motion);
    d.end_line();
  }
  d.word("estimate").reals(m.estimate).end_line();
  d.word("fixed").reals(m.fixed_values).end_line();
  return Digest().add(d.text()).hex();
}

std::int64_t rounded(double value, double reference, double unit) {
  const double counted = std::abs(value - reference) <= unit ? reference : value;
  const double multiple = std::nearbyint(counted / unit);
  return std::abs(multiple) <= 1e18 ? static_cast<std::int64_t>(multiple)
                                    : std::numeric_limits<std::int64_t>::max();
}

}  // namespace desmo::bench
