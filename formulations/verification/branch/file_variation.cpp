#include "formulations/verification/branch/file_variation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "formulations/constraints/constraints.h"
#include "formulations/model/constraint_at.h"

namespace desmo {

namespace {

constexpr double last_digit = 2 * 0x1p-53;        // relative, of a number of the file
constexpr double stated_digits = 3 * last_digit;  // relative, of a product or ratio of three

/// Factor that covers terms of second order and the rounding of radii.
constexpr double second_order = 1 + 0x1p-20;

template <class Kind>
constexpr bool is_measured = requires(const Derived* const* x, Derived* c) {
  Kind::measure(x, c);
};

/// True for sums of coordinates, whose factors stand in the file.
template <class Kind>
constexpr bool is_coupling = false;
template <int terms>
constexpr bool is_coupling<Coupling<terms>> = true;

/// The drawing of a model, whose numbers vary.
class VariedDrawing {
 public:
  explicit VariedDrawing(const Model& m) : m_(m), state_(m.state_size()) {
    for (const Entity& e : m.entities) {
      // Directions are divided by their lengths, so that each component varies with the others.
      const double direction = e.kind == EntityKind::vector ? last_digit : 0;
      const int first = m_.state_index(static_cast<EntityId>(&e - m.entities.data()));
      for (int i = 0; i < e.size; ++i) {
        const double x = (e.fixed ? m.fixed_values : m.estimate)[e.first + i];
        state_[first + i] = Derived(x, {0, std::max(direction, last_digit * std::abs(x))});
      }
    }
    for (const Constraint& c : m.constraints) vary_line(c);
  }

  double radius(int state) const { return state_[state].radius; }

  /// Widens the dimensions of a constraint, or sets the slack of its rows.
  void vary(Constraint& c) const {
    visit_kind(c.kind, [&]<class Kind>(Kind) {
      if constexpr (has_table<Kind>) {
        vary_table<Kind>(c);
      } else if constexpr (Kind::constants > 0) {
        if constexpr (is_coupling<Kind>) vary_factors<Kind>(c);
        if constexpr (Kind::linear)
          vary_rows<Kind>(c);
        else
          vary_dimensions<Kind>(c);
      }
    });
  }

 private:
  /// Lets a direction vary with the two points that it is measured from.
  void vary_line(const Constraint& c) {
    visit_kind(c.kind, [&]<class Kind>(Kind) {
      if constexpr (Kind::linear && Kind::constants == 1 && is_measured<Kind>) {
        const auto x = operands_of(m_, c, state_.data());
        if (c.constants[0].value == 0) return;
        const int first = m_.state_index(c.operands[2]);
        for (int i = 0; i < Kind::operand_sizes[2]; ++i)
          state_[first + i].radius =
              std::max(state_[first + i].radius,
                       (x[0][i].radius + x[1][i].radius) / std::abs(c.constants[0].value));
      }
    });
  }

  /// Widens dimensions by the variation of the operands that they are measured between. If they
  /// differ from the drawing's, they come from a stated length or a frame. They are then products
  /// or ratios of up to three more numbers.
  template <class Kind>
  void vary_dimensions(Constraint& c) const {
    std::array<Derived, Kind::constants> drawn;
    Kind::measure(operands_of(m_, c, state_.data()).data(), drawn.data());
    bool is_drawn = true;
    for (int k = 0; k < Kind::constants; ++k) {
      const Derived off = drawn[k] - c.constants[k];
      is_drawn &= std::abs(off.value + off.correction) <= drawn[k].radius;
    }
    for (int k = 0; k < Kind::constants; ++k) {
      const double stated = is_drawn ? 0 : stated_digits * std::abs(c.constants[k].value);
      c.constants[k].radius += (drawn[k].radius + stated) * second_order;
    }
  }

  /// Widens the factors of a coupling. The residual that their errors cause grows with the turns of
  /// its angles, so slack would not do.
  template <class Kind>
  void vary_factors(Constraint& c) const {
    for (Derived& factor : std::span(c.constants).first(Kind::operand_sizes.size()))
      factor.radius += last_digit * std::abs(factor.value) * second_order;
  }

  /// Sets the slack of a linear kind, whose factors vary with its operands. The variation changes Φ
  /// by a vector that turns with the body, so each row may be off by the length of that vector.
  /// (Radii of the factors themselves would be multiplied by the distance of points from the
  /// origin.) The slack of a coupling is what its terms vary by at the drawing, where its constant
  /// is measured.
  template <class Kind>
  void vary_rows(Constraint& c) const {
    const auto x = operands_of(m_, c, state_.data());
    std::array<Derived, Kind::rows> phi;
    Kind::residual(x.data(), c.constants.data(), phi.data());
    bool is_drawn = true;
    double squares = 0;
    for (const Derived& row : phi) {
      is_drawn &= std::abs(row.value + row.correction) <= row.radius;
      squares += row.radius * row.radius;
    }
    double radius = std::sqrt(squares);
    if (!is_drawn)
      for (const Derived& factor : c.constants)
        radius += stated_digits * std::abs(factor.value) * reach<Kind>(c);
    c.slack.assign(Kind::rows, radius * second_order);
  }

  /// Sets the slack of a table's equation: the error that the last digits of its arguments and
  /// values may cause. Widens what counts again with each turn of a table that repeats: its length,
  /// by its first and last knot, and its advance.
  template <class Kind>
  void vary_table(Constraint& c) const {
    std::vector<Derived>& numbers = c.constants;
    const auto size = [&](std::size_t k) { return std::abs(numbers[Kind::table + k].value); };
    const auto pieces = static_cast<std::size_t>(numbers[Kind::table].value);
    double largest = 0;  // |value of the table| + |slope × argument|, at knots
    for (std::size_t i = 0; i < pieces; ++i) {
      const std::size_t first = 4 + pieces + 4 * i;
      largest =
          std::max(largest, size(first) + size(first + 1) * std::max(size(3), size(3 + pieces)));
    }
    const double value = std::abs(numbers[0].value) * largest + std::abs(numbers[2].value);
    c.slack.assign(Kind::rows, stated_digits * value * second_order);
    if (numbers[Kind::table + 1].value == 0) return;  // it does not repeat
    const auto widen = [&](std::size_t k, double by) {
      numbers[Kind::table + k].radius += last_digit * by * second_order;
    };
    widen(2, 2 * size(4 + pieces) + size(2));  // last value − first one
    for (const std::size_t knot : {std::size_t{3}, 3 + pieces}) widen(knot, size(knot));
  }

  /// Returns the largest length of a vector, or distance of two points, among a constraint's
  /// operands.
  template <class Kind>
  double reach(const Constraint& c) const {
    const auto x = operands_of(m_, c, state_.data());
    double longest = 0;
    for (std::size_t k = 0; k < Kind::operand_sizes.size(); ++k)
      for (std::size_t other = 0; other <= k; ++other) {
        const bool are_points = is_point(c.operands[k]) && is_point(c.operands[other]);
        if (!are_points && other < k) continue;
        double squares = 0;
        for (int i = 0; i < Kind::operand_sizes[k]; ++i)
          squares += std::pow(x[k][i].value - (are_points ? x[other][i].value : 0), 2);
        longest = std::max(longest, std::sqrt(squares));
      }
    return longest;
  }

  bool is_point(EntityId e) const { return m_.entities[e].kind == EntityKind::point; }

  const Model& m_;
  std::vector<Derived> state_;
};

}  // namespace

Model with_file_variation(const Model& model) {
  const VariedDrawing drawing(model);
  Model varied = model;
  for (Constraint& c : varied.constraints) drawing.vary(c);
  for (std::size_t i = 0; i < varied.fixed_remainders.size(); ++i)
    varied.fixed_remainders[i].radius +=
        drawing.radius(model.coordinates() + static_cast<int>(i)) * second_order;
  return varied;
}

}  // namespace desmo
