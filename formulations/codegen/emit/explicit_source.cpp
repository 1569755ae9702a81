#include <algorithm>
#include <set>
#include <string_view>

#include "formulations/codegen/emit/emission.h"
#include "formulations/codegen/emit/explicit_plan.h"
#include "formulations/codegen/emit/kernel_source.h"
#include "formulations/codegen/emit/monitors.h"
#include "formulations/codegen/order/explicit_order.h"

namespace desmo::generate {

namespace {

/// Returns the weight of a residual, the product of its equations' weights. It makes the residual a
/// number without unit.
Expr weight(const std::vector<int>& rows) {
  Expr product = 1;
  for (const int r : rows) product = product * weight_input("w[" + std::to_string(r) + "]");
  return product;
}

/// Returns the text after an array's name that reads an input. The components of an entity are
/// neighbours in the array, so that only the index of the first one is looked up.
std::string place(const PartType& type, int input) {
  int first = 0;
  for (const PartType::Constraint& c : type.constraints)
    for (const int o : c.operands)
      if (o <= input) first = std::max(first, o);
  const std::string offset = input > first ? " + " + std::to_string(input - first) : "";
  return "[in[" + std::to_string(first) + "]" + offset + "]";
}

/// Joins the distinct names with "; ", in the order of their first appearance.
std::string list(const std::vector<std::string>& names) {
  std::string result;
  std::set<std::string_view> seen;
  for (const std::string& name : names)
    if (seen.insert(name).second) result += (result.empty() ? "" : "; ") + name;
  return result;
}

/// Writes the explicit order, one line per definition: unknowns, rule, equations.
void write_comment(std::ostream& out, const ExplicitPlan& plan) {
  const PartType& type = plan.type;
  out << "// " << type.fingerprint << "\n//\n";
  for (const OrderSection& s : plan.order) {
    const bool is_core = !s.torn.empty();
    if (is_core) out << "//   core of " << s.torn.size() << ": " << names_of(type, s.torn) << "\n";
    for (const Definition& d : s.definitions)
      out << (is_core ? "//     " : "//   ") << names_of(type, d.unknowns) << ": " << d.form.rule
          << " (" << list(d.because) << ")\n";
    if (is_core) out << "//     left to Newton: " << list(s.residual_names) << "\n";
  }
  out << "\n";
}

void write_branches(std::ostream& out, const ExplicitPlan& plan) {
  out << "constexpr std::array<std::string_view, " << plan.roots.size() << "> branches{{\n";
  for (const OrderSection& s : plan.order)
    for (const Definition& d : s.definitions)
      for (std::size_t k = 0; k < d.form.roots.size(); ++k)
        out << "    \"" << names_of(plan.type, d.unknowns) << "\",\n";
  out << "}};\n\n";

  std::vector<Expr> pivots;
  for (const Root& root : plan.roots) pivots.push_back(root.pivot);
  out << "void find_branches(const double* q, const int* in, const double* c, double* branch) {\n";
  std::set<int> declared;
  declare_inputs(out, pivots, "const double", plan.places, declared);
  Emitter emitter(out, "  ", pivots);
  emitter.prepare(pivots);
  for (std::size_t k = 0; k < pivots.size(); ++k)
    out << "  branch[" << k << "] = " << emitter.text(pivots[k]) << " < 0 ? -1 : 1;\n";
  out << "}\n\n";
}

void write_fold(std::ostream& out, const std::vector<Expr>& folded) {
  out << "constexpr int folded = " << folded.size() << ";\n"
      << "void fold(const double* c, double* f) {\n";
  Emitter emitter(out, "  ", folded);
  emitter.prepare(folded);
  for (std::size_t k = 0; k < folded.size(); ++k)
    out << "  f[" << k << "] = " << emitter.text(folded[k]) << ";\n";
  out << "}\n\n";
}

void write_list(std::ostream& out, const char* name, const std::vector<int>& inputs) {
  out << "constexpr std::array<int, " << inputs.size() << "> " << name << "{";
  for (std::size_t k = 0; k < inputs.size(); ++k) out << (k > 0 ? ", " : "") << inputs[k];
  out << "};\n";
}

/// Writes the lists of inputs: torn ones, angles with a bearing, those that the kernel reads, and
/// its unknowns. The kernel reads all inputs that are not unknowns. Of unknowns it reads the last
/// positions of torn ones and of angles with a bearing.
void write_lists(std::ostream& out, const ExplicitPlan& plan) {
  std::vector<int> torn, angles, read;
  std::vector<bool> is_read(plan.type.inputs.size(), true);
  const std::vector<int> unknowns = unknowns_of(plan.type);
  for (const int i : unknowns) is_read[i] = false;
  for (const OrderSection& s : plan.order) {
    torn.insert(torn.end(), s.torn.begin(), s.torn.end());
    for (const Definition& d : s.definitions)
      if (d.form.bearing) angles.push_back(d.unknowns.front());
  }
  for (const auto* inputs : {&torn, &angles})
    for (const int i : *inputs) is_read[i] = true;
  for (std::size_t i = 0; i < is_read.size(); ++i)
    if (is_read[i]) read.push_back(static_cast<int>(i));
  write_list(out, "torn", torn);
  write_list(out, "angles", angles);
  write_list(out, "read", read);
  write_list(out, "unknowns", unknowns);
}

}  // namespace

ExplicitPlan::ExplicitPlan(const PartType& its_type, const RecordedPart& its_part)
    : type(its_type),
      part(its_part),
      order(explicit_order(type, part)),
      motion(differentiate(part, order)),
      places(places_of(part, [this](int input) { return place(type, input); })) {
  for (const OrderSection& s : order) {
    Expr sum = 0;
    for (std::size_t r = 0; r < s.residuals.size(); ++r) {
      const Expr weighted = weight(s.residual_rows[r]) * s.residuals[r];
      sum = sum + weighted * weighted;
    }
    residual2.push_back(sum);
    for (const Definition& d : s.definitions)
      roots.insert(roots.end(), d.form.roots.begin(), d.form.roots.end());
  }
}

std::vector<Expr> ExplicitPlan::position(std::size_t section) const {
  std::vector<Expr> all{residual2[section]};
  for (const Definition& d : order[section].definitions) {
    append(all, d.form.values);
    if (d.form.bearing) append(all, {d.form.bearing->x, d.form.bearing->y});
    append(all, monitored(d.form.monitors));
  }
  append(all, motion[section].increments);
  append(all, monitored(motion[section].monitors));
  return all;
}

std::vector<Expr> ExplicitPlan::expressions() const {
  std::vector<Expr> all = part.phi;
  for (std::size_t s = 0; s < order.size(); ++s) {
    append(all, position(s));
    append(all, motion[s].velocities);
    append(all, motion[s].accelerations);
  }
  return all;
}

void write_explicit_kernel(std::ostream& out, const SampledType& t) {
  const Graph graph(static_cast<int>(t.samples.size()));
  const RecordedPart part = record(t.type, t.samples);
  const ExplicitPlan plan(t.type, part);
  out << "namespace " << t.name << " {\n\n";
  write_comment(out, plan);
  write_branches(out, plan);
  write_fold(out, write_solve(out, plan));
  write_lists(out, plan);
  out << "}  // namespace " << t.name << "\n\n";
}

void write_explicit_table_row(std::ostream& out, const std::string& name, const PartType& type) {
  out << "    {\"" << name << "\", \"" << type.fingerprint << "\", " << name << "::branches, "
      << name << "::unknowns, " << name << "::torn, " << name << "::angles,\n     " << name
      << "::folded, " << name << "::fold, " << name << "::find_branches,\n     {";
  for (const char* level : {"position", "velocity", "acceleration"})
    out << "solve_chain<" << name << "::solve<double, Level::" << level << ">>,\n      ";
  out << "}},\n";
}

void write_lane_table_row(std::ostream& out, const std::string& name, const PartType& type) {
  out << "    {lanes, \"" << type.fingerprint << "\", " << name << "::read, " << name
      << "::unknowns,\n     solve_lanes<" << name << "::solve<Lanes, Level::acceleration>>},\n";
}

}  // namespace desmo::generate
