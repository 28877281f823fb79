// Solving and checking.

#include <cmath>
#include <numbers>

#include "cli/option/solver_words.h"
#include "geom/base/error.h"
#include "geom/record/agreed_room.h"
#include "geom/record/start_on_map.h"
#include "pybind_arrays.h"
#include "pybind_module.h"
#include "traj/check/check_record.h"
#include "traj/curve/control_points.h"
#include "traj/curve/yaw.h"
#include "traj/record/solved_record.h"

namespace binding {
geom::Vehicle agreed_vehicle(const geom::Provenance& record, const geom::CollisionScene& scene,
                             geom::Differences differences, const std::string& id) {
  geom::require_map_agrees(record, geom::provenance_of(scene), id, 0);
  return geom::agreed_room(record, {scene.vehicle(), scene.margin()}, differences, id, 0).vehicle;
}

geom::PathRecord path_from(const py::object& object) {
  if (py::isinstance<geom::PathRecord>(object)) return object.cast<geom::PathRecord>();
  const auto list = points(object, "path");
  geom::PathRecord record;
  record.id = "q1";
  record.status = list.empty() ? geom::PathStatus::unreachable : geom::PathStatus::found;
  record.points.assign(list.begin(), list.end());
  return record;
}

namespace {

constexpr double kYawRate = std::numbers::pi / 2;  // rad/s, where none is asked for

// "along", radians from x towards y, or the (x, y) to look at.
std::optional<traj::YawOptions> yaw_from(const py::object& object, bool rate_asked,
                                         traj::Limits& limits) {
  if (object.is_none()) return std::nullopt;
  if (!rate_asked)
    limits[traj::Limit::yaw_rate] =
        std::min(limits[traj::Limit::yaw_rate].value_or(kYawRate), kYawRate);
  traj::YawOptions yaw;
  yaw.rate = *limits[traj::Limit::yaw_rate] * (1 - 1e-9);  // room for rounding in the proof
  if (py::isinstance<py::str>(object)) {
    if (object.cast<std::string>() == "along") return yaw;
  } else if (py::isinstance<py::float_>(object) || py::isinstance<py::int_>(object)) {
    yaw.kind = traj::YawOptions::Kind::fixed;
    yaw.angle = object.cast<double>();
    if (std::isfinite(yaw.angle)) return yaw;
  } else if (py::isinstance<py::sequence>(object) && py::len(object) == 2) {
    const auto at = object.cast<std::array<double, 2>>();
    yaw.kind = traj::YawOptions::Kind::towards;
    yaw.target = {at[0], at[1], 0};
    if (std::isfinite(at[0]) && std::isfinite(at[1])) return yaw;
  }
  throw py::value_error("yaw: expected \"along\", radians, or (x, y) of a point, found " +
                        std::string(py::str(py::repr(object))));
}

traj::TrajectoryRecord solve(const Scene& self, const py::object& path, const py::object& limits,
                             const std::string& solver, const std::optional<std::string>& times,
                             const std::string& corridor, double rho, const py::object& yaw_words) {
  const geom::PathRecord record = path_from(path);
  require_metres(self.scene.map().spec().frame, record.points, record.id);
  const geom::Vehicle vehicle =
      agreed_vehicle(record.provenance, self.scene, geom::Differences::refused, record.id);
  const traj::Limits asked = limits_from(limits);
  traj::SolveOptions options;
  cli::choose_solver(solver, times.value_or(""), options);
  options.limits = geom::limits_to_solve(asked, vehicle);
  const auto kind = geom::value_of(traj::kCorridorWords, corridor);
  if (!kind) {
    throw py::value_error("corridor: expected planes or boxes, found \"" + corridor + "\"");
  }
  options.corridor = *kind;
  if (!(rho >= 0 && rho <= 1e3)) throw py::value_error("rho: must be within 0 to 1000");
  options.rho = rho;
  const auto yaw = yaw_from(yaw_words, asked[traj::Limit::yaw_rate].has_value(), options.limits);
  const Released released;
  return traj::solve_record(self.scene, record, options, yaw).record;
}

// As skyway-check has it: stricter than the record as one likes.
traj::ReportRecord check_trajectory(const Scene& self, const traj::TrajectoryRecord& record,
                                    const traj::Limits& asked, bool exact) {
  const geom::Vehicle vehicle =
      agreed_vehicle(record.provenance, self.scene, geom::Differences::stricter_allowed, record.id);
  if (record.status == traj::TrajectoryStatus::solved) {
    require_metres(self.scene.map().spec().frame, traj::control_points(record.trajectory),
                   record.id);
  }
  const traj::RecordRules rules{.asked = asked, .of_vehicle = vehicle.limits, .exact = exact};
  auto report = traj::check_record(self.scene, record, rules, record.id, 0);
  report.provenance = geom::provenance_of(self.scene);
  return report;
}

traj::ReportRecord check_path(const Scene& self, const geom::PathRecord& record,
                              const traj::Limits& asked, bool exact) {
  agreed_vehicle(record.provenance, self.scene, geom::Differences::stricter_allowed, record.id);
  geom::start_on(self.scene.map(), {.epoch = record.time.epoch}, record.id, 0);
  if (record.status == geom::PathStatus::found) {
    require_metres(self.scene.map().spec().frame, record.points, record.id);
  }
  const traj::RecordRules rules{.asked = asked, .exact = exact};
  auto report = traj::check_record(self.scene, record, rules, record.id, 0);
  report.provenance = geom::provenance_of(self.scene);
  return report;
}

// The report as docs/formats.md has it.
py::object check(const Scene& self, const py::object& what, const py::object& limits, bool exact) {
  std::string line;
  const traj::Limits asked = limits_from(limits);
  {
    const Released released;
    self.scene.map().require(geom::Verified::contents, on_threads(0));
  }
  if (py::isinstance<traj::TrajectoryRecord>(what)) {
    const auto& record = what.cast<const traj::TrajectoryRecord&>();
    const Released released;
    line = traj::to_json_line(check_trajectory(self, record, asked, exact), self.scene.map());
  } else {
    const geom::PathRecord record = path_from(what);
    const Released released;
    line = traj::to_json_line(check_path(self, record, asked, exact), self.scene.map());
  }
  return from_json(line);
}

}  // namespace

void bind_trajectories(py::module_& module) {
  module.def("solve", &solve, py::arg("scene"), py::arg("path"), py::kw_only(),
             py::arg("limits") = py::none(), py::arg("solver") = "auto",
             py::arg("times") = py::none(), py::arg("corridor") = "planes", py::arg("rho") = 1e-3,
             py::arg("yaw") = py::none());
  module.def("check", &check, py::arg("scene"), py::arg("what"), py::kw_only(),
             py::arg("limits") = py::none(), py::arg("exact") = false);
}

}  // namespace binding
