#include "formulations/codegen/emit/kernel_source.h"

#include <map>
#include <set>

#include "formulations/codegen/eliminate/elimination.h"
#include "formulations/codegen/eliminate/monitors.h"
#include "formulations/codegen/emit/emission.h"

namespace desmo::generate {

namespace {

using Expressions = std::vector<Expr>;

Expressions concatenate(std::initializer_list<Expressions> lists) {
  Expressions all;
  for (const Expressions& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

Expressions values_of(const std::vector<RecordedEntry>& entries) {
  Expressions result;
  for (const RecordedEntry& e : entries) result.push_back(e.value);
  return result;
}

/// Writes the functions of one kernel.
class KernelWriter {
 public:
  KernelWriter(std::ostream& out, const PartType& type, const RecordedPart& group)
      : out_(out), type_(type), g_(group), elimination_(jacobian_rows()) {
    for (std::size_t i = 0; i < type_.inputs.size(); ++i) {
      const std::string place = "[in[" + std::to_string(i) + "]]";
      source_[g_.q[i].id()] = "q" + place;
      source_[g_.qd[i].id()] = "qd" + place;
      source_[g_.qdd[i].id()] = "qdd" + place;
    }
  }

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
    Emitter emitter = begin(values);
    emitter.prepare(values);
    for (int r = 0; r < type_.rows(); ++r)
      assign(emitter, array + "[" + std::to_string(r) + "]", values[r], type_.row_names[r]);
    close();
  }

  /// Writes a function with one value for each of these entries, the first of which has that place.
  void of_entries(const std::string& signature, const std::vector<RecordedEntry>& list,
                  std::size_t first) {
    open(signature);
    const Expressions outputs = values_of(list);
    Emitter emitter = begin(outputs);
    emitter.prepare(outputs);
    for (std::size_t e = 0; e < list.size(); ++e)
      assign(emitter, "values[slot[" + std::to_string(first + e) + "]]", list[e].value,
             type_.row_names[list[e].row] + ", " + type_.inputs[list[e].input].name);
    close();
  }

  void position() {
    const Expressions step = elimination_.solve(g_.phi);
    const std::vector<double> unsampled(Graph::current().samples(g_.phi.front().id()).size(), 1.0);
    Expr norm2 = 0;
    for (int r = 0; r < type_.rows(); ++r) {
      const std::string name = "weight[" + std::to_string(r) + "]";
      const Expr weighted = Expr::node(Graph::current().input(name, unsampled)) * g_.phi[r];
      norm2 = norm2 + weighted * weighted;
    }
    const Expressions all = concatenate({{norm2}, step});

    open(
        "InlinedResult position(double* q, const int* in, const double* c, const double* weight,\n"
        "                       double tolerance2, int max_iterations)");
    load(unknown_positions(), "double");
    load(all, "const double");
    out_ << "  InlinedResult result{0, 0};\n  for (;; ++result.iterations) {\n";
    Emitter emitter(out_, "    ", all);
    emitter.prepare({norm2});
    out_ << "    result.residual2 = " << emitter.text(norm2) << ";\n"
         << "    if (!(result.residual2 >= tolerance2) || result.iterations == max_iterations) "
            "break;\n";
    emitter.prepare(step);
    // All increments before any update: later ones may be written with the old values.
    for (std::size_t j = 0; j < step.size(); ++j)
      out_ << "    const double delta" << j << " = " << emitter.text(step[j]) << ";\n";
    for (std::size_t j = 0; j < step.size(); ++j)
      out_ << "    q" << variable_name(type_, unknown(j)) << " -= delta" << j << ";\n";
    out_ << "  }\n";
    for (std::size_t j = 0; j < step.size(); ++j)
      out_ << "  q[in[" << unknown(j) << "]] = q" << variable_name(type_, unknown(j)) << ";\n";
    out_ << "  return result;\n";
    close();
  }

  void rates() {
    // Velocities of the unknowns become expressions of the known, and enter γ as such.
    const Expressions velocity = elimination_.solve(known_product(g_.qd));
    const Expressions watched = monitored(elimination_.monitors());
    Expressions acceleration_right = known_product(g_.qdd);
    for (int r = 0; r < type_.rows(); ++r)
      acceleration_right[r] = acceleration_right[r] - g_.gamma[r];
    const Expressions acceleration = elimination_.solve(acceleration_right);

    open("bool rates(const double* q, double* qd, double* qdd, const int* in, const double* c)");
    const Expressions first = concatenate({watched, velocity});
    load(first, "const double");
    Emitter emitter(out_, "  ", concatenate({watched, velocity, acceleration}));
    emitter.prepare(first);
    out_ << "  if (!(" << all_of(conditions(emitter, elimination_.monitors()))
         << ")) return false;\n";
    for (std::size_t j = 0; j < velocity.size(); ++j) {
      const std::string name = "qd" + variable_name(type_, unknown(j));
      out_ << "  const double " << name << " = " << emitter.text(velocity[j]) << ";\n"
           << "  qd[in[" << unknown(j) << "]] = " << name << ";\n";
    }
    for (const int i : unknowns()) loaded_.insert(g_.qd[i].id());
    out_ << "  if (!qdd) return true;\n";
    load(acceleration, "const double");
    emitter.prepare(acceleration);
    for (std::size_t j = 0; j < acceleration.size(); ++j)
      out_ << "  qdd[in[" << unknown(j) << "]] = " << emitter.text(acceleration[j]) << ";\n";
    out_ << "  return true;\n";
    close();
  }

 private:
  int unknown(std::size_t column) const { return unknowns()[column]; }

  std::vector<int> unknowns() const {
    std::vector<int> result;
    for (std::size_t i = 0; i < type_.inputs.size(); ++i)
      if (type_.inputs[i].role == Role::unknown) result.push_back(static_cast<int>(i));
    return result;
  }

  Expressions unknown_positions() const {
    Expressions result;
    for (const int i : unknowns()) result.push_back(g_.q[i]);
    return result;
  }

  std::vector<std::map<int, Expr>> jacobian_rows() const {
    std::map<int, int> column;
    for (const int i : unknowns()) column.emplace(i, static_cast<int>(column.size()));
    std::vector<std::map<int, Expr>> result(type_.rows());
    for (const auto* list : {&g_.constant, &g_.dependent})
      for (const RecordedEntry& e : *list)
        if (const auto it = column.find(e.input); it != column.end() && !e.value.is_zero())
          result[e.row].emplace(it->second, e.value);
    return result;
  }

  /// −Φ_h w for the rates w of the known inputs.
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
    declare_inputs(out_, expressions, declaration, source_, loaded_);
  }

  Emitter begin(const Expressions& outputs) {
    load(outputs, "const double");
    return Emitter(out_, "  ", outputs);
  }

  void assign(const Emitter& emitter, const std::string& target, Expr value,
              const std::string& comment) {
    out_ << "  " << target << " = " << emitter.text(value) << ";  // " << comment << "\n";
  }

  std::ostream& out_;
  const PartType& type_;
  const RecordedPart& g_;
  Elimination elimination_;
  std::map<int, std::string> source_;  // where an input is read from
  std::set<int> loaded_;               // inputs declared in the function being written
};

}  // namespace

void write_kernel(std::ostream& out, const std::string& name, const PartType& type,
                  const std::vector<SamplePoint>& samples) {
  Graph graph(static_cast<int>(samples.size()));
  const RecordedPart group = record(type, samples);
  KernelWriter writer(out, type, group);
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
  writer.position();
  writer.rates();
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
