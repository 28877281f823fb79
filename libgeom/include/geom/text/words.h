#pragma once

// The words by which records and options name the values of an enumeration: one table for both
// ways.

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

// Every value has a word: std::logic_error where the table was forgotten.
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

// The words of two enumerations as those of a type that holds a value of either, such as their
// std::variant.
template <class Either, class A, std::size_t M, class B, std::size_t N>
constexpr Words<Either, M + N> joined(const Words<A, M>& first, const Words<B, N>& second) {
  Words<Either, M + N> out;
  for (std::size_t i = 0; i < M; ++i) out[i] = {first[i].value, first[i].word};
  for (std::size_t i = 0; i < N; ++i) out[M + i] = {second[i].value, second[i].word};
  return out;
}

// All of them, with blanks in between: for a message that says what was expected.
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
