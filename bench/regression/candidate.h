#pragma once

#include <memory>

#include "bench/kit/delivery.h"
#include "bench/regression/cell_name.h"
#include "formulations/formulation.h"
#include "formulations/id.h"
#include "formulations/model/model.h"

namespace desmo::regression {

/// A cell of the suite, built and ready to be run over its first instants, 10 ms apart.
class Subject {
 public:
  /// settings: where the cell's id names none. Throws std::invalid_argument when this build has no
  /// such cell.
  Subject(const CellName& cell, int instants, const Settings& settings = {});
  Subject(const Subject&) = delete;  // the formulation refers to the mechanism
  Subject& operator=(const Subject&) = delete;

  /// First assembly, all steps, and the delivery of every instant, as the suite times them.
  Summary analyse();

  /// Solves and delivers the instants from `first` to `last`, a step each, forwards or backwards.
  /// Needs an earlier solution nearby. Returns what became of the last step tried.
  Summary walk(int first, int last);

  /// Whether its settings solve more than one instant at once: by analyse() only, since a step is
  /// one step.
  bool runs_at_once() const {
    return settings().segments > 1 || settings().threads > 1 || settings().stride > 1;
  }

  const Settings& settings() const { return configuration_.settings; }
  int last_instant() const { return grid_.instants - 1; }

  // For what runs it in another way.
  Formulation& formulation() { return *formulation_; }
  const TimeGrid& grid() const { return grid_; }
  Observer& delivery() { return delivery_; }

  const Model& model() const { return model_; }

 private:
  Configuration configuration_;
  Model model_;
  std::unique_ptr<Formulation> formulation_;
  bench::Delivery delivery_;
  TimeGrid grid_;
};

/// Steps that make the work of so many steps larger by so many percent.
int extra_steps(int steps, double percent);

}  // namespace desmo::regression
