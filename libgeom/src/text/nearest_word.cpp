#include "geom/text/nearest_word.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

namespace geom {
namespace {

constexpr std::size_t kMostEdits = 2;

// What counts of a word. A word of marks alone counts as it is.
std::string letters(std::string_view word) {
  std::string out;
  for (const char c : word) {
    if (c != '-' && c != '_' && c != ' ') {
      out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return out;
}

// Whether one of the parts between the hyphens of a word is just that.
bool has_part(std::string_view word, std::string_view part) {
  while (!word.empty()) {
    const std::size_t end = std::min(word.find('-'), word.size());
    if (letters(word.substr(0, end)) == part) return true;
    word.remove_prefix(std::min(end + 1, word.size()));
  }
  return false;
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  // Rows of the table, for the first i - 1, i and i + 1 letters of a.
  std::array<std::vector<std::size_t>, 3> rows;
  for (auto& row : rows) row.resize(b.size() + 1);
  auto& [before, last, row] = rows;
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = a[i - 1] == b[j - 1];
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + !same});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(last);
    last.swap(row);
  }
  return last[b.size()];
}

std::optional<std::string> nearest_word(std::string_view word, std::span<const std::string> known) {
  const std::string meant = letters(word);
  if (meant.empty()) return std::nullopt;
  for (const std::string& one : known) {
    if (letters(one) == meant) return one;
  }
  for (const std::string& one : known) {
    if (meant.size() > 1 && has_part(one, meant)) return one;
  }
  const std::string* best = nullptr;
  std::size_t least = std::min(kMostEdits, meant.size() - 1) + 1;
  for (const std::string& one : known) {
    const std::size_t edits = edit_distance(meant, letters(one));
    if (edits < least) {
      least = edits;
      best = &one;
    }
  }
  if (best) return *best;
  for (const std::string& one : known) {
    const bool begun = meant.size() > 1 && letters(one).starts_with(meant);
    if (begun && (!best || one.size() < best->size())) best = &one;
  }
  return best ? std::optional(*best) : std::nullopt;
}

std::string did_you_mean(std::string_view word, std::span<const std::string> known) {
  const auto near = nearest_word(word, known);
  return near ? fmt::format("; did you mean {}?", *near) : "";
}

}  // namespace geom
