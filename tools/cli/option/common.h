#pragma once

// The options that every tool has: --threads, --progress, --stats and -q.

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "geom/base/execution.h"

namespace cli {

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

// Writes how long the run took where --stats was given and the tool had nothing to count.
void write_time(const CLI::App& app, double seconds);

}  // namespace cli
