#include "formulations/codegen/emit/kernel_source.h"

#include <map>
#include <set>
#include <string>
#include <vector>

#include "formulations/codegen/eliminate/elimination.h"
#include "formulations/codegen/emit/emission.h"
#include "formulations/codegen/emit/monitors.h"

namespace desmo::generate {

namespace {

using Expressions = std::vector<Expr>;

/// Largest number of pivot orders in a kernel. More make its code long, and none serves a singular
/// position.
constexpr std::size_t max_orders = 3;

/// A writer of the functions of one kernel.
class KernelWriter {
 public:
  KernelWriter(std::ostream& out, const PartType& type, const RecordedPart& group,
               std::size_t orders, std::size_t first_samples)
      : out_(out),
        type_(type),
        g_(group),
        unknowns_(unknowns_of(type)),
        orders_(eliminations(jacobian_rows(), orders, first_samples)),
        places_(places_of(g_, [](int input) { return "[in[" + std::to_string(input) + "]]"; })) {}

  void entries(const char* list, const std::vector<RecordedEntry>& entries) {
    out_ << "constexpr std::array<KernelEntry, " << entries.size() << "> " << list << "{{\n";
    for (const RecordedEntry& e : entries)
      out_ << "    {" << e.row << ", " << e.input << "},  // " << type_.row_names[e.row] << ", "
           << type_.inputs[e.input].name << "\n";
    out_ << "}};\n\n";
  }

  /// Writes a function with one value for each equation.
  void of_rows(const char* signature, const std::string& array, const Expressions& values) {
    open(signature);
    const Emitter emitter = begin(values);
    for (int r = 0; r < type_.rows(); ++r)
      assign(emitter, array + "[" + std::to_string(r) + "]", values[r], type_.row_names[r]);
    close();
  }

  /// Writes a function with one value for each of these entries. first: index in `slot` of the
  /// first entry.
  void of_entries(const std::string& signature, const std::vector<RecordedEntry>& list,
                  std::size_t first) {
    open(signature);
    Expressions outputs;
    for (const RecordedEntry& e : list) outputs.push_back(e.value);
    const Emitter emitter = begin(outputs);
    for (std::size_t e = 0; e < list.size(); ++e)
      assign(emitter, "values[slot[" + std::to_string(first + e) + "]]", list[e].value,
             type_.row_names[list[e].row] + ", " + type_.inputs[list[e].input].name);
    close();
  }

  /// Writes the two functions that eliminate, position and rates, for each order, the last one
  /// first. Each calls that of the next order, if any, for what it refuses.
  void elimination() {
    for (std::size_t order = orders_.size(); order-- > 0;) {
      position(order);
      rates(order);
    }
  }

 private:
  static std::string name_of(const char* function, std::size_t order) {
    return order == 0 ? function : function + ("_in_order_" + std::to_string(order + 1));
  }
  bool is_last(std::size_t order) const { return order + 1 == orders_.size(); }

  void position(std::size_t order) {
    const Expressions step = orders_[order].solve(g_.phi);
    Expr norm2 = 0;
    for (int r = 0; r < type_.rows(); ++r) {
      const Expr weighted = weight_input("weight[" + std::to_string(r) + "]") * g_.phi[r];
      norm2 = norm2 + weighted * weighted;
    }
    Expressions all{norm2};
    append(all, step);

    open("InlinedResult " + name_of("position", order) +
         "(double* q, const int* in, const double* c, const double* weight,\n"
         "                       double tolerance2, int max_iterations)");
    load(positions(g_, unknowns_), "double");
    load(all, "const double");
    out_ << "  InlinedResult result{0, 0};\n  for (;; ++result.iterations) {\n";
    Emitter emitter(out_, "    ", all);
    emitter.prepare({norm2});
    out_ << "    result.residual2 = " << emitter.text(norm2) << ";\n"
         << "    if (!(result.residual2 >= tolerance2) || result.iterations == max_iterations) "
            "break;\n";
    emitter.prepare(step);
    // Computes all increments before any update, since each reads the old values.
    for (std::size_t j = 0; j < step.size(); ++j)
      out_ << "    const double delta" << j << " = " << emitter.text(step[j]) << ";\n";
    for (std::size_t j = 0; j < step.size(); ++j)
      out_ << "    q" << variable_name(type_, unknowns_[j]) << " -= delta" << j << ";\n";
    out_ << "  }\n";
    if (!is_last(order))
      out_ << "  if (!(result.residual2 < tolerance2) && tolerance2 > 0) {\n"
           << "    InlinedResult other = " << name_of("position", order + 1)
           << "(q, in, c, weight, tolerance2, max_iterations);\n"
           << "    other.iterations += result.iterations;\n    return other;\n  }\n";
    for (std::size_t j = 0; j < step.size(); ++j)
      out_ << "  q[in[" << unknowns_[j] << "]] = q" << variable_name(type_, unknowns_[j]) << ";\n";
    out_ << "  return result;\n";
    close();
  }

  void rates(std::size_t order) {
    const Elimination& elimination = orders_[order];
    const Monitors monitors{{}, elimination.monitors()};
    // The right-hand side of velocities reads known inputs alone. γ, the quadratic velocity term,
    // also reads the unknowns' velocities, as variables.
    const Expressions velocity = elimination.solve(known_product(g_.qd));
    Expressions first = monitored(monitors);
    append(first, velocity);
    Expressions acceleration_right = known_product(g_.qdd);
    for (int r = 0; r < type_.rows(); ++r)
      acceleration_right[r] = acceleration_right[r] - g_.gamma[r];
    const Expressions acceleration = elimination.solve(acceleration_right);

    open("bool " + name_of("rates", order) +
         "(const double* q, double* qd, double* qdd, const int* in, const double* c)");
    load(first, "const double");
    Expressions all = first;
    append(all, acceleration);
    Emitter emitter(out_, "  ", all);
    emitter.prepare(first);
    out_ << "  if (!(" << all_of(conditions(emitter, monitors)) << ")) return "
         << (is_last(order) ? "false" : name_of("rates", order + 1) + "(q, qd, qdd, in, c)")
         << ";\n";
    for (std::size_t j = 0; j < velocity.size(); ++j) {
      const std::string name = "qd" + variable_name(type_, unknowns_[j]);
      out_ << "  const double " << name << " = " << emitter.text(velocity[j]) << ";\n"
           << "  qd[in[" << unknowns_[j] << "]] = " << name << ";\n";
    }
    for (const int i : unknowns_) loaded_.insert(g_.qd[i].id());
    out_ << "  if (!qdd) return true;\n";
    load(acceleration, "const double");
    emitter.prepare(acceleration);
    for (std::size_t j = 0; j < acceleration.size(); ++j)
      out_ << "  qdd[in[" << unknowns_[j] << "]] = " << emitter.text(acceleration[j]) << ";\n";
    out_ << "  return true;\n";
    close();
  }

  SparseRows jacobian_rows() const {
    std::map<int, int> column;
    for (const int i : unknowns_) column.emplace(i, static_cast<int>(column.size()));
    SparseRows result(type_.rows());
    for (const auto* list : {&g_.constant, &g_.dependent})
      for (const RecordedEntry& e : *list)
        if (const auto it = column.find(e.input); it != column.end() && !e.value.is_zero())
          result[e.row].emplace(it->second, e.value);
    return result;
  }

  /// Returns −Φ_h w, where w are the rates of the known inputs h.
  Expressions known_product(const Expressions& rate) const {
    Expressions result(type_.rows(), Expr(0));
    for (const auto* list : {&g_.constant, &g_.known})
      for (const RecordedEntry& e : *list)
        if (type_.inputs[e.input].role == Role::known)
          result[e.row] = result[e.row] - e.value * rate[e.input];
    return result;
  }

  void open(const std::string& signature) {
    out_ << signature << " {\n";
    loaded_.clear();
  }
  void close() { out_ << "}\n\n"; }

  void load(const Expressions& expressions, const char* declaration) {
    declare_inputs(out_, expressions, declaration, places_, loaded_);
  }

  /// Declares what the outputs read and share. Returns the emitter that writes them.
  Emitter begin(const Expressions& outputs) {
    load(outputs, "const double");
    Emitter emitter(out_, "  ", outputs);
    emitter.prepare(outputs);
    return emitter;
  }

  void assign(const Emitter& emitter, const std::string& target, Expr value,
              const std::string& comment) {
    out_ << "  " << target << " = " << emitter.text(value) << ";  // " << comment << "\n";
  }

  std::ostream& out_;
  const PartType& type_;
  const RecordedPart& g_;
  const std::vector<int> unknowns_;  // the input of each column of the Jacobian
  std::vector<Elimination> orders_;
  const std::map<int, std::string> places_;
  std::set<int> loaded_;  // inputs declared in the function being written
};

}  // namespace

void write_kernel(std::ostream& out, const SampledType& t) {
  const auto& [name, type, samples, pivot_samples, has_one_order] = t;
  std::vector<SamplePoint> all = pivot_samples;
  if (!has_one_order) all.insert(all.end(), samples.begin(), samples.end());
  Graph graph(static_cast<int>(all.size()));
  const RecordedPart group = record(type, all);
  KernelWriter writer(out, type, group, has_one_order ? 1 : max_orders, pivot_samples.size());
  out << "namespace " << name << " {\n\n// " << type.fingerprint << "\n\n";
  writer.entries("constant_entries", group.constant);
  writer.entries("dependent_entries", group.dependent);
  writer.entries("known_entries", group.known);
  writer.of_entries("void constant(const double* c, const int* slot, double* values)",
                    group.constant, 0);
  writer.of_rows("void residual(const double* q, const int* in, const double* c, double* phi)",
                 "phi", group.phi);
  const std::string arguments =
      "(const double* q, const int* in, const double* c, const int* slot, double* values)";
  writer.of_entries("void dependent" + arguments, group.dependent, group.constant.size());
  writer.of_entries("void known" + arguments, group.known,
                    group.constant.size() + group.dependent.size());
  writer.of_rows(
      "void quadratic(const double* q, const double* qd, const int* in, const double* c, "
      "double* gamma)",
      "gamma", group.gamma);
  writer.elimination();
  out << "}  // namespace " << name << "\n\n";
}

void write_table_row(std::ostream& out, const std::string& name, const PartType& type) {
  out << "    {\"" << name << "\", \"" << type.fingerprint << "\", " << type.rows();
  for (const char* member : {"constant_entries", "dependent_entries", "known_entries", "constant",
                             "residual", "dependent", "known", "quadratic", "position", "rates"})
    out << ",\n     " << name << "::" << member;
  out << "},\n";
}

}  // namespace desmo::generate
