// Names that the examples in the headers' comments take for given. check.cmake cuts them out of the
// installed headers; here they only compile.
#include <desmo/cases.h>
#include <desmo/certificate.h>
#include <desmo/checked_run.h>
#include <desmo/files.h>
#include <desmo/formulation.h>
#include <desmo/generated_code.h>
#include <desmo/live_run.h>
#include <desmo/mechanism.h>
#include <desmo/model.h>
#include <desmo/observer.h>
#include <desmo/range.h>
#include <desmo/reference.h>
#include <desmo/scene.h>
#include <desmo/settings.h>
#include <desmo/summary.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <vector>

using namespace desmo;

void use(const auto&...);
bool read(double& t, auto&... values);

void mechanism_example() {
#include "builder.inc"
}
void scene_example() {
#include "scene.inc"
}
void files_example() {
#include "files.inc"
}
void cases_example() {
#include "cases.inc"
}
void model_example() {
#include "modelling.inc"
}
void measures_example(const Scene& scene, const Model& whole, const Instant& instant, int k) {
#include "measures.inc"
}
void settings_example() { use(Settings{.guess = Guess::hermite5, .lanes = 4}); }
void id_example(const Model& model) {
#include "id.inc"
}
void observer_example() {
#include "observer.inc"
}
void formulation_example(const Scene& scene) {
#include "formulation.inc"
}
void summary_example(const std::unique_ptr<Formulation>& formulation, const Model& model) {
#include "summary.inc"
}
void checked_run_example(const Model& model, const TimeGrid& grid, Observer& observer) {
#include "checked_run.inc"
}
void start_example(const Model& model, const TimeGrid& grid) {
#include "start.inc"
}
void live_run_example(const Model& model, const Scales& scales) {
  double t = 0;
  std::vector<double> z, zd, zdd;
#include "live_run.inc"
}
void certificate_example(const Model& model, const Instant& instant, int i) {
#include "certificate.inc"
}
void range_example(const Model& model, const std::unique_ptr<Formulation>& formulation) {
#include "driver_range.inc"
}
void generated_code_example(const Scene& scene, const Model& model) {
#include "generated_code.inc"
}
void reference_example(const Model& model, const std::unique_ptr<Formulation>& formulation,
                       const TimeGrid& grid, const std::vector<double>& times) {
#include "reference.inc"
}
