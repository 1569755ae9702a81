#include "formulations/equations/automatic_impl.h"

namespace desmo {

template class BasicAutomaticEquations<float>;

}  // namespace desmo
