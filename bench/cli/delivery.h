// From solved instants to the output.
#pragma once

#include <memory>
#include <string>

#include "bench/cli/output.h"
#include "bench/cli/progress.h"
#include "bench/cli/series.h"
#include "formulations/verification/branch_monitor.h"

namespace desmo::cli {

/// An instant was solved, but is not what was asked for.
struct NotToDeliver {
  int index;         ///< of the instant
  std::string what;  ///< "constraint 'theta: definition', t = 0.3 s: solved on another branch …"
};

/// Writes each instant it is handed, some at a time. Throws what Output throws, and NotToDeliver,
/// the instants before it handed on, where BranchMonitor finds something violated or a number is
/// not finite.
class Delivery final : public Observer {
 public:
  /// tolerance: to which positions are solved. The plan must outlive the delivery.
  Delivery(SeriesHeading heading, std::unique_ptr<SeriesFormat> format, const Plan& plan,
           double tolerance, Output& output, Progress& progress);

  void observe(const Instant& instant) override;
  /// Writes what has been handed to it but not written.
  void flush();

 private:
  SeriesHeading heading_;
  std::unique_ptr<SeriesFormat> format_;
  Output& output_;
  Progress& progress_;
  const Plan& plan_;
  BranchMonitor monitor_;
  std::string text_;
};

}  // namespace desmo::cli
