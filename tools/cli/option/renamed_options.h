#pragma once

// Options that were called otherwise in earlier releases: the old words still work.

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

struct RenamedOption {
  std::string_view tool;
  std::string_view old_word;  // "--connectivity"
  std::string_view word;      // "--connect"
};

// All of them, by tool. No tool has an option of an old word.
std::span<const RenamedOption> renamed_options();

// A command line in today's words.
struct CurrentWords {
  std::vector<std::string> arguments;
  std::vector<std::string> notes;  // one for each old word: "--connectivity is called --connect"
};

// Replaces old words where they stand as options: "--old" and "--old=value", before "--".
CurrentWords in_current_words(std::string_view tool, std::span<char* const> arguments);

}  // namespace cli
