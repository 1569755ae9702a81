#include "formulations/motion/groupwise/groupwise_solver_impl.h"
#include "formulations/verification/reference/wide_instant.h"

namespace desmo {

template class GroupwiseSolver<Quadruple>;

}  // namespace desmo
