// A JSON value of a record, checked as records need it.
#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cases/io/json_document.h"

namespace desmo::report {

/// Returns the first 60 characters of a text in UTF-8, as messages show it; "..." for the rest.
std::string beginning_of(std::string_view text);
/// Returns beginning_of() the text in double quotes.
std::string in_double_quotes(std::string_view text);

/// Reference to a value of a document, which must outlive it. Functions that read the value throw
/// InputError, naming file and place, when it is not of the requested kind or range.
class RecordValue : public JsonValue {
 public:
  RecordValue(JsonValue value) : JsonValue(value) {}  // NOLINT

  RecordValue operator[](std::string_view key) const { return JsonValue::operator[](key); }
  std::optional<RecordValue> find(std::string_view key) const { return JsonValue::find(key); }

  /// Reads an optional member by a member function below, or by another function of a RecordValue.
  /// Returns nothing where the member is missing.
  template <class Read>
  auto maybe(std::string_view key, const Read& read) const {
    const std::optional<RecordValue> member = find(key);
    return member ? std::optional(std::invoke(read, *member)) : std::nullopt;
  }

  /// Reads every element of an array by such a function.
  template <class Read>
  auto list(const Read& read) const {
    std::vector<std::decay_t<std::invoke_result_t<Read, RecordValue>>> all;
    for (const RecordValue element : elements()) all.push_back(std::invoke(read, element));
    return all;
  }

  std::string text() const;    ///< text, with spaces in place of control characters
  std::string name() const;    ///< part of a file name: letters, digits, "_" and "-", one or more
  std::string digest() const;  ///< SHA-256: 64 hexadecimal digits in lower case
  std::string utc() const;     ///< date and time in the form 2026-11-21T17:48:47Z
  std::int64_t integer(int least) const;  ///< whole number, least ≤ it ≤ 1e9
  std::int64_t count() const;             ///< whole number, 1 ≤ it ≤ 1e15
  double not_negative() const;            ///< number, 0 ≤ it ≤ 1e100, so that sums stay finite
  double positive() const;                ///< number, 0 < it ≤ 1e100
  double sample() const;                  ///< measured time [s], 1e-9 ≤ it ≤ 1e9

  /// Returns every text, number and boolean inside, with its path, such as "machine cpu". The
  /// elements of a list make one text.
  std::vector<std::pair<std::string, std::string>> leaves() const;

  /// Returns the index of the text in a list of words. Throws InputError when it is none of them.
  std::size_t one_of(std::initializer_list<std::string_view> words) const;
};

}  // namespace desmo::report
