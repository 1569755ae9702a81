#include "formulations/codegen/order/explicit_order.h"

#include <algorithm>
#include <set>

#include "cases/mechanism/names.h"
#include "formulations/codegen/order/tearing.h"
#include "formulations/codegen/order/type_blocks.h"
#include "formulations/codegen/record/expression.h"

namespace desmo::generate {

namespace {

/// A closed form with its unknowns' positions.
struct Solved {
  ClosedForm form;
  std::vector<Expr> x;
};

class OrderMaker {
 public:
  OrderMaker(const PartType& type, const RecordedPart& part) : type_(type), part_(part) {}

  std::vector<OrderSection> make() {
    for (Block& block : blocks_of(type_, part_)) {
      const std::vector<EquationOfRows> all = block.equations;
      add(std::move(block));
      for (const EquationOfRows& s : all) facts_.learn(s.equation);
    }
    return std::move(order_);
  }

 private:
  void add(Block block) {
    std::vector<Definition> angles;
    for (const int i : std::vector<int>(block.unknowns))
      if (auto separated = separate_angle(block, i, type_, part_)) {
        auto& [rest, angle] = *separated;
        std::erase_if(block.equations, [&](const EquationOfRows& s) {
          return std::ranges::find(rest.rows, s.rows.front()) != rest.rows.end();
        });
        block.equations.push_back(std::move(rest));
        std::erase(block.unknowns, i);
        angles.push_back(std::move(angle));
      }
    std::vector<Expr> equations;
    for (const EquationOfRows& s : block.equations) equations.push_back(s.equation);
    add(block, Tearing(equations, positions(part_, block.unknowns), facts_).best());
    for (Definition& d : angles) order_.push_back({{}, {std::move(d)}, {}, {}, {}});
  }

  /// Solves each placed set again, with the facts that earlier definitions imply. An earlier
  /// definition satisfies its equations before later ones are evaluated, in a core as well.
  void solve_knowing_more(const Block& block, TornOrder& torn) {
    for (PlacedForm& p : torn.placed) {
      Task task{{}, {}, facts_};
      for (const int u : p.unknowns) task.x.push_back(part_.q[block.unknowns[u]]);
      for (const int e : p.equations) task.equations.push_back(block.equations[e].equation);
      p.form = by_earlier(solve_closed(task).value());
      solved_.push_back({p.form, task.x});
      for (const Expr e : task.equations) facts_.learn(e);
      for (const auto& [e, value] : p.form.consequences) facts_.learn(e, value);
    }
  }

  /// Returns the form in terms of an earlier one that equals it up to sign; else the form itself.
  ClosedForm by_earlier(ClosedForm form) const {
    for (const Solved& earlier : solved_)
      if (auto opposite = as_earlier_or_opposite(form, earlier.form, earlier.x)) return *opposite;
    return form;
  }

  void add(const Block& block, TornOrder torn) {
    solve_knowing_more(block, torn);
    OrderSection core;
    for (const int t : torn.torn) core.torn.push_back(block.unknowns[t]);
    for (const int e : torn.left_over) {
      core.residuals.push_back(block.equations[e].equation);
      core.residual_rows.push_back(block.equations[e].rows);
      core.residual_names.push_back(names(block.equations[e].rows));
    }
    // Goes through the definitions backwards. Those that the residuals need, directly or through
    // others, belong to the core; the rest follow it.
    std::set<int> needed_inputs;
    const auto need = [&](const std::vector<Expr>& expressions) {
      for (const Expr e : expressions)
        for (const Expr input : moving_inputs(e)) needed_inputs.insert(input.id());
    };
    need(core.residuals);
    std::vector<Definition> after;
    for (auto p = torn.placed.rbegin(); p != torn.placed.rend(); ++p) {
      Definition d{std::move(p->form), {}, {}};
      bool needed = false;
      for (const int u : p->unknowns) {
        d.unknowns.push_back(block.unknowns[u]);
        needed = needed || needed_inputs.contains(part_.q[d.unknowns.back()].id());
      }
      for (const int e : p->equations) d.because.push_back(names(block.equations[e].rows));
      if (needed) {
        for (const int e : p->equations) need({block.equations[e].equation});
        need(d.form.values);
      }
      (needed ? core.definitions : after).push_back(std::move(d));
    }
    std::ranges::reverse(core.definitions);
    std::ranges::reverse(after);
    if (!core.torn.empty()) order_.push_back(std::move(core));
    for (Definition& d : after) order_.push_back({{}, {std::move(d)}, {}, {}, {}});
  }

  std::string names(const std::vector<int>& rows) const {
    return joined(
        rows, [&](int r) { return type_.row_names[r]; }, " and ");
  }

  const PartType& type_;
  const RecordedPart& part_;
  Facts facts_;
  std::vector<Solved> solved_;  // closed forms of earlier definitions, in order
  std::vector<OrderSection> order_;
};

}  // namespace

std::vector<OrderSection> explicit_order(const PartType& type, const RecordedPart& part) {
  return OrderMaker(type, part).make();
}

std::string names_of(const PartType& type, const std::vector<int>& inputs) {
  return joined(inputs, [&](int i) { return type.inputs[i].name; });
}

}  // namespace desmo::generate
