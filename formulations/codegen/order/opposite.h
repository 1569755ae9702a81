#pragma once

#include <optional>
#include <vector>

#include "formulations/codegen/order/closed_form.h"

namespace desmo::generate {

/// A closed form whose values are those of an earlier one or all of them negated, whatever the
/// branches, as of two vectors normal to the same two: by the earlier unknowns x, their rates
/// included. Nothing where it is another.
std::optional<ClosedForm> as_earlier_or_opposite(const ClosedForm& form, const ClosedForm& earlier,
                                                 const std::vector<Expr>& x);

}  // namespace desmo::generate
