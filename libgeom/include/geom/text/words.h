#pragma once

// The words by which records and options name the values of an enumeration.
//
// Example:
//   enum class Speed { slow, fast };
//   constexpr geom::Words<Speed, 2> words{{{Speed::slow, "slow"}, {Speed::fast, "fast"}}};
//   assert(geom::word_of(words, Speed::fast) == "fast");
//   assert(geom::value_of(words, "slow") == Speed::slow && !geom::value_of(words, "warp"));
//   assert(geom::listed(words) == "slow fast");  // for a message
//
// One table serves both ways.

#include <array>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace geom {

template <class Enum>
struct Word {
  Enum value;
  std::string_view word;
};
template <class Enum, std::size_t N>
using Words = std::array<Word<Enum>, N>;

// The word of a value. Throws std::logic_error for a value that the table has forgotten.
template <class Enum, std::size_t N>
constexpr std::string_view word_of(const Words<Enum, N>& words, Enum value) {
  for (const Word<Enum>& w : words) {
    if (w.value == value) return w.word;
  }
  throw std::logic_error("a value without a word");
}

template <class Enum, std::size_t N>
constexpr std::optional<Enum> value_of(const Words<Enum, N>& words, std::string_view word) {
  for (const Word<Enum>& w : words) {
    if (w.word == word) return w.value;
  }
  return std::nullopt;
}

// All words with blanks between them, for a message that says what was expected.
template <class Enum, std::size_t N>
std::string listed(const Words<Enum, N>& words) {
  std::string out;
  for (const Word<Enum>& w : words) {
    if (!out.empty()) out += ' ';
    out += w.word;
  }
  return out;
}

}  // namespace geom
