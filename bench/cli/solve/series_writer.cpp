#include "bench/cli/solve/series_writer.h"

#include <algorithm>
#include <cmath>

#include "bench/cli/solve/run_notes.h"

namespace desmo::cli {
namespace {

constexpr std::size_t enough_to_write = std::size_t{1} << 16;

}  // namespace

SeriesWriter::SeriesWriter(SeriesHeading heading, std::unique_ptr<SeriesFormat> format,
                           OutputFile& output, bench::Progress* progress)
    : heading_(std::move(heading)),
      format_(std::move(format)),
      output_(output),
      progress_(progress),
      text_(format_->heading(heading_)) {}

Flow SeriesWriter::observe(const Instant& instant) noexcept try {
  const auto finite = [&](const Column& column) { return std::isfinite(column.value(instant)); };
  if (const auto c = std::ranges::find_if_not(heading_.columns, finite);
      c != heading_.columns.end()) {
    overflow_ = overflow_text(c->name, instant.time);
    return Flow::stop;
  }
  format_->append(heading_, instant, text_);
  if (text_.size() >= enough_to_write) flush();
  if (progress_) progress_->done();
  return Flow::go_on;
} catch (...) {
  unwritable_ = std::current_exception();
  return Flow::stop;
}

const std::string& SeriesWriter::overflow() const {
  if (unwritable_) std::rethrow_exception(unwritable_);
  return overflow_;
}

void SeriesWriter::flush() {
  output_.write(text_);
  text_.clear();
}

}  // namespace desmo::cli
