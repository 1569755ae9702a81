// From solved instants to the output.
#pragma once

#include <memory>
#include <string>

#include "bench/cli/output.h"
#include "bench/cli/progress.h"
#include "bench/cli/series.h"
#include "formulations/branch_monitor.h"

namespace desmo::cli {

/// Writes each instant it is handed, some at a time. Throws what Output throws, and Error when an
/// instant does not satisfy the equations that were left out as dependent.
class Delivery final : public Sink {
 public:
  /// The plan must outlive the delivery.
  Delivery(SeriesHeading heading, std::unique_ptr<SeriesFormat> format, const Plan& plan,
           Output& output, Progress& progress);

  void accept(const Instant& instant) override;
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
