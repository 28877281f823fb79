#pragma once

// An option or argument as help texts and manual pages show it.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace cli {

struct DescribedOption {
  std::vector<std::string> names;  // "-o", "--output"; of an argument "MAP"
  std::string value;               // "FILE", "METRES"; empty: a flag or an argument
  std::string text;                // what it does, its words, range and default
  std::string brief;               // the same in a line or two
  std::string group;               // one of kOptionGroups; empty: an argument
  bool required = false;
  bool repeats = false;  // takes several values
};

// What is not hidden, in the parser's order.
std::vector<DescribedOption> described_options(const CLI::App& app);

}  // namespace cli
