#pragma once

// The known word that a misspelt one is nearest to.
//
// Example:
//   const std::vector<std::string> verbs = {"plan", "replan", "check"};
//   assert(geom::nearest_word("plna", verbs) == "plan");
//   std::cout << "unknown verb" << geom::did_you_mean("chekc", verbs);  // ; did you mean check?

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace geom {

// The least number of letters to add, leave out, change, or swap with their neighbours that makes
// `b` of `a`; a letter is touched once only (Damerau and Levenshtein, optimal string alignment).
std::size_t edit_distance(std::string_view a, std::string_view b);

// The one of `known` that `word` is nearest to: the same in other case, else the first that has it
// between its hyphens ("wpml" of "dji-wpml"), else at most two edits away, and fewer than `word`
// has letters, or the shortest that `word` begins. Case does not count, nor do blanks, '-' and '_'.
// The first of equals; nothing where none is near.
std::optional<std::string> nearest_word(std::string_view word, std::span<const std::string> known);

// What to add to a refusal of `word`: "; did you mean plan?", or nothing.
std::string did_you_mean(std::string_view word, std::span<const std::string> known);

}  // namespace geom
