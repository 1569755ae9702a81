#include "formulations/accuracy/groupwise_solver_impl.h"
#include "formulations/accuracy/wide_instant.h"

namespace desmo {

template class GroupwiseSolver<Quadruple>;

}  // namespace desmo
