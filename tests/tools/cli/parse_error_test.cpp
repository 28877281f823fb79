#include "cli/option/parse_error.h"

#include <gtest/gtest.h>

#include <vector>

#include "cli/option/word_for.h"

namespace {

enum class Colour { red, green };
constexpr geom::Words<Colour, 2> kColours{{{Colour::green, "green"}, {Colour::red, "red"}}};

// What is said of these arguments.
std::string said(std::vector<std::string> arguments) {
  CLI::App app{"", "tool"};
  std::string map, word, place;
  std::vector<double> pair;
  double size = 0, scale = 0;
  int number = 1;
  unsigned seed = 0;
  Colour colour = Colour::red;
  app.add_option("map", map)->required();
  app.add_option("--word", word)->check(CLI::IsMember({"a", "b", "c"}));
  app.add_option("--size", size, "metres")->check(CLI::Range(1e-9, 2.0));
  app.add_option("--scale", scale)->check(CLI::PositiveNumber);
  app.add_option("--pair", pair)->expected(2);
  app.add_option("--number", number)->check(CLI::IsMember({1, 2}));
  app.add_option("--place", place)->check([](const std::string&) { return "no place"; });
  app.add_option("--seed", seed)->needs("--scale")->excludes("--size");
  cli::add_word(app, "--colour", colour, kColours, "");
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::ParseError& error) {
    return cli::in_words(app, error, arguments.empty() ? "" : arguments.back());
  }
  return colour == Colour::green ? "green" : "";
}

TEST(ParseError, SaysWhatWasExpectedAndFound) {
  EXPECT_EQ(said({"m", "--word", "d"}), "--word: expected a, b or c, found \"d\"");
  EXPECT_EQ(said({"m", "--size", "3"}), "--size: expected a number from 1e-09 to 2, found \"3\"");
  EXPECT_EQ(said({"m", "--scale", "x"}), "--scale: expected a number > 0, found \"x\"");
  EXPECT_EQ(said({"m", "--scale", "1", "--seed", "x"}),
            "--seed: expected a whole number >= 0, found \"x\"");
  EXPECT_EQ(said({"m", "--pair", "3"}), "--pair: expected 2 values, found fewer");
  EXPECT_EQ(said({"m", "--word"}), "--word: expected a value, found none");
  EXPECT_EQ(said({"m", "--word", "a", "--word", "b"}),
            "--word: expected a value, found more: give it once");
}

// The parser says these with a type that it has for several things, and the option in its text.
TEST(ParseError, FindsTheOptionAtWhichTheParserStopped) {
  EXPECT_EQ(said({"m", "--scale", "2", "--size", "1", "--word", "x: y"}),
            "--word: expected a, b or c, found \"x: y\"");
  EXPECT_EQ(said({"m", "--pair", "1", "z"}), "--pair: expected a number, found \"1,z\"");
  EXPECT_EQ(said({"m", "--size", "1", "--size"}), "--size: expected a value, found none");
  EXPECT_EQ(said({"m", "--size", "1", "--word="}), "--word: expected a value, found none");
  EXPECT_EQ(said({"m", "--word", "a", "--word", "b", "--pair", "3"}),
            "--word: expected a value, found more: give it once");
  EXPECT_EQ(said({"--word", "a", "--scale", "1", "--word", "b", "--scale"}),
            "--scale: expected a value, found none");
  EXPECT_EQ(said({"m", "--word", "a", "--word=--size"}),
            "--word: expected a, b or c, found \"--size\"");
  EXPECT_EQ(said({"m", "--pair", "1", "--pair=2", "--pair=3"}),
            "--pair: expected 2 values, found more: give it once");
  EXPECT_EQ(said({"m", "--number", "d"}), "--number: expected 1 or 2, found \"d\"");
  EXPECT_EQ(said({"--place", "x"}), "--place: no place");
}

TEST(ParseError, NamesUnknownAndMissingArguments) {
  EXPECT_EQ(said({}), "expected an argument (map), found none");
  EXPECT_EQ(said({"--sise", "3"}), "there is no option --sise; did you mean --size?");
  EXPECT_EQ(said({"m", "n"}), "expected no more arguments, found \"n\"");
  EXPECT_EQ(said({"m", "--sise"}), "there is no option --sise; did you mean --size?");
  EXPECT_EQ(said({"m", "--elsewhere"}), "there is no option --elsewhere");
}

TEST(ParseError, NamesTheWrongVerbAndNotItsOptions) {
  CLI::App app{"", "tool"};
  app.require_subcommand(1);
  app.add_subcommand("profile");
  app.add_subcommand("plan");
  const auto told = [&](std::vector<std::string> arguments) -> std::string {
    try {
      app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::ParseError& error) {
      return cli::in_words(app, error, arguments.back());
    }
    return "";
  };
  EXPECT_EQ(told({"profil", "-o", "x"}),
            "expected profile or plan, found \"profil\"; did you mean profile?");
  EXPECT_EQ(told({"--sise", "profil"}), "there is no option --sise");
}

TEST(ParseError, SuggestsTheNearestWordAndTheNumberWithoutItsUnit) {
  EXPECT_EQ(said({"m", "--colour", "Gren"}),
            "--colour: expected green or red, found \"Gren\"; did you mean green?");
  EXPECT_EQ(said({"m", "--size", "500mm"}),
            "--size: expected a number from 1e-09 to 2, found \"500mm\"; give metres without the "
            "unit, 0.5");
  EXPECT_EQ(said({"m", "--scale", "0,5"}),
            "--scale: expected a number > 0, found \"0,5\"; write 0.5");
}

TEST(ParseError, SaysWhichOptionsGoTogether) {
  EXPECT_EQ(said({"m", "--seed", "1"}), "--seed needs --scale: give both");
  EXPECT_EQ(said({"m", "--seed", "1", "--scale", "1", "--size", "1"}),
            "--size and --seed exclude each other: give one of them");
}

TEST(WordFor, TakesWordsAndNotTheNumbersBehindThem) {
  EXPECT_EQ(said({"m", "--colour", "green"}), "green");
  EXPECT_EQ(said({"m", "--colour", "1"}), "--colour: expected green or red, found \"1\"");
}

}  // namespace
