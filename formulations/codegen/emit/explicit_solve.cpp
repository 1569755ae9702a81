#include <algorithm>
#include <set>
#include <sstream>

#include "formulations/codegen/emit/emission.h"
#include "formulations/codegen/emit/explicit_plan.h"
#include "formulations/codegen/emit/monitors.h"
#include "formulations/codegen/order/explicit_order.h"
#include "formulations/codegen/record/expression.h"

namespace desmo::generate {

namespace {

using Expressions = std::vector<Expr>;

constexpr int turning = 60;  // estimated latency of turned_angle() [cycles]

class SolveWriter {
 public:
  SolveWriter(std::ostream& out, const ExplicitPlan& plan)
      : out_(out),
        plan_(plan),
        emitter_(out, "  ", plan.expressions(), {"T", "", "elementary::", true}),
        has_core_(std::ranges::any_of(plan.order,
                                      [](const OrderSection& s) { return !s.torn.empty(); })) {
    for (std::size_t k = 0; k < plan.roots.size(); ++k)
      emitter_.name(plan.roots[k].branch, "branch[" + std::to_string(k) + "]");
    for (const OrderSection& s : plan.order)
      for (const int i : unknowns_of(s))
        for (const Expr e : {plan.part.q[i], plan.part.qd[i], plan.part.qdd[i]}) {
          declared_.insert(e.id());  // its definition or its core declares it
          open_.insert(e.id());
        }
  }

  Expressions write() {
    out_ << "template <class T, Level level>\n"
            "[[gnu::always_inline]] inline ExplicitResult<T> solve(\n"
            "    T* __restrict q, T* __restrict qd, T* __restrict qdd,\n"
            "    const ExplicitBinding<T>& part) {\n"
            "  const int* const in = part.in;\n"
            "  const T *const c = part.c, *const f = part.f, *const w = part.w;\n"
            "  const T* const branch = part.branch;\n"
            "  const ExplicitLimits& limits = part.limits;\n"
            "  int iterations = 0;\n  T norm2 = 0;\n  Mask<T> sound(true);\n";
    for (std::size_t s = 0; s < plan_.order.size(); ++s) {
      positions(s);
      if (has_core_) rates(s);
    }
    for (std::size_t s = 0; s < plan_.order.size() && !has_core_; ++s) rates(s);
    out_ << "\n  const Mask<T> accepted = sound & (norm2 < limits.tolerance2);\n"
            "  return {norm2, iterations, accepted};\n}\n\n";
    return emitter_.folded();
  }

 private:
  void positions(std::size_t s) {
    load(plan_.position(s));
    if (plan_.order[s].torn.empty())
      define(plan_.order[s].definitions);
    else
      core(s);
    for (const int i : unknowns_of(plan_.order[s])) open_.erase(plan_.part.q[i].id());
    verify();
    add_monitors(s);
  }

  void rates(std::size_t s) {
    rates(s, "qd", "velocity", plan_.part.qd, plan_.motion[s].velocities);
    rates(s, "qdd", "acceleration", plan_.part.qdd, plan_.motion[s].accelerations);
  }

  std::string name(const std::string& array, int input) const {
    return array + variable_name(plan_.type, input);
  }
  const std::string& place(Expr e) const { return plan_.places.at(e.id()); }

  /// Declares the inputs that expressions read from arrays, unless they are declared already.
  void load(const Expressions& expressions) {
    declare_inputs(out_, expressions, "const T", plan_.places, declared_);
  }

  /// Defines unknowns and stores each position at once. Until the end of the function, registers
  /// would not hold them all.
  void define(const std::vector<Definition>& definitions) {
    for (const Definition& d : definitions) {
      define(d, out_, "  ");
      for (const int i : d.unknowns) deliver(i);
    }
  }

  void define(const Definition& d, std::ostream& out, const std::string& indent) {
    out << "\n"
        << indent << "// " << names_of(plan_.type, d.unknowns) << ": " << d.form.rule << "\n";
    for (std::size_t i = 0; i < d.form.values.size(); ++i)
      emitter_.define(name("q", d.unknowns[i]), d.form.values[i]);
    if (d.form.bearing) define_angle(d.unknowns.front(), *d.form.bearing, out, indent);
  }

  void deliver(int unknown) {
    out_ << "  " << place(plan_.part.q[unknown]) << " = " << name("q", unknown) << ";\n";
  }

  /// Defines an angle with its sine and cosine, which the original equations read.
  void define_angle(int angle, const ClosedForm::Bearing& bearing, std::ostream& out,
                    const std::string& indent) {
    const auto& [x, y] = bearing;
    const Expr q = plan_.part.q[angle];
    emitter_.prepare({x, y});
    const std::string turned = name("turned", angle);
    out << indent << "const auto " << turned << " = elementary::turned_angle<T>("
        << emitter_.text(y) << ", " << emitter_.text(x) << ", " << place(q) << ", part.anchors + "
        << defined_angles_++ << " * anchor_size);\n";
    const int known = std::max(emitter_.known(x), emitter_.known(y)) + turning;
    emitter_.assign(name("q", angle), turned + ".angle", known);
    emitter_.assign(name("sine", angle), turned + ".sine", known);
    emitter_.assign(name("cosine", angle), turned + ".cosine", known);
    emitter_.name(sin(q), name("sine", angle));
    emitter_.name(cos(q), name("cosine", angle));
  }

  void core(std::size_t index) {
    const OrderSection& s = plan_.order[index];
    const SectionMotion& motion = plan_.motion[index];
    const std::string number = std::to_string(index), steps = "steps" + number;
    std::ostringstream body;
    emitter_.write_to(body, "    ", true);
    for (const Definition& d : s.definitions) define(d, body, "    ");
    for (const std::string& residual : s.residual_names)
      body << "    // " << residual << ": residual\n";
    emitter_.prepare({plan_.residual2[index]});
    const std::string residual2 = emitter_.text(plan_.residual2[index]);
    // Increments and pivots are computed before the loop ends: rates share their subexpressions.
    for (std::size_t k = 0; k < s.torn.size(); ++k)
      emitter_.define("step" + number + "_" + std::to_string(k), motion.increments[k]);
    emitter_.prepare(monitored({{}, motion.monitors.pivots}));

    out_ << "\n  // Core: " << names_of(plan_.type, s.torn) << "\n";
    for (const int i : s.torn)
      out_ << "  T " << name("q", i) << " = " << place(plan_.part.q[i]) << ";\n";
    out_ << "  T " << lines_of(emitter_.declared()) << ";\n"
         << "  for (int " << steps << " = 0;; ++" << steps << ") {\n"
         << body.str() << "    if (all(!(" << residual2 << " >= limits.core_tolerance2)) || "
         << steps << " == limits.max_iterations) {\n      iterations = " << steps
         << " > iterations ? " << steps << " : iterations;\n      break;\n    }\n";
    for (std::size_t k = 0; k < s.torn.size(); ++k)
      out_ << "    " << name("q", s.torn[k]) << " -= step" << number << "_" << k << ";\n";
    out_ << "  }\n";
    emitter_.write_to(out_, "  ");
    for (const int i : unknowns_of(s)) deliver(i);
  }

  static std::string lines_of(const std::vector<std::string>& names) {
    std::string lines;
    std::size_t length = 0;
    for (const std::string& name : names) {
      if (!lines.empty()) lines += ",";
      const bool full = length + name.size() > 90;
      if (full) length = 0;
      if (!lines.empty()) lines += full ? "\n      " : " ";
      lines += name;
      length += name.size() + 2;
    }
    return lines;
  }

  /// Writes the share of each original equation in norm2 as soon as its unknowns are defined.
  void verify() {
    for (std::size_t r = 0; r < plan_.part.phi.size(); ++r) {
      const Expr phi = plan_.part.phi[r];
      const auto is_open = [&](Expr e) { return open_.contains(e.id()); };
      if (verified_.contains(r) || std::ranges::any_of(moving_inputs(phi), is_open)) continue;
      verified_.insert(r);
      load({phi});
      const std::string number = std::to_string(r), weighted = "weighted" + number;
      emitter_.define("phi" + number, phi);
      out_ << "  const T " << weighted << " = w[" << number << "] * phi" << number << ";  // "
           << plan_.type.row_names[r] << "\n  norm2 += " << weighted << " * " << weighted << ";\n";
    }
  }

  /// Writes the conditions for trusting a section's definitions and its core.
  void add_monitors(std::size_t index) {
    const auto add = [&](const Monitors& monitors) {
      emitter_.prepare(monitored(monitors));
      for (const std::string& c : conditions(emitter_, monitors))
        out_ << "  sound &= " << c << ";\n";
    };
    for (const Definition& d : plan_.order[index].definitions) add(d.form.monitors);
    add(plan_.motion[index].monitors);
  }

  void rates(std::size_t index, const std::string& array, const std::string& level,
             const Expressions& nodes, const Expressions& values) {
    load(values);
    const std::vector<int> inputs = unknowns_of(plan_.order[index]);
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      emitter_.define(name(array, inputs[k]), values[k]);
      out_ << "  if constexpr (level >= Level::" << level << ") " << place(nodes[inputs[k]])
           << " = " << name(array, inputs[k]) << ";\n";
    }
  }

  std::ostream& out_;
  const ExplicitPlan& plan_;
  Emitter emitter_;
  std::set<int> declared_;          // inputs that the function declares, or defines later
  std::set<int> open_;              // positions not yet defined, and rates, of the unknowns
  std::set<std::size_t> verified_;  // rows of original equations that norm2 contains
  int defined_angles_ = 0;
  /// True if the part has a core. Without one, rates come after all positions. Then angles, which
  /// take long, begin early, and the next part's positions need not wait for rates. With a core,
  /// the rates of each section follow its positions, while registers hold what they share.
  const bool has_core_;
};

}  // namespace

std::vector<Expr> write_solve(std::ostream& out, const ExplicitPlan& plan) {
  return SolveWriter(out, plan).write();
}

}  // namespace desmo::generate
