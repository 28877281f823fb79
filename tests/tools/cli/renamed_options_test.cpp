#include "cli/option/renamed_options.h"

#include <gtest/gtest.h>

#include <set>

namespace cli {
namespace {

CurrentWords words_of(std::string_view tool, std::vector<std::string> arguments) {
  std::vector<char*> pointers;
  for (std::string& one : arguments) pointers.push_back(one.data());
  return in_current_words(tool, pointers);
}

using Words = std::vector<std::string>;

TEST(RenamedOptions, ReplacesAnOldWordAndSaysSoOnce) {
  const CurrentWords now =
      words_of("skyway-bench", {"m", "--connectivity", "6", "--connectivity=18"});
  EXPECT_EQ(now.arguments, (Words{"m", "--connect", "6", "--connect=18"}));
  EXPECT_EQ(now.notes, (Words{"--connectivity is called --connect now; the old word still works"}));
}

TEST(RenamedOptions, LeavesTodaysWordsOtherToolsAndArgumentsAlone) {
  const Words words = {"--ground", "3", "--groundwork", "--", "--start"};
  EXPECT_EQ(words_of("skyway-check", words).arguments, words);
  EXPECT_TRUE(words_of("skyway-check", words).notes.empty());
}

TEST(RenamedOptions, NamesEachOldWordOfAToolOnce) {
  std::set<std::pair<std::string_view, std::string_view>> seen;
  for (const RenamedOption& row : renamed_options()) {
    EXPECT_TRUE(seen.emplace(row.tool, row.old_word).second) << row.tool << ' ' << row.old_word;
  }
  for (const RenamedOption& row : renamed_options()) {
    EXPECT_FALSE(seen.contains({row.tool, row.word})) << row.tool << ' ' << row.word;
  }
}

}  // namespace
}  // namespace cli
