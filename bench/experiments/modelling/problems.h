#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bench/kit/problem.h"
#include "cases/mechanism/scene.h"
#include "formulations/base/settings.h"

namespace desmo::modelling {

/// Returns the formulations that are compared in each kind of coordinates, by their ids in natural
/// ones: the paper's partitions with dense and sparse algebra, and generated code. A closed list:
/// the report divides their times in pairs (report/tables/modelling.cpp).
std::vector<std::string_view> compared_ids();

/// Returns the id of a formulation in a kind of coordinates. Returns "" where the two are not
/// compared: this build lacks the formulation or does not offer it in these coordinates or frames,
/// or its results would say nothing new.
std::string id_in(std::string_view id, Modelling kind, Frames frames = Frames::linearised);

/// Returns the problem of a case in some coordinates, to be compared with the quadruple reference
/// of the natural model by names of entities.
/// - natural: the same in natural coordinates, with that reference
///
/// Throws std::runtime_error where an entity is at rest in one of the two models alone.
bench::Problem problem_in(const Scene& scene, const bench::Problem& natural, Modelling kind);

/// Returns the problem in natural coordinates, with a reference at instants all over the motion.
/// Throws what make_reference and require_agreement throw.
bench::Problem natural_problem(const Scene& scene, const TimeGrid& grid);

}  // namespace desmo::modelling
