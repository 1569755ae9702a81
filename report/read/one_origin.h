// Whether what stands in one record belongs together.
#pragma once

#include "report/read/record.h"

namespace desmo::report {

/// Throws MixedRecord, naming the candidate, request or peer, when it was measured on another CPU
/// than the record's, when it solves another model than others of the same case and size, or when
/// it is "ok" and its results are not those of the other "ok" candidates (or, for a request, of the
/// same request). What a record does not say is not doubted.
void require_one_origin(const Record& record);

}  // namespace desmo::report
