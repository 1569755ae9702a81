// Solves a scene file and writes a point's motion: solve_file SCENE.json MOTION.csv
#include <desmo/checked_run.h>
#include <desmo/files.h>
#include <desmo/formulation.h>
#include <desmo/generated_code.h>
#include <desmo/model.h>

#include <cmath>
#include <cstdio>
#include <exception>

namespace {

/// Writes each instant as it comes.
class Table final : public desmo::Observer {
 public:
  Table(std::FILE* file, int x) : file_(file), x_(x) {
    std::fputs("t [s],x [m],dx/dt [m/s],d2x/dt2 [m/s^2]\n", file_);
  }
  desmo::Flow observe(const desmo::Instant& i) noexcept override {
    std::fprintf(file_, "%.17g,%.17g,%.17g,%.17g\n", i.time, i.q[x_], i.qd[x_], i.qdd[x_]);
    highest_ = std::fmax(highest_, i.q[x_]);
    return desmo::Flow::go_on;
  }
  double highest() const { return highest_; }

 private:
  std::FILE* file_;
  int x_;
  double highest_ = -INFINITY;
};

int solve(const char* scene_file, const char* motion_file) {
  const desmo::Scene scene = desmo::read_scene(scene_file);
  const desmo::Model model = desmo::make_model(scene);
  const auto [variant, settings] = desmo::parse_id("group_symbolic_explicit/guess:hermite5");

  // Compiled for this mechanism, or found in the cache.
  const auto code = desmo::generate_code(*variant, settings, model, scene.grid);
  std::printf("code for %zu types, %s\n", code.types.size(),
              code.problem.empty() ? "as named" : code.problem.c_str());
  const auto formulation = desmo::make_formulation(*variant, model, settings, *code.table);

  std::FILE* const file = std::fopen(motion_file, "w");
  if (!file) return 1;
  Table table(file, model.coordinate("C.x"));
  const desmo::CheckedSummary summary = desmo::run_checked(*formulation, scene.grid, {}, table);
  std::fclose(file);
  std::printf("%s; x up to %.3f m\n", desmo::describe(summary, model).c_str(), table.highest());
  const bool is_right = summary.outcome() == desmo::Outcome::converged &&
                        std::abs(table.highest() - 0.12) < 1e-12;  // crank and rod in line
  return is_right && code.types.size() > 0 && code.problem.empty() ? 0 : 1;
}

}  // namespace

int main(int arguments, char** argument) {
  if (arguments != 3) return 64;
  try {
    return solve(argument[1], argument[2]);
  } catch (const std::exception& error) {  // what a file says, or an id
    std::fprintf(stderr, "%s\n", error.what());
    return 65;
  }
}
