#include "tests/fuzz/mutator.h"

#include <cstdlib>

#include "tests/fuzz/mutations.h"

namespace desmo::fuzz {
namespace {

constexpr int max_units = 3;
constexpr std::size_t max_text = 400'000;

/// Changes a document in one place, or in a few related ones.
void mutate(Json& root, const Grammar& grammar, Random& random) {
  const bool is_scene = root.is_object() && root.contains("mechanism");
  if (random.one_in(8))
    grammar.patch(root, "any", random);
  else if (random.one_in(60))
    repeat_member(root, random);
  else if (random.one_in(3))
    move_geometry(root, random);
  else if (random.one_in(20))
    remove_body(root, random);
  else
    grammar.patch(root, is_scene && random.one_in(4) ? "scene" : "mechanism", random);
}

/// Applies a mutation some times: most often once, so that many results are solved. Tries another
/// one where it does not apply.
template <class Mutation>
void repeat(Random& random, Mutation mutation) {
  int left = 1;
  while (left < 8 && random.one_in(3)) ++left;
  for (int attempts = 50; left > 0 && attempts > 0; --attempts) try {
      mutation();
      --left;
    } catch (const NothingToPick&) {
    } catch (const Json::exception&) {
    }
}

/// Puts a member of one file in the place of that in another.
void splice(Json& root, const std::vector<Json>& documents, Random& random) {
  const Json donor = random.pick(documents).flatten();
  const std::size_t at = random.below(donor.size());
  const auto gift = std::next(donor.begin(), static_cast<std::ptrdiff_t>(at));
  Json::json_pointer place(gift.key());
  for (std::size_t up = random.below(3); up > 0; --up) place = place.parent_pointer();
  root.at(place) = donor.unflatten().at(place);
}

}  // namespace

std::string mutated(const std::vector<Json>& documents, Random& random) {
  static const Grammar grammar(DESMO_SOURCE_DIR "/tests/fuzz/grammar.json");
  Json document = random.pick(documents);
  const std::size_t way = random.below(10);
  if (way == 0) repeat(random, [&] { splice(document, documents, random); });
  if (way < 9) repeat(random, [&] { mutate(document, grammar, random); });
  if (!random.one_in(4)) give_motion_to_drivers(document);
  std::string text = write(document);
  if (way >= 8) repeat(random, [&] { spoil_text(text, grammar, random); });
  if (text.size() > max_text) text.resize(max_text);
  return with_few_units(std::move(text), max_units);
}

std::string with_few_units(std::string text, int most) {
  for (const std::string_view key : {"\"axles\"", "\"dyads\""})
    for (std::size_t at = text.find(key); at != text.npos; at = text.find(key, at)) {
      at += key.size();
      const std::size_t begin = text.find_first_not_of(" \t\r\n:", at);
      if (begin == text.npos) break;
      const std::size_t end = text.find_first_not_of("+-.0123456789eE", begin);
      const std::size_t length = (end == text.npos ? text.size() : end) - begin;
      if (std::strtod(text.substr(begin, length).c_str(), nullptr) > most)
        text.replace(begin, length, std::to_string(most));
    }
  return text;
}

}  // namespace desmo::fuzz
