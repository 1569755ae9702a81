#include "formulations/verification/certificate/block_shape.h"

#include <algorithm>
#include <cassert>
#include <set>

#include "formulations/model/incidence.h"

namespace desmo {

namespace {

class ShapeBuilder {
 public:
  ShapeBuilder(const Model& m, const PartDefinition& part) : m_(m), part_(part) {}

  ShapedBlock build() {
    for (std::size_t row = 0; row < part_.equations.size(); ++row)
      if (row == 0 || part_.equations[row].constraint != part_.equations[row - 1].constraint)
        add(part_.equations[row].constraint);
    find_columns();
    find_entries();
    for (const int state : block_.states)
      block_.fixed.push_back(state < m_.coordinates() ? Derived()
                                                      : m_.fixed_value(state - m_.coordinates()));
    for (const Equation& e : part_.equations) {
      const Constraint& c = m_.constraints[e.constraint];
      block_.slack.push_back(c.slack.empty() ? 0 : c.slack[e.row]);
      if (!c.initial_residual.empty()) block_.initial.push_back(c.initial_residual[e.row]);
      assert(block_.initial.empty() || block_.initial.size() == block_.slack.size());
    }
    return std::move(block_);
  }

 private:
  /// An entry that Kind::jacobian emits, in the order of objects.
  struct Entry {
    std::size_t object;  ///< position in BlockShape::objects
    int row;             ///< in the block; -1: not of this block
    int state;           ///< local
  };

  void add(int position) {
    const Constraint& c = m_.constraints[position];
    BlockShape::Object o{c.kind, {}, {}, static_cast<int>(block_.constants.size()), {}};
    for (std::size_t k = 0; k < c.operands.size(); ++k) o.operands[k] = local(c.operands[k]);
    o.rows.fill(-1);
    for (std::size_t row = 0; row < part_.equations.size(); ++row)
      if (part_.equations[row].constraint == position)
        o.rows[part_.equations[row].row] = static_cast<int>(row);
    block_.shape.linear &= is_linear(c);
    block_.constants.insert(block_.constants.end(), c.constants.begin(), c.constants.end());
    const std::size_t object = block_.shape.objects.size();
    visit_incidence(m_, c, [&](int row, int state) {
      const auto local_state = std::ranges::find(block_.states, state) - block_.states.begin();
      entries_.push_back({object, o.rows[row], static_cast<int>(local_state)});
    });
    block_.shape.objects.push_back(std::move(o));
  }

  /// Returns the first local state of an entity. If the entity is new, numbers its states.
  int local(EntityId entity) {
    const int first = m_.state_index(entity);
    const auto known = std::ranges::find(block_.states, first);
    if (known != block_.states.end()) return static_cast<int>(known - block_.states.begin());
    const int at = static_cast<int>(block_.states.size());
    for (int i = 0; i < m_.entities[entity].size; ++i) block_.states.push_back(first + i);
    return at;
  }

  void find_columns() {
    BlockShape& s = block_.shape;
    std::vector<bool> is_read(block_.states.size());
    for (const Entry& e : entries_)
      if (e.row >= 0) is_read[e.state] = true;
    for (std::size_t i = 0; i < block_.states.size(); ++i)
      s.columns.push_back(is_read[i] ? BlockShape::fixed : BlockShape::unread);
    for (const bool unknowns : {true, false})
      for (std::size_t i = 0; i < block_.states.size(); ++i) {
        const int state = block_.states[i];
        if (!is_read[i] || state >= m_.coordinates()) continue;
        if (std::ranges::binary_search(part_.unknowns, state) != unknowns) continue;
        s.columns[i] = s.width();
        (unknowns ? s.unknowns : s.inputs) += 1;
        block_.coordinates.push_back(state);
      }
  }

  void find_entries() {
    BlockShape& s = block_.shape;
    std::vector<std::set<int>> rows(s.unknowns);
    for (const Entry& e : entries_)
      if (e.row >= 0 && s.columns[e.state] >= 0) rows[e.row].insert(s.columns[e.state]);
    s.row_begins.push_back(0);
    for (const std::set<int>& row : rows) {
      const int begin = s.row_begins.back();
      s.entries.insert(s.entries.end(), row.begin(), row.end());
      s.input_begins.push_back(
          begin + static_cast<int>(std::distance(row.begin(), row.lower_bound(s.unknowns))));
      s.row_begins.push_back(static_cast<int>(s.entries.size()));
    }
    for (int column = 0; column <= s.width(); ++column) {
      s.column_begins.push_back(static_cast<int>(s.column_rows.size()));
      for (int row = 0; row < s.unknowns; ++row)
        for (int e = s.row_begins[row]; e < s.row_begins[row + 1]; ++e)
          if (s.entries[e] == column) s.column_rows.push_back(row), s.column_entries.push_back(e);
    }
    for (const Entry& e : entries_) {
      std::vector<int>& slots = s.objects[e.object].slots;
      const int column = s.columns[e.state];
      if (e.row < 0 || column < 0) {
        slots.push_back(-1);
        continue;
      }
      const auto begin = s.entries.begin() + s.row_begins[e.row];
      const auto end = s.entries.begin() + s.row_begins[e.row + 1];
      slots.push_back(static_cast<int>(std::lower_bound(begin, end, column) - s.entries.begin()));
    }
  }

  const Model& m_;
  const PartDefinition& part_;
  ShapedBlock block_;
  std::vector<Entry> entries_;
};

}  // namespace

ShapedBlock shaped_block(const Model& model, const PartDefinition& block) {
  return ShapeBuilder(model, block).build();
}

}  // namespace desmo
