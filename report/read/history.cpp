#include "report/read/history.h"

#include "report/read/record_file.h"

namespace desmo::report {

History read_history(const std::filesystem::path& file) {
  return read_document(read_record_text(file), file.string(), [](const RecordValue& root) {
    if (root["schema"].integer(0) != 2) root["schema"].complain("only schema 2 is read");
    History history{root["candidates"].list(&RecordValue::text), {}};
    history.points = root["points"].list([&](const RecordValue& node) {
      const RecordValue counts = node["instructions"];
      HistoryPoint point{node["commit"].text(), node["date"].text(), node["subject"].text(),
                         node["compiler"].text(), counts.list([](const RecordValue& count) {
                           return count.is_number() ? std::optional(count.count()) : std::nullopt;
                         })};
      if (point.instructions.size() != history.candidates.size())
        counts.complain("as many as candidates were expected");
      return point;
    });
    return history;
  });
}

}  // namespace desmo::report
