#pragma once

#include <array>
#include <string>
#include <string_view>

#include "bench/kit/problem.h"
#include "cases/mechanism/scene.h"
#include "formulations/base/settings.h"
#include "formulations/model/partition.h"

namespace desmo::modelling {

/// Formulations that are compared in each kind of coordinates, by their ids in natural ones: the
/// paper's partitions with dense and sparse algebra, and generated code. A closed list: the report
/// divides their times in pairs (report/tables/modelling.cpp).
inline constexpr std::array<std::string_view, 10> compared_ids{
    "global_automatic_klu",   "global_automatic_umfpack", "global_automatic_cholmod",
    "group_automatic_klu",    "group_automatic_umfpack",  "group_automatic_cholmod",
    "group_automatic_lapack", "group_symbolic_lapack",    "group_symbolic_inlined",
    "group_symbolic_explicit"};

/// Returns the id of a formulation in a kind of coordinates. Returns "" where the two are not
/// compared: this build lacks the formulation or does not offer it in these coordinates or frames,
/// or its results would say nothing new.
std::string id_in(std::string_view id, Modelling kind, Frames frames = Frames::linearised);

/// Returns the problem in natural coordinates, with a reference at instants all over the motion.
/// Throws what make_reference and require_agreement throw.
bench::Problem natural_problem(const Scene& scene, const TimeGrid& grid);

/// Returns the problem of a case in some coordinates, to be compared with the quadruple reference
/// of the natural model by names of entities.
/// - natural: the same in natural coordinates, with that reference
///
/// Throws std::runtime_error where an entity is at rest in one of the two models alone.
bench::Problem problem_in(const Scene& scene, const bench::Problem& natural, Modelling kind);

/// Sizes of the linear systems of a step, summed over the parts of a partition that move.
struct LinearSystems {
  int unknowns = 0;      ///< unknowns of the systems, to which derived ones do not belong
  int entries = 0;       ///< entries of the matrices, after condensation
  int condensation = 0;  ///< multiplications and additions of one factorisation (see Condensed)
};

/// Returns the sizes of a model's linear systems.
LinearSystems linear_systems(const Model& model, Partition partition);

/// Returns the condition number of a model at the first instant of its motion (see
/// ConditionNumber): of all its equations, derivations among them. Throws std::runtime_error where
/// it cannot be assembled.
double condition_at_start(const Model& model, double time);

}  // namespace desmo::modelling
