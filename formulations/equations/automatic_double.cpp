#include "formulations/equations/automatic_impl.h"

namespace desmo {

template class BasicAutomaticEquations<double>;

}  // namespace desmo
