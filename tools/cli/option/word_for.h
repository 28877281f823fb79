#pragma once

// Options whose words stand for the values of an enumeration.

#include <CLI/CLI.hpp>
#include <set>
#include <string>

#include "geom/text/words.h"

namespace cli {

// Takes one of `words`, which also stand in --help.
template <class Value, std::size_t N>
CLI::Option* add_word(CLI::App& app, const std::string& option, Value& value,
                      const geom::Words<Value, N>& words, const std::string& description) {
  std::set<std::string> known;
  for (const geom::Word<Value>& w : words) known.emplace(w.word);
  const auto take = [&value, words](const std::string& word) {
    value = *geom::value_of(words, word);
  };
  return app.add_option_function<std::string>(option, take, description)
      ->check(CLI::IsMember(known));
}

}  // namespace cli
