#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "tests/random.h"

namespace desmo::fuzz {

/// Members keep their order. A text "raw:1e999" stands for what JSON cannot hold, and is written
/// as 1e999.
using Json = nlohmann::ordered_json;

std::string write(const Json& document);

/// Returns the mechanism of a document: the document itself, or a scene's member. Null when it is
/// none.
Json* mechanism_in(Json& root);

/// The file grammar.json: rules by which values are drawn, and lists of JSON patches (RFC 6902).
///
/// A rule is a list of alternatives. In texts of alternatives and patches stand
/// - `$rule`: a value drawn by it; `$rule*` in a list: none or some; `member?`: half the time
/// - `$point`, `$vector`, `$mobile`, `$coordinate`: a name that the mechanism has (of a body)
/// - `$new`, `$joint`, `$around`, `$long`: a new name, a type of joint, a number from -3 to 3, a
///   number of 400 digits
/// - in a path, `*`: any member or element; `**`: any place; `**number`: any number
/// - `:x` after any of these: the same wherever the patch says so again.
class Grammar {
 public:
  explicit Grammar(const std::filesystem::path& file);

  /// Applies one of a list's patches. Throws nlohmann::json::exception or NothingToPick when it
  /// does not apply; its first operations may be done then.
  void patch(Json& root, std::string_view list, Random& random) const;

  /// Returns a value drawn by a rule, as text in a document.
  std::string spelling(std::string_view rule, Random& random) const;

 private:
  Json file_;
};

}  // namespace desmo::fuzz
