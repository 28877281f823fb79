#include "geom/record/axes_comment.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <string>
#include <vector>

#include "geom/text/excerpt.h"

namespace geom {
namespace {

struct Known {
  std::string_view word;
  std::array<std::string_view, 3> directions;
  CommentedAxes axes;
};

constexpr Known kKnown[] = {
    {"enu", {"east", "north", "up"}, {Axes::enu, false}},
    {"neu", {"north", "east", "up"}, {Axes::neu, false}},
    {"ned", {"north", "east", "down"}, {Axes::neu, true}},
    {"end", {"east", "north", "down"}, {Axes::enu, true}},
};
// "end" is a word of English. Of LLA, WGS84 and ECEF a comment may name the origin alone.
constexpr std::string_view kNames[] = {"enu", "neu", "ned", "flu", "frd",  "rfu",   "nwu",
                                       "nue", "eun", "esd", "seu", "ecef", "wgs84", "lla"};
constexpr std::string_view kKeys[] = {"frame",  "frames",     "axes", "axis",
                                      "system", "convention", "id"};
constexpr std::string_view kDirections[] = {"east",    "north", "up",   "down", "west",
                                            "forward", "south", "left", "right"};

bool is_in(std::span<const std::string_view> words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::vector<std::string> words_of(std::string_view comment) {
  std::vector<std::string> words;
  bool within = false;
  for (const char c : comment) {
    const bool letter = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (letter && !within) words.emplace_back();
    if (letter) words.back() += c;
    within = letter;
  }
  return words;
}

// What names of axes there are, in small letters and each once.
std::vector<std::string> names_in(const std::vector<std::string>& words) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string word = lower(words[i]);
    if (!is_in(kNames, word)) continue;
    const bool capital = word.size() == 3 && word != "lla" &&
                         std::isupper(static_cast<unsigned char>(words[i].back())) != 0;
    const bool keyed = i > 0 && is_in(kKeys, lower(words[i - 1]));
    if (!(capital || keyed || words.size() == 1)) continue;
    if (std::find(names.begin(), names.end(), word) == names.end()) names.push_back(word);
  }
  return names;
}

// Where x, y and z point to; empty: not said.
std::array<std::string, 3> directions_in(const std::vector<std::string>& words) {
  std::array<std::string, 3> out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string letter = lower(words[i]);
    if (letter != "x" && letter != "y" && letter != "z") continue;
    for (std::size_t k = i + 1; k < words.size() && k <= i + 3; ++k) {
      const std::string word = lower(words[k]);
      if (word.size() == 1 || std::isdigit(static_cast<unsigned char>(word[0])) != 0) break;
      if (!is_in(kDirections, word)) continue;
      out[static_cast<std::size_t>(letter[0] - 'x')] = word;
      break;
    }
  }
  return out;
}

bool fits(const Known& known, const std::array<std::string, 3>& said) {
  for (std::size_t i = 0; i < said.size(); ++i) {
    if (!said[i].empty() && said[i] != known.directions[i]) return false;
  }
  return true;
}

}  // namespace

std::optional<CommentedAxes> axes_of_comment(std::string_view comment) {
  const std::vector<std::string> words = words_of(comment);
  const std::vector<std::string> names = names_in(words);
  const std::array<std::string, 3> said = directions_in(words);
  const bool directed =
      std::any_of(said.begin(), said.end(), [](const std::string& word) { return !word.empty(); });
  // That z goes up says nothing that a table would not mean by itself.
  const bool only_up = said[0].empty() && said[1].empty() && said[2] == "up";
  if (names.empty() && (!directed || only_up)) return std::nullopt;
  CommentedAxes out;
  std::size_t count = 0;
  for (const Known& known : kKnown) {
    if (!fits(known, said) || !(names.empty() || (names.size() == 1 && names[0] == known.word))) {
      continue;
    }
    out = known.axes;
    ++count;
  }
  return count == 1 ? out : CommentedAxes{};
}

Vec3 in_axes(Axes axes, const CommentedAxes& from, const Vec3& point) {
  const double z = from.downwards ? -point.z() : point.z();
  if (*from.axes == axes) return {point.x(), point.y(), z};
  return {point.y(), point.x(), z};
}

Fault not_these_axes(std::string_view comment, std::string_view read) {
  return {.expected = std::string(read),
          .found = fmt::format("a comment that names other axes, \"{}\"", excerpt(comment)),
          .advice = "convert the coordinates, or leave the comment out if it is wrong"};
}

}  // namespace geom
