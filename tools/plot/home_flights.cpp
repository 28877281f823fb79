#include "home_flights.h"

#include <algorithm>
#include <map>

namespace plot {
namespace {

constexpr int kSamples = 800;
constexpr double kTouching = 1e-9;  // s

std::vector<Point> height_of(const traj::Trajectory& trajectory) {
  const double end = traj::duration(trajectory);
  std::vector<Point> out;
  for (int i = 0; i <= kSamples; ++i) {
    const double time = end * i / kSamples;
    out.push_back({time, traj::evaluate(trajectory, time).position.z()});
  }
  return out;
}

std::vector<Point> height_of(const traj::FlightLog& log) {
  std::vector<Point> out;
  for (const traj::FlightSample& sample : log.samples) {
    out.push_back({sample.time - log.samples.front().time, sample.position.z()});
  }
  return out;
}

void add_height(HomeFlight& flight, const cli::Contents& contents) {
  for (const auto& [record, source, line] : contents.trajectories) {
    if (record.id != flight.id) continue;
    flight.height = height_of(record.trajectory);
    return;
  }
  for (const auto& [record, source, line] : contents.flights) {
    if (record.id == flight.id && flight.height.empty()) flight.height = height_of(record);
  }
}

}  // namespace

double HomeFlight::duration() const {
  double out = height.empty() ? 0 : height.back().x;
  for (const traj::ReturnSummary& one : returns) out = std::max(out, one.duration);
  for (const traj::ContingencyRecord& way : ways) out = std::max(out, way.until);
  return out;
}

std::vector<HomeFlight> home_flights(const cli::Contents& contents,
                                     const std::optional<std::string>& id) {
  std::vector<HomeFlight> out;
  std::map<std::string, std::size_t> places;
  const auto of = [&](const std::string& name) -> HomeFlight& {
    const auto [at, added] = places.emplace(name, out.size());
    if (added) out.push_back({name});
    return out[at->second];
  };
  for (const auto& [report, source, line] : contents.reports) {
    if (report.returns && (!id || report.id == *id))
      of(report.id).returns.push_back(*report.returns);
  }
  for (const auto& [way, source, line] : contents.contingencies) {
    if (!id || way.id == *id) of(way.id).ways.push_back(way);
  }
  for (HomeFlight& flight : out) {
    std::stable_sort(flight.ways.begin(), flight.ways.end(),
                     [](const auto& a, const auto& b) { return a.from < b.from; });
    if (out.size() == 1) add_height(flight, contents);
  }
  return out;
}

std::vector<std::pair<double, double>> planned_times(
    const std::vector<traj::ContingencyRecord>& ways) {
  std::vector<std::pair<double, double>> out;
  for (const traj::ContingencyRecord& way : ways) {
    const auto until = way.good_until();
    if (!until) continue;
    if (!out.empty() && way.from <= out.back().second + kTouching) {
      out.back().second = std::max(out.back().second, *until);
    } else {
      out.emplace_back(way.from, *until);
    }
  }
  return out;
}

}  // namespace plot
