#include "cli/option/format_options.h"

#include <gtest/gtest.h>

#include <array>

#include "cli/run.h"

namespace cli {
namespace {

const std::array kTable{FormatOption{"--where", {"vector"}},
                        FormatOption{"--units", {"vector", "raster"}, {"--terrain"}}};

// What is said of the options beside a file of this format; empty where all count.
std::string refusal(std::vector<std::string> options, const char* format) {
  CLI::App app;
  std::string text;
  for (const char* name : {"--where", "--units", "--terrain"}) app.add_option(name, text);
  app.parse(options);
  try {
    require_used(app, kTable, format, read_as("city.osm", format));
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST(RequireUsed, RefusesAnOptionThatTheFormatDoesNotUse) {
  EXPECT_EQ(refusal({"--where=x"}, "vector"), "");
  EXPECT_EQ(refusal({"--where=x"}, "osm"),
            "--where is only for vector files (city.osm is read as osm): it would change nothing "
            "here, so leave it out");
  EXPECT_EQ(refusal({}, "osm"), "");
}

TEST(RequireUsed, LetsAnotherOptionUseIt) {
  EXPECT_EQ(refusal({"--units=m"}, "osm"),
            "--units is only for vector, raster files or with --terrain (city.osm is read as osm): "
            "it would change nothing here, so leave it out");
  EXPECT_EQ(refusal({"--units=m", "--terrain=t"}, "osm"), "");
}

TEST(RequireUsed, PassesOverAnOptionThatTheToolDoesNotHave) {
  CLI::App app;
  app.parse(std::vector<std::string>{});
  EXPECT_NO_THROW(require_used(app, kTable, "osm", ""));
}

}  // namespace
}  // namespace cli
