#include "formulations/groupwise/groupwise_solver_impl.h"

namespace desmo {

template class GroupwiseSolver<double>;

}  // namespace desmo
