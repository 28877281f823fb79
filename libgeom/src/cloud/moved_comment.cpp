#include "moved_comment.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "geom/text/excerpt.h"
#include "geom/text/text_table.h"

namespace geom {
namespace {

constexpr std::string_view kShift[] = {"shift",   "offset",  "translation", "globalshift",
                                       "shiftx",  "shifty",  "shiftz",      "offsetx",
                                       "offsety", "offsetz", "recenter"};
constexpr std::string_view kScale[] = {"scale", "globalscale"};
constexpr std::string_view kBeside[] = {"global", "local",  "coordinate", "coordinates", "utm",
                                        "factor", "vector", "x",          "y",           "z",
                                        "m",      "xyz",    "applied",    "origin"};

bool is_one_of(std::span<const std::string_view> words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// Small letters, with blanks for what may stand between words and numbers.
std::string plain(std::string_view text) {
  std::string out;
  for (char c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    out += std::string_view("\t:=,;()[]<>_").find(c) == std::string_view::npos ? c : ' ';
  }
  return out;
}

// What a comment says, in small words.
struct Said {
  bool shift = false;
  bool scale = false;
  bool numbers = false;
  bool not_0 = false;  // one of the numbers
  bool not_1 = false;
  bool other = false;  // words
};

Said said_by(std::string_view words) {
  Said out;
  for (std::size_t at = 0; (at = words.find_first_not_of(' ', at)) != words.npos;) {
    const std::string_view word = words.substr(at, words.find(' ', at) - at);
    at += word.size();
    if (const auto number = parse_number(word)) {
      out.numbers = true;
      out.not_0 |= *number != 0;
      out.not_1 |= *number != 1;
    } else if (is_one_of(kShift, word)) {
      out.shift = true;
    } else if (is_one_of(kScale, word)) {
      out.scale = true;
    } else {
      out.other |= !is_one_of(kBeside, word);
    }
  }
  return out;
}

}  // namespace

void MovedComments::take(std::string_view comment) {
  const std::string words = plain(comment);
  of_las_ |= words.find("las header") != words.npos || words.find("lasf") != words.npos;
  const Said said = said_by(words);
  if (of_las_ || said.other || !said.numbers || said.shift == said.scale) return;
  if (!(said.shift ? said.not_0 : said.not_1)) return;
  told_.scaled |= said.scale;
  if (told_.moved.empty()) told_.moved = excerpt(trimmed(comment), 60);
}

}  // namespace geom
