#pragma once

#include "cases/cases.h"
#include "formulations/modelling/model.h"

namespace desmo {

/// The suite's cases as modelled from their descriptions.
inline Mechanism four_bar_mechanism(int dyads) { return make_mechanism(four_bar(dyads)); }
inline Mechanism truck_mechanism(int axles) { return make_mechanism(truck_suspension(axles)); }

}  // namespace desmo
