#pragma once

// Options whose words stand for the values of an enumeration.

#include <CLI/CLI.hpp>
#include <map>
#include <string>

namespace cli {

// Takes one of `words`, for `->transform`. Unlike CLI::CheckedTransformer, --help lists the words
// alone, and the numbers behind them are no words.
template <class Enum>
CLI::Validator word_for(const std::map<std::string, Enum>& words) {
  std::string list;
  for (const auto& [word, value] : words) list += (list.empty() ? "" : ",") + word;
  list = "{" + list + "}";
  return CLI::Validator(
      [words, list](std::string& word) {
        const auto at = words.find(word);
        if (at == words.end()) return word + " not in " + list;
        word = std::to_string(static_cast<int>(at->second));
        return std::string();
      },
      list);
}

}  // namespace cli
