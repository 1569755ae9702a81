#include "bench/cli/delivery.h"

namespace desmo::cli {
namespace {

constexpr std::size_t enough_to_write = std::size_t{1} << 16;

}  // namespace

Delivery::Delivery(SeriesHeading heading, std::unique_ptr<SeriesFormat> format, const Plan& plan,
                   Output& output, Progress& progress)
    : heading_(std::move(heading)),
      format_(std::move(format)),
      output_(output),
      progress_(progress),
      plan_(plan),
      monitor_(plan),
      text_(format_->heading(heading_)) {}

void Delivery::accept(const Instant& instant) {
  if (const int c = monitor_.violated(instant); c >= 0)
    throw WrongBranch{c, instant.index, instant.time};
  format_->append(heading_, instant, text_);
  if (text_.size() >= enough_to_write) flush();
  progress_.solved(instant.index + 1);
}

void Delivery::flush() {
  output_.write(text_);
  text_.clear();
}

}  // namespace desmo::cli
