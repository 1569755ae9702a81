#include "formulations/verification/run/file_variation.h"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "formulations/constraints/constraints.h"

namespace desmo {

namespace {

constexpr double last_digit = 2 * 0x1p-53;  // relative, of a number of the file

/// Covers the second order, and rounding of radii.
constexpr double above = 1 + 0x1p-20;

template <class Kind>
constexpr bool is_measured = requires(const Derived* const* x, Derived* c) {
  Kind::measure(x, c);
};

/// Returns the first operand whose factor is a dimension of a linear kind.
template <class Kind>
constexpr std::size_t first_factor() {
  return Kind::operand_sizes.size() - Kind::constants;
}

/// The drawing of a model, whose numbers vary.
class VariedDrawing {
 public:
  explicit VariedDrawing(const Model& m) : m_(m), state_(m.state_size()) {
    for (const Entity& e : m.entities) {
      // A component of a direction varies with the others, which its length is made of.
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

  /// Adds to the radii of a constraint's dimensions.
  void vary(Constraint& c) const {
    c.remainders.resize(c.constants.size());
    visit_kind(c.kind, [&]<class Kind>(Kind) {
      if constexpr (Kind::constants > 0) {
        const auto found = variation<Kind>(c);
        for (int k = 0; k < Kind::constants; ++k) c.remainders[k].radius += found[k] * above;
      }
    });
  }

 private:
  template <class Kind>
  using Dimensions = std::array<double, Kind::constants>;

  template <class Kind>
  auto operands(const Constraint& c) const {
    std::array<const Derived*, Kind::operand_sizes.size()> x;
    for (std::size_t k = 0; k < x.size(); ++k) x[k] = state_.data() + m_.state_index(c.operands[k]);
    return x;
  }

  /// Lets a direction vary with the ends of a line along which it points.
  void vary_line(const Constraint& c) {
    visit_kind(c.kind, [&]<class Kind>(Kind) {
      if constexpr (Kind::linear && Kind::constants == 1 && is_measured<Kind>) {
        const std::array<const Derived*, 3> x = operands<Kind>(c);
        if (c.constants[0] == 0) return;
        const int first = m_.state_index(c.operands[2]);
        for (int i = 0; i < Kind::operand_sizes[2]; ++i)
          state_[first + i].radius =
              std::max(state_[first + i].radius,
                       (x[0][i].radius + x[1][i].radius) / std::abs(c.constants[0]));
      }
    });
  }

  /// Returns by how much each dimension may vary. Dimensions that the drawing does not have come
  /// from a stated length: they are products or ratios of up to three more numbers.
  template <class Kind>
  Dimensions<Kind> variation(const Constraint& c) const {
    Dimensions<Kind> result{};
    bool is_drawn = true;
    if constexpr (is_measured<Kind>) {
      std::array<Derived, Kind::constants> drawn;
      Kind::measure(operands<Kind>(c).data(), drawn.data());
      for (int k = 0; k < Kind::constants; ++k) {
        const Derived off = drawn[k] - c.dimension(k);
        is_drawn &= std::abs(off.value + off.correction) <= drawn[k].radius;
        result[k] = drawn[k].radius;
      }
    } else {
      is_drawn = vary_factors<Kind>(c, result);
    }
    if (!is_drawn)
      for (int k = 0; k < Kind::constants; ++k)
        result[k] += 3 * last_digit * std::abs(c.constants[k]);
    return result;
  }

  /// Finds how much the factors c of p − o − Σ cₖ eₖ = 0 may vary in all. The operands at hand
  /// change Φ by at most its radius, and c makes up for it: A δc = δΦ, A having the columns eₖ.
  /// Factors of points keep their sum, 0 or 1, which is one more row. Returns whether the drawing
  /// has them.
  template <class Kind>
  bool vary_factors(const Constraint& c, Dimensions<Kind>& result) const {
    const auto x = operands<Kind>(c);
    std::array<Derived, Kind::constants> factors;
    for (int k = 0; k < Kind::constants; ++k) factors[k] = c.dimension(k);
    std::array<Derived, Kind::rows> phi;
    Kind::residual(x.data(), factors.data(), phi.data());

    constexpr int n = Kind::rows;
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n + 1, Kind::constants);
    const Derived* origin = nullptr;  // of points
    for (int k = 0; k < Kind::constants; ++k) {
      const std::size_t operand = first_factor<Kind>() + k;
      const bool is_point = m_.entities[c.operands[operand]].kind == EntityKind::point;
      if (is_point && !origin) origin = x[operand];
      for (int i = 0; i < n; ++i)
        a(i, k) = is_point ? x[operand][i].value - origin[i].value : x[operand][i].value;
      a(n, k) = is_point;
    }
    // Points are as far apart as the row of their sum is large: units do not matter.
    if (const double size = a.topRows(n).cwiseAbs().maxCoeff(); size > 0) a.row(n) *= size;
    const Eigen::MatrixXd inverse = a.completeOrthogonalDecomposition().pseudoInverse();
    bool is_drawn = true;
    for (int i = 0; i < n; ++i) {
      is_drawn &= std::abs(phi[i].value + phi[i].correction) <= phi[i].radius;
      for (int k = 0; k < Kind::constants; ++k)
        result[k] += std::abs(inverse(k, i)) * phi[i].radius;
    }
    return is_drawn;
  }

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
        drawing.radius(model.coordinates() + static_cast<int>(i)) * above;
  return varied;
}

}  // namespace desmo
