#include "renamed_options.h"

#include <fmt/format.h>

#include <algorithm>

namespace cli {
namespace {

constexpr RenamedOption kRenamed[] = {
    {"skyway-bench", "--connectivity", "--connect"},
    {"skyway-bench", "--within", "--precision"},
    {"skyway-check", "--start", "--takeoff-place"},
    {"skyway-check", "--terrain", "--terrain-height"},
    {"skyway-cloud", "--ground", "--ground-points"},
    {"skyway-cloud", "--noise", "--noise-points"},
    {"skyway-fleet", "--report", "--report-file"},
    {"skyway-fly", "--hover", "--hover-time"},
    {"skyway-fly", "--report", "--report-file"},
    {"skyway-fly", "--step", "--loop-period"},
    {"skyway-fly", "--tube", "--clear-tube"},
    {"skyway-import-trajectory", "--start", "--takeoff-place"},
    {"skyway-import-trajectory", "--terrain", "--terrain-height"},
    {"skyway-lattice", "--origin", "--node"},
    {"skyway-map", "--size", "--tile"},
    {"skyway-plot", "--within", "--nearer-than"},
    {"skyway-render", "--size", "--image-size"},
    {"skyway-roadmap", "--within", "--reach"},
    {"skyway-view", "--start", "--takeoff-place"},
    {"skyway-view", "--terrain", "--terrain-height"},
};

}  // namespace

std::span<const RenamedOption> renamed_options() { return kRenamed; }

CurrentWords in_current_words(std::string_view tool, std::span<char* const> arguments) {
  CurrentWords out;
  bool options = true;
  for (const std::string_view argument : arguments) {
    out.arguments.emplace_back(argument);
    if (argument == "--") options = false;
    const std::size_t end = std::min(argument.find('='), argument.size());
    const auto row = std::find_if(std::begin(kRenamed), std::end(kRenamed), [&](const auto& one) {
      return one.tool == tool && one.old_word == argument.substr(0, end);
    });
    if (!options || row == std::end(kRenamed)) continue;
    out.arguments.back() = std::string(row->word) + std::string(argument.substr(end));
    const std::string note =
        fmt::format("{} is called {} now; the old word still works", row->old_word, row->word);
    if (std::find(out.notes.begin(), out.notes.end(), note) == out.notes.end()) {
      out.notes.push_back(note);
    }
  }
  return out;
}

}  // namespace cli
