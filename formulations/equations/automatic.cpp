#include "formulations/equations/automatic.h"

#include <algorithm>
#include <array>
#include <span>
#include <type_traits>
#include <utility>

#include "formulations/constraints/constraints.h"

namespace desmo {

/// Loops over the constraint objects of one kind in a part.
class AutomaticEquations::Loops {
 public:
  virtual ~Loops() = default;

  virtual void constant_jacobian(double* values) const = 0;
  virtual void residual(const double* state, double* phi) const = 0;
  virtual void jacobian(const double* state, double* values) const = 0;
  virtual void quadratic(const double* state, const double* rate, double* gamma) const = 0;

  /// A constraint some or all of whose equations belong to the part.
  struct Added {
    std::array<int, max_operands> operands;  // first component of each in the state
    std::vector<double> constants;
    std::array<int, max_entries> slots;  // position of each entry in the list of all
    std::array<int, max_rows> rows;      // row in the part; -1: belongs to another part
  };
  virtual void add(const Added& constraint) = 0;
  /// Replaces slots, positions in the list of all entries, by positions in the pattern.
  virtual void set_slots(std::span<const int> slots) = 0;
};

namespace {

template <class Kind>
using Operands = std::array<const double*, Kind::operand_sizes.size()>;

template <std::size_t N>
std::array<const double*, N> pointers(const double* state, const std::array<int, N>& positions) {
  std::array<const double*, N> result;
  for (std::size_t k = 0; k < N; ++k) result[k] = state + positions[k];
  return result;
}

/// Copies the equations that belong to the part to their rows.
template <std::size_t N>
void pick(const std::array<int, N>& rows, const std::array<double, N>& all, double* to) {
  for (std::size_t r = 0; r < N; ++r)
    if (rows[r] >= 0) to[rows[r]] = all[r];
}

/// Constraints of one kind, all whole or all cut. The part has every equation of a whole
/// constraint, and some of a cut one.
template <class Kind>
struct ObjectsOf : AutomaticEquations::Loops {
  struct Object {
    std::array<int, Kind::operand_sizes.size()> operands;  // first component of each in the state
    /// The number of constants of a table is not known at compile time.
    std::conditional_t<has_table<Kind>, std::vector<double>, std::array<double, Kind::constants>>
        constants;
    std::array<int, Kind::entries> slots;
    std::array<int, Kind::rows> rows;  // row in the part; -1: belongs to another part
  };

  void add(const AutomaticEquations::Loops::Added& constraint) final {
    const auto copy = [](const auto& from, auto& to) {
      std::copy_n(from.begin(), to.size(), to.begin());
    };
    Object& o = objects.emplace_back();
    copy(constraint.operands, o.operands);
    if constexpr (has_table<Kind>) o.constants.resize(constraint.constants.size());
    copy(constraint.constants, o.constants);
    copy(constraint.slots, o.slots);
    copy(constraint.rows, o.rows);
  }

  void set_slots(std::span<const int> slots) final {
    for (Object& o : objects)
      for (int& slot : o.slots) slot = slots[slot];
  }

  std::vector<Object> objects;
};

/// Loops over constraints of one kind. whole: the part has all equations of these constraints, and
/// the rows of each follow each other.
template <class Kind, bool whole>
struct LoopsOf final : ObjectsOf<Kind> {
  using typename ObjectsOf<Kind>::Object;
  using ObjectsOf<Kind>::objects;

  static void write_jacobian(const Object& o, const Operands<Kind>& x, double* values) {
    int i = 0;
    Kind::jacobian(x.data(), constants_at<Kind>(o.constants.data(), x.data()).data(),
                   [&](int, int, int, double value) { values[o.slots[i++]] = value; });
  }

  void constant_jacobian(double* values) const override {
    if constexpr (Kind::linear)
      for (const Object& o : objects) write_jacobian(o, {}, values);  // linear kinds read no state
  }

  void residual(const double* state, double* phi) const override {
    for (const Object& o : objects) {
      const auto x = pointers(state, o.operands);
      std::array<double, Kind::rows> all;
      Kind::residual(x.data(), constants_at<Kind>(o.constants.data(), x.data()).data(),
                     whole ? phi + o.rows[0] : all.data());
      if constexpr (!whole) pick(o.rows, all, phi);
    }
  }

  void jacobian(const double* state, double* values) const override {
    if constexpr (!Kind::linear)
      for (const Object& o : objects) write_jacobian(o, pointers(state, o.operands), values);
  }

  void quadratic(const double* state, const double* rate, double* gamma) const override {
    for (const Object& o : objects) {
      const auto x = pointers(state, o.operands), v = pointers(rate, o.operands);
      std::array<double, Kind::rows> all;
      Kind::quadratic(x.data(), v.data(), constants_at<Kind>(o.constants.data(), x.data()).data(),
                      whole ? gamma + o.rows[0] : all.data());
      if constexpr (!whole) pick(o.rows, all, gamma);
    }
  }
};

std::unique_ptr<AutomaticEquations::Loops> make_loops(int kind, bool is_whole) {
  std::unique_ptr<AutomaticEquations::Loops> result;
  visit_kind(kind, [&]<class Kind>(Kind) {
    if (Kind::rows == 1 || is_whole)
      result = std::make_unique<LoopsOf<Kind, true>>();
    else if constexpr (Kind::rows > 1)
      result = std::make_unique<LoopsOf<Kind, false>>();
  });
  return result;
}

}  // namespace

AutomaticEquations::AutomaticEquations(const Model& m, const PartDefinition& part) {
  std::array<std::unique_ptr<Loops>, constraint_kind_count> whole, cut;
  std::vector<JacobianEntry> entries;
  const int n = static_cast<int>(part.equations.size());
  for (int row = 0; row < n;) {
    const int position = part.equations[row].constraint;
    const Constraint& constraint = m.constraints[position];
    Loops::Added added;
    added.rows.fill(-1);
    for (std::size_t k = 0; k < constraint.operands.size(); ++k)
      added.operands[k] = m.state_index(constraint.operands[k]);
    for (const Derived& c : constraint.constants) added.constants.push_back(c.value);
    const int first = row;
    for (; row < n && part.equations[row].constraint == position; ++row)
      added.rows[part.equations[row].row] = row;
    int slot = 0;
    for (const auto& [r, operand, component] : description_of(constraint.kind).entries) {
      added.slots[slot++] = static_cast<int>(entries.size());
      entries.push_back({added.rows[r], added.operands[operand] + component,
                         m.is_at_rest(constraint.operands[operand])});
    }
    const bool is_whole = row - first == rows(constraint);
    std::unique_ptr<Loops>& loops = (is_whole ? whole : cut)[constraint.kind];
    if (!loops) loops = make_loops(constraint.kind, is_whole);
    loops->add(added);
  }

  PatternWithSlots made = make_pattern(m, part, entries);
  pattern_ = std::move(made.pattern);
  for (auto* all : {&whole, &cut})
    for (std::unique_ptr<Loops>& loops : *all) {
      if (!loops) continue;
      loops->set_slots(made.slots);
      loops_.push_back(std::move(loops));
    }
}

AutomaticEquations::~AutomaticEquations() = default;

void AutomaticEquations::constant_jacobian(double* values) const {
  for (const auto& l : loops_) l->constant_jacobian(values);
}

void AutomaticEquations::residual(const double* state, double* phi) const {
  for (const auto& l : loops_) l->residual(state, phi);
}

void AutomaticEquations::jacobian(const double* state, double* values) const {
  for (const auto& l : loops_) l->jacobian(state, values);
}

void AutomaticEquations::quadratic(const double* state, const double* rate, double* gamma) const {
  for (const auto& l : loops_) l->quadratic(state, rate, gamma);
}

}  // namespace desmo
