#include "formulations/codegen/emit/kernel_source.h"

#include <string>
#include <vector>

#include "formulations/codegen/emit/emission.h"
#include "formulations/codegen/emit/function_writer.h"
#include "formulations/codegen/emit/inlined_solve.h"

namespace desmo::generate {

namespace {

using Expressions = std::vector<Expr>;

/// More orders than these make code long, and none is right at a singular position.
constexpr std::size_t max_orders = 3;

Expressions values_of(const std::vector<RecordedEntry>& entries) {
  Expressions result;
  for (const RecordedEntry& e : entries) result.push_back(e.value);
  return result;
}

/// Writes the functions that evaluate the equations of a part.
class EvaluationWriter {
 public:
  EvaluationWriter(std::ostream& out, const PartType& type, const RecordedPart& part)
      : out_(out), type_(type), function_(out, part) {}

  void entries(const char* list, const std::vector<RecordedEntry>& entries) {
    out_ << "constexpr std::array<KernelEntry, " << entries.size() << "> " << list << "{{\n";
    for (const RecordedEntry& e : entries)
      out_ << "    {" << e.row << ", " << e.input << "},  // " << type_.row_names[e.row] << ", "
           << type_.inputs[e.input].name << "\n";
    out_ << "}};\n\n";
  }

  /// Writes a function with one value for each equation.
  void of_rows(const char* signature, const std::string& array, const Expressions& values) {
    function_.open(signature);
    Emitter emitter = begin(values);
    emitter.prepare(values);
    for (int r = 0; r < type_.rows(); ++r)
      assign(emitter, array + "[" + std::to_string(r) + "]", values[r], type_.row_names[r]);
    function_.close();
  }

  /// Writes a function with one value for each of these entries, the first of which has that place.
  void of_entries(const std::string& signature, const std::vector<RecordedEntry>& list,
                  std::size_t first) {
    function_.open(signature);
    const Expressions outputs = values_of(list);
    Emitter emitter = begin(outputs);
    emitter.prepare(outputs);
    for (std::size_t e = 0; e < list.size(); ++e)
      assign(emitter, "values[slot[" + std::to_string(first + e) + "]]", list[e].value,
             type_.row_names[list[e].row] + ", " + type_.inputs[list[e].input].name);
    function_.close();
  }

 private:
  Emitter begin(const Expressions& outputs) {
    function_.load(outputs);
    return Emitter(out_, "  ", outputs);
  }

  void assign(const Emitter& emitter, const std::string& target, Expr value,
              const std::string& comment) {
    out_ << "  " << target << " = " << emitter.text(value) << ";  // " << comment << "\n";
  }

  std::ostream& out_;
  const PartType& type_;
  FunctionWriter function_;
};

}  // namespace

void write_kernel(std::ostream& out, const SampledType& t) {
  const auto& [name, type, samples, pivot_samples, has_one_order] = t;
  std::vector<SamplePoint> all = pivot_samples;
  if (!has_one_order) all.insert(all.end(), samples.begin(), samples.end());
  Graph graph(static_cast<int>(all.size()));
  const RecordedPart group = record(type, all);
  const InlinedSolve solve(type, group, has_one_order ? 1 : max_orders, pivot_samples.size());
  EvaluationWriter writer(out, type, group);
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
  solve.write(out);
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
