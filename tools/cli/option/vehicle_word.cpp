#include "vehicle_word.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cli/answer/exit.h"
#include "cli/file/files.h"
#include "geom/text/nearest_word.h"
#include "numbers_option.h"

namespace cli {
namespace {

geom::Vec3 half_sizes(std::string_view numbers, std::size_t count, const std::string& word) {
  const auto values = parse_numbers(numbers, count);
  if (!values || *std::min_element(values->begin(), values->end()) < 0) {
    throw UsageError(
        fmt::format("--vehicle: expected {}, half sizes in metres >= 0 such as {}, found \"{}\"",
                    count == 1 ? "sphere:R" : "box:HX,HY,HZ",
                    count == 1 ? "sphere:0.3" : "box:0.5,0.5,0.3", word));
  }
  return count == 1 ? geom::Vec3::Constant(values->front())
                    : geom::Vec3((*values)[0], (*values)[1], (*values)[2]);
}

}  // namespace

traj::VehicleProfile parse_vehicle(const std::string& word) {
  if (word.starts_with("box:")) return {{word, half_sizes(word.substr(4), 3, word)}, {}, {}};
  if (word.starts_with("sphere:")) return {{word, half_sizes(word.substr(7), 1, word)}, {}, {}};
  if (auto profile = traj::vehicle_named(word)) return *std::move(profile);
  if (word.ends_with(".json")) {
    return traj::parse_vehicle_profile(InputFile(word).read_all(), word);
  }
  const auto names = traj::vehicle_names();
  throw UsageError(
      fmt::format("--vehicle: expected {}, FILE.json, box:HX,HY,HZ or sphere:R, found \"{}\"{}",
                  fmt::join(names, ", "), word,
                  geom::did_you_mean(word, std::vector<std::string>(names.begin(), names.end()))));
}

}  // namespace cli
