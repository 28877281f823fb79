#pragma once

// What every tool shares: the exit codes, the common options, and the one place that catches.

#include <CLI/CLI.hpp>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "geom/base/execution.h"

namespace cli {

enum class Exit { yes = 0, no = 1, usage = 2, bad_input = 3, failed = 4 };

// Wrong usage found after parsing: exit 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Options that every tool has, and what they lead to.
class Common {
 public:
  explicit Common(CLI::App& app, bool with_threads = false);

  geom::Execution execution(std::string label) const;
  void warn(const std::string& message) const;  // on stderr, unless -q
  void note(const std::string& text) const;     // the same, as it stands: printable lines
  // Writes the JSON of --stats, where that was asked for.
  void write_stats(nlohmann::ordered_json stats) const;

 private:
  unsigned threads_ = 0;
  std::string progress_ = "auto";
  std::string stats_;
  bool quiet_ = false;
  std::string tool_;
};

// Says why the answer is no, on stderr.
void complain(std::string_view tool, std::string_view message);

// Parses, runs `body`, lets the outputs appear, and turns whatever happens into a message and an
// exit code.
int run_tool(CLI::App& app, int argc, char** argv, const std::function<Exit()>& body);

}  // namespace cli
