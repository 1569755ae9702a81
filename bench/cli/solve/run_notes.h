// Notes for users on a formulation and its run.
#pragma once

#include <string>

#include "formulations/formulation.h"
#include "formulations/model/plan.h"

namespace desmo::cli {

/// Returns a line on the unknowns and drivers that a plan keeps, then one for each group that it
/// needs: what it keeps, to which level, for which entity, and what it drops.
std::string explain(const Plan& plan, const Model& whole);

/// Returns a line when parts lack the generated code that the formulation's id promises, else
/// nothing. named: whether the user has chosen the formulation.
std::string note_on_code(const Formulation& formulation, bool named);

/// Returns a line on the steps that generated code left to a more general solver; "" if it left
/// none. It also says how many of them changed the assembly branch. named: whether the user has
/// chosen the formulation.
std::string note_on_refusals(const Formulation& formulation, bool named);

/// Returns a line when the id asks for segments of the motion but it was solved step by step; else
/// nothing.
std::string note_on_steps(const Formulation& formulation);

/// Returns a line when the formulation's tolerance, which rounding bounds from below, is at least
/// 1.01 times the one asked for; else nothing.
std::string note_on_tolerance(const Formulation& formulation, double asked);

/// Returns a line on groups of a whole model that a plan leaves out although they may lock; else
/// nothing.
std::string note_on_unseen(const Plan& plan, const Model& whole);

}  // namespace desmo::cli
