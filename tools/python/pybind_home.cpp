// Returns and ways home.

#include <fmt/format.h>

#include <array>

#include "geom/base/open_file.h"
#include "geom/text/json_fields.h"
#include "geom/text/json_line.h"
#include "plan/planner/plan.h"
#include "pybind_arrays.h"
#include "pybind_module.h"
#include "traj/check/check_record.h"
#include "traj/check/check_return.h"
#include "traj/home/check_contingencies.h"
#include "traj/home/flight_contingencies.h"
#include "traj/home/home_flight.h"
#include "traj/home/landing_site.h"
#include "traj/home/ways_home.h"

namespace binding {
namespace {

constexpr double kMostNavigation = 100;  // m

traj::Flier flier_from(const std::string& autopilot,
                       const std::optional<std::array<double, 2>>& navigation) {
  traj::Flier out;
  const auto known = traj::autopilots_of(autopilot);
  if (!known) {
    throw py::value_error(
        fmt::format("autopilot: expected {}, found \"{}\"", traj::autopilot_words(), autopilot));
  }
  out.autopilots = *known;
  if (!navigation) return out;
  for (const double metres : *navigation) {
    if (metres >= 0 && metres <= kMostNavigation) continue;
    throw py::value_error("navigation: expected metres across and up or down, each from 0 to 100");
  }
  out.navigation = traj::Uncertainty{(*navigation)[0], (*navigation)[1]};
  return out;
}

// The record as a line of a stream.
std::string line_of(const py::object& what) {
  if (py::isinstance<traj::TrajectoryRecord>(what)) {
    return to_json_line(what.cast<const traj::TrajectoryRecord&>());
  }
  return to_json_line(path_from(what));
}

template <class Record>
traj::ReturnReport returns_of(const Scene& self, const Record& record, const traj::Flier& flier,
                              const traj::ReturnRules& rules) {
  agreed_vehicle(record.provenance, self.scene, geom::Differences::stricter_allowed, record.id);
  return traj::check_return(self.scene, record, flier, rules);
}

// A report of the check with its key "return".
template <class Record>
std::string return_report(const Scene& self, const Record& record, traj::ReportRecord report,
                          const traj::Flier& flier, const traj::ReturnRules& rules) {
  report.provenance = geom::provenance_of(self.scene);
  if (report.result.ok || report.result.looked) {
    report.returns = returns_of(self, record, flier, rules);
  }
  return traj::to_json_line(report, self.scene.map());
}

py::object check_return(const Scene& self, const py::object& what, const std::string& action,
                        const std::optional<double>& return_height,
                        const std::optional<std::array<double, 3>>& home_place,
                        const py::object& limits, const std::string& autopilot,
                        const std::optional<std::array<double, 2>>& navigation) {
  traj::ReturnRules rules;
  const auto known = geom::value_of(traj::kReturnActionWords, action);
  if (!known) {
    throw py::value_error(fmt::format("action: expected {}, found \"{}\"",
                                      geom::listed(traj::kReturnActionWords), action));
  }
  rules.action = *known;
  if (return_height && !(*return_height >= 0 && *return_height <= 1e4)) {
    throw py::value_error("return_height: expected metres from 0 to 10000");
  }
  rules.height = return_height;
  if (home_place) rules.home = geom::Vec3((*home_place)[0], (*home_place)[1], (*home_place)[2]);
  rules.speed = limits_from(limits)[traj::Limit::speed];
  const traj::Flier flier = flier_from(autopilot, navigation);
  std::string line;
  if (py::isinstance<traj::TrajectoryRecord>(what)) {
    const auto& record = what.cast<const traj::TrajectoryRecord&>();
    const Released released;
    auto report = traj::check_record(self.scene, record, {}, record.id, 0);
    line = return_report(self, record, std::move(report), flier, rules);
  } else {
    const geom::PathRecord record = path_from(what);
    const Released released;
    auto report = traj::check_record(self.scene, record, {}, record.id, 0);
    line = return_report(self, record, std::move(report), flier, rules);
  }
  return from_json(line);
}

// A flight, and the models of those that may fly it. The scene must leave the room that they stray.
struct Asked {
  traj::HomeFlight flight;
  std::vector<traj::ReturnModel> models;
};

Asked asked_of(const Scene& self, const py::object& what, const py::object& limits,
               const std::string& autopilot,
               const std::optional<std::array<double, 2>>& navigation) {
  Asked out{.models = traj::return_models(flier_from(autopilot, navigation))};
  const std::string line = line_of(what);
  out.flight = traj::read_home_flight(geom::JsonFields(line, "what", 0),
                                      limits_from(limits)[traj::Limit::speed]);
  agreed_vehicle(out.flight.provenance, self.scene, geom::Differences::stricter_allowed,
                 out.flight.id);
  require_metres(self.scene.map().spec().frame, out.flight.places(), out.flight.id);
  const double least = traj::least_margin(out.models);
  if (self.scene.margin() >= least) return out;
  throw py::value_error(fmt::format(
      "scene: expected a margin of at least {} m, which these autopilots may stray, found {}",
      least, self.scene.margin()));
}

py::list ways_home(const Scene& self, const py::object& what, const std::string& sites, bool local,
                   const py::object& limits, const std::string& autopilot,
                   const std::optional<std::array<double, 2>>& navigation) {
  const Asked asked = asked_of(self, what, limits, autopilot, navigation);
  std::vector<traj::ContingencyRecord> records;
  {
    const Released released;
    traj::WaysTask task{.models = asked.models};
    const std::shared_ptr<std::istream> in = geom::open_file(sites);
    for (const traj::DrawnSite& site :
         traj::read_sites(*in, sites, self.scene.map().spec().frame, {local})) {
      task.sites.push_back(traj::landing_site(self.scene, site, sites));
    }
    plan::Planner planner(self.scene);
    task.plan = [&planner](const geom::Vec3& from, const traj::LandingSite& site) {
      plan::PlanOptions search;
      search.quality = plan::Quality::fast;
      plan::PlanResult found = planner.plan(from, site.above, search);
      return found.status == geom::PathStatus::found
                 ? std::optional<geom::Polyline>(std::move(found.path))
                 : std::nullopt;
    };
    records = traj::contingency_records(
        asked.flight.id, traj::ways_home(self.scene, asked.flight.stages, task), task,
        geom::provenance_of(self.scene), asked.flight.checked_hash);
  }
  py::list out;
  for (const traj::ContingencyRecord& record : records) out.append(from_json(to_json_line(record)));
  return out;
}

py::object check_ways_home(const Scene& self, const py::object& what,
                           const std::vector<std::string>& ways, const py::object& limits,
                           const std::string& autopilot,
                           const std::optional<std::array<double, 2>>& navigation) {
  const Asked asked = asked_of(self, what, limits, autopilot, navigation);
  std::string line;
  {
    const Released released;
    std::vector<traj::ContingencyRecord> records;
    for (const std::string& way : ways) {
      records.push_back(traj::parse_contingency_record(way, "ways", records.size() + 1));
      const traj::ContingencyRecord& record = records.back();
      agreed_vehicle(record.provenance, self.scene, geom::Differences::stricter_allowed, "ways");
      traj::require_of(asked.flight, record, "ways", records.size());
    }
    auto report = traj::check_contingencies(self.scene, asked.flight.id, asked.flight.stages,
                                            records, {.models = asked.models});
    report.checked_hash = asked.flight.checked_hash;
    line = traj::to_json_line(report, self.scene.map());
  }
  return from_json(line);
}

}  // namespace

void bind_home(py::module_& module) {
  module.def("check_return", &check_return, py::arg("scene"), py::arg("what"), py::kw_only(),
             py::arg("action") = "rtl", py::arg("return_height") = py::none(),
             py::arg("home_place") = py::none(), py::arg("limits") = py::none(),
             py::arg("autopilot") = "any", py::arg("navigation") = py::none());
  module.def("ways_home", &ways_home, py::arg("scene"), py::arg("what"), py::arg("sites"),
             py::kw_only(), py::arg("local") = false, py::arg("limits") = py::none(),
             py::arg("autopilot") = "any", py::arg("navigation") = py::none());
  module.def("check_ways_home", &check_ways_home, py::arg("scene"), py::arg("what"),
             py::arg("ways"), py::kw_only(), py::arg("limits") = py::none(),
             py::arg("autopilot") = "any", py::arg("navigation") = py::none());
}

}  // namespace binding
