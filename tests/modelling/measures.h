// Scenes with measures, and their values along a motion.
#pragma once

#include <gtest/gtest.h>

#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "cases/io/files.h"
#include "formulations/modelling/measures/measures.h"
#include "tests/describing.h"

namespace desmo::measures_test {

inline constexpr double pi = std::numbers::pi;

/// A scene's outputs and measures, solved at times, by the names of their columns.
class Rows {
 public:
  Rows(const Scene& scene, std::span<const double> times)
      : whole_(make_model(scene)),
        plan_(make_plan(whole_, outputs_of(scene, whole_))),
        measures_(scene, plan_.model) {
    const auto f = make_formulation(find_variant("block_automatic_eigen"), plan_.model, {1e-13});
    f->solve_only(plan_.levels);
    for (const double t : times) {
      const Summary s = f->step(t, plan_.level());
      EXPECT_TRUE(s.ok()) << describe(s, plan_.model);
      const Instant all = measures_.extend({0, t, f->q(), f->qd(), f->qdd()});
      rows_.push_back({copy(all.q), copy(all.qd), copy(all.qdd)});
    }
  }

  double operator()(std::size_t row, const std::string& name, Level level = Level::position) const {
    for (std::size_t k = 0; k < measures_.list().size(); ++k)
      for (const Level at : all_levels)
        if (measures_.list()[k].names[at] == name)
          return rows_[row][at][static_cast<std::size_t>(plan_.model.coordinates()) + k];
    return rows_[row][level][static_cast<std::size_t>(plan_.model.coordinate(name))];
  }
  Vec vector(std::size_t row, const std::string& name, Level level = Level::position) const {
    Vec x{};
    for (int i = 0; i < 3; ++i) x[i] = (*this)(row, name + "." + "xyz"[i], level);
    return x;
  }
  const Plan& plan() const { return plan_; }

 private:
  static std::vector<double> copy(std::span<const double> x) { return {x.begin(), x.end()}; }

  const Model whole_;
  const Plan plan_;
  Measures measures_;
  std::vector<PerLevel<std::vector<double>>> rows_;
};

inline Scene scene(const std::string& mechanism, const std::string& motion,
                   const std::string& request) {
  return parse_scene(R"({"format": "desmo-scene", "version": 2, "mechanism": )" + mechanism +
                         R"(, "motion": {)" + motion + R"(}, "time": {"end": 1, "step": 0.1},
                         "request": [)" +
                         request + "]}",
                     "scene.json", "");
}

inline const std::string slider_crank = R"({"library": "slider_crank"})";
inline const std::string turning =
    R"("theta": {"type": "polynomial", "coefficients": [0, 360, 90]})";

}  // namespace desmo::measures_test
