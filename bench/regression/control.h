#pragma once

namespace desmo::regression {

/// A fixed amount of dense arithmetic that has nothing to do with what is measured: a change in its
/// time is the machine's doing. Returns a value that depends on all of it.
double control_kernel();

}  // namespace desmo::regression
