#pragma once

// What is known of the ways home of flights, gathered from reports and planned ways.
//
// Example:
//   #include "traj/figure/home.h"
//   traj::figure::HomeFlights known;
//   known.add(traj::ContingencyRecord{.id = "q1", .from = 0, .until = 5});
//   std::vector<traj::figure::HomeFlight> flights = std::move(known).list();
//   flights[0].height = traj::figure::height_over_time(trajectory);
//   assert(traj::figure::home(flights[0]).starts_with("<svg"));

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geom/figure/svg.h"
#include "traj/curve/trajectory.h"
#include "traj/flight/flight_log.h"
#include "traj/home/contingency_record.h"
#include "traj/record/report_record.h"

namespace traj::figure {

// What is known of the ways home of one flight.
struct HomeFlight {
  std::string id;
  std::vector<geom::figure::Point> height = {};  // x: s of the flight; y: m; may be empty
  std::vector<ReturnSummary> returns = {};       // of each report
  std::vector<ContingencyRecord> ways = {};      // planned, ascending; may be empty
  double duration() const;                       // s, of all that
};

// The flights that have a report with returns, or planned ways; with an `id` only that.
class HomeFlights {
 public:
  explicit HomeFlights(std::optional<std::string> id = {}) : id_(std::move(id)) {}

  void add(const ReportSummary& report);
  void add(const ContingencyRecord& way);

  // In the order in which they first came.
  std::vector<HomeFlight> list() &&;

 private:
  HomeFlight* flight_of(const std::string& id);  // null: not wanted

  std::optional<std::string> id_;
  std::vector<HomeFlight> flights_;
  std::map<std::string, std::size_t> places_;
};

// HomeFlight::height of a flight.
std::vector<geom::figure::Point> height_over_time(const Trajectory& trajectory);
std::vector<geom::figure::Point> height_over_time(const FlightLog& log);

// The times, s, from which there is a planned way with energy enough, as long as they go on.
// Ascending, apart.
std::vector<std::pair<double, double>> planned_times(const std::vector<ContingencyRecord>& ways);

}  // namespace traj::figure
