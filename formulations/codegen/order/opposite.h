#pragma once

#include <optional>
#include <vector>

#include "formulations/codegen/order/closed_form.h"

namespace desmo::generate {

/// Returns `form` written as +x or −x, with its rates, where x are the unknowns of an earlier
/// closed form. The values must agree up to sign on every branch, as for two vectors normal to the
/// same two others. Returns nullopt otherwise.
std::optional<ClosedForm> as_earlier_or_opposite(const ClosedForm& form, const ClosedForm& earlier,
                                                 const std::vector<Expr>& x);

}  // namespace desmo::generate
