#include "traj/figure/home_flights.h"

#include <algorithm>

namespace traj::figure {
namespace {

using geom::figure::Point;

constexpr int kSamples = 800;
constexpr double kTouching = 1e-9;  // s

}  // namespace

double HomeFlight::duration() const {
  double out = height.empty() ? 0 : height.back().x;
  for (const ReturnSummary& one : returns) out = std::max(out, one.duration);
  for (const ContingencyRecord& way : ways) out = std::max(out, way.until);
  return out;
}

HomeFlight* HomeFlights::flight_of(const std::string& id) {
  if (id_ && id != *id_) return nullptr;
  const auto [at, added] = places_.emplace(id, flights_.size());
  if (added) flights_.push_back({id});
  return &flights_[at->second];
}

void HomeFlights::add(const ReportSummary& report) {
  if (!report.returns) return;
  if (HomeFlight* flight = flight_of(report.id)) flight->returns.push_back(*report.returns);
}

void HomeFlights::add(const ContingencyRecord& way) {
  if (HomeFlight* flight = flight_of(way.id)) flight->ways.push_back(way);
}

std::vector<HomeFlight> HomeFlights::list() && {
  for (HomeFlight& flight : flights_) {
    std::stable_sort(flight.ways.begin(), flight.ways.end(),
                     [](const auto& a, const auto& b) { return a.from < b.from; });
  }
  return std::move(flights_);
}

std::vector<Point> height_over_time(const Trajectory& trajectory) {
  const double end = duration(trajectory);
  std::vector<Point> out;
  for (int i = 0; i <= kSamples; ++i) {
    const double time = end * i / kSamples;
    out.push_back({time, evaluate(trajectory, time).position.z()});
  }
  return out;
}

std::vector<Point> height_over_time(const FlightLog& log) {
  std::vector<Point> out;
  for (const FlightSample& sample : log.samples) {
    out.push_back({sample.time - log.samples.front().time, sample.position.z()});
  }
  return out;
}

std::vector<std::pair<double, double>> planned_times(const std::vector<ContingencyRecord>& ways) {
  std::vector<std::pair<double, double>> out;
  for (const ContingencyRecord& way : ways) {
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

}  // namespace traj::figure
