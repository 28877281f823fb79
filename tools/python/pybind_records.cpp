// Paths, trajectories and queries: records of JSON Lines, their numbers as arrays.

#include <cmath>
#include <limits>

#include "cli/file/files.h"
#include "geom/record/made_for_another.h"
#include "geom/record/query_record.h"
#include "geom/text/json_line.h"
#include "pybind_arrays.h"
#include "pybind_module.h"
#include "traj/record/trajectory_record.h"
#include "traj/solve/min_snap.h"

namespace binding {
namespace {

using geom::PathRecord;
using geom::Vec3;
using traj::TrajectoryRecord;

template <class Record, class Parse>
std::vector<Record> read_records(const std::string& path, const Parse& parse) {
  const geom::UsualArithmetic usual;
  std::vector<Record> out;
  cli::InputFile file(path);
  file.for_each_line([&](const std::string& line, std::size_t number) {
    out.push_back(parse(line, file.name(), number));
  });
  return out;
}

template <class Record>
void write_records(const std::string& path, const std::vector<const Record*>& records) {
  cli::OutputFile out(path, cli::OutputKind::text);
  for (const Record* record : records) out.stream() << to_json_line(*record);
  out.commit();
}

// The line that it is in a file.
template <class Class, class Parse>
void def_line(Class& of, const Parse& parse) {
  using Record = typename Class::type;
  of.def("to_json", [](const Record& record) { return to_json_line(record); });
  of.def_static("from_json", [parse](const std::string& line, const std::string& source) {
    return parse(line, source, 0);
  });
}

// (n, 3); NaN where nothing is given.
py::object velocities(const PathRecord& record) {
  if (record.velocity.empty()) return py::none();
  std::vector<double> out;
  for (const auto& v : record.velocity) {
    const Vec3 row = v.value_or(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
    out.insert(out.end(), row.data(), row.data() + 3);
  }
  return owning(std::move(out), {static_cast<py::ssize_t>(record.velocity.size()), 3});
}

void bind_path(py::module_& module) {
  py::class_<PathRecord> path(module, "Path");
  def_provenance(path, [](const PathRecord& self) { return self.provenance; });
  def_line(path, geom::parse_path_record);
  path.def_readonly("id", &PathRecord::id)
      .def_property_readonly("status", [](const PathRecord& record) { return name(record.status); })
      .def_readonly("message", &PathRecord::message)
      .def_property_readonly("length",
                             [](const PathRecord& self) { return geom::length(self.points); })
      .def_property_readonly("points",
                             [](const py::object& self) {
                               const auto& list = self.cast<const PathRecord&>().points;
                               return column(list, list.empty() ? nullptr : list[0].data(), {3},
                                             self);
                             })
      .def_property_readonly("hold",
                             [](const PathRecord& self) -> py::object {
                               if (self.hold.empty()) return py::none();
                               return owning(std::vector<double>(self.hold));
                             })
      .def_property_readonly("velocity", &velocities)
      .def_property_readonly("search", [](const PathRecord& self) {
        return from_json(self.search ? json_of(*self.search).object() : "");
      });
  module.def(
      "read_paths",
      [](const std::string& file) {
        return read_records<PathRecord>(file, geom::parse_path_record);
      },
      py::arg("path"));
  module.def("write_paths", &write_records<PathRecord>, py::arg("path"), py::arg("records"));
}

// (n, 8), NaN in segments without; None where no segment has it.
py::object yaw_of(const TrajectoryRecord& record) {
  const auto& segments = record.trajectory.segments;
  bool any = false;
  std::vector<double> out;
  for (const traj::Segment& segment : segments) {
    any = any || segment.yaw;
    for (int i = 0; i < traj::kPoints; ++i) {
      out.push_back(segment.yaw ? (*segment.yaw)[i] : std::numeric_limits<double>::quiet_NaN());
    }
  }
  if (!any) return py::none();
  return owning(std::move(out), {static_cast<py::ssize_t>(segments.size()), traj::kPoints});
}

// Position, velocity, acceleration and jerk at the times, each (n, 3).
py::tuple sample(const TrajectoryRecord& record, const py::object& times) {
  const std::span<const double> at = rows(times, 0, "times");
  if (record.trajectory.segments.empty()) {
    throw py::value_error("sample: the trajectory is empty (" + std::string(name(record.status)) +
                          ")");
  }
  std::array<std::vector<double>, 4> out;
  for (const double t : at) {
    if (std::isnan(t)) throw py::value_error("times: expected numbers, found nan");
    const traj::State state = traj::evaluate(record.trajectory, t);
    const Vec3* parts[] = {&state.position, &state.velocity, &state.acceleration, &state.jerk};
    for (int i = 0; i < 4; ++i) out[i].insert(out[i].end(), parts[i]->data(), parts[i]->data() + 3);
  }
  py::tuple result(4);
  for (int i = 0; i < 4; ++i) {
    result[i] = owning(std::move(out[i]), {static_cast<py::ssize_t>(at.size()), 3});
  }
  return result;
}

void bind_trajectory(py::module_& module) {
  py::class_<TrajectoryRecord> trajectory(module, "Trajectory");
  def_provenance(trajectory, [](const TrajectoryRecord& self) { return self.provenance; });
  def_line(trajectory, traj::parse_trajectory_record);
  const auto segments = [](const py::object& self) -> const std::vector<traj::Segment>& {
    return self.cast<const TrajectoryRecord&>().trajectory.segments;
  };
  trajectory.def_readonly("id", &TrajectoryRecord::id)
      .def_property_readonly("status",
                             [](const TrajectoryRecord& record) { return name(record.status); })
      .def_readonly("message", &TrajectoryRecord::message)
      .def_property_readonly("rung",
                             [](const TrajectoryRecord& record) {
                               return record.rung ? name(*record.rung) : std::string_view();
                             })
      .def_property_readonly("limits", [](const TrajectoryRecord& t) { return dict_of(t.limits); })
      .def_property_readonly("solver",
                             [](const TrajectoryRecord& t) { return from_json(t.solver); })
      .def_property_readonly("duration",
                             [](const TrajectoryRecord& t) { return traj::duration(t.trajectory); })
      .def_readonly("bound", &TrajectoryRecord::bound)
      .def_readonly("duration_bound", &TrajectoryRecord::duration_bound)
      .def_property_readonly("durations",
                             [=](const py::object& self) {
                               const auto& s = segments(self);
                               return column(s, s.empty() ? nullptr : &s[0].duration, {}, self);
                             })
      .def_property_readonly(
          "points",
          [=](const py::object& self) {
            const auto& s = segments(self);
            return column(s, s.empty() ? nullptr : s[0].point[0].data(), {traj::kPoints, 3}, self);
          })
      .def_property_readonly("yaw", &yaw_of)
      .def("sample", &sample, py::arg("times"));
  module.def(
      "read_trajectories",
      [](const std::string& file) {
        return read_records<TrajectoryRecord>(file, traj::parse_trajectory_record);
      },
      py::arg("path"));
  // Through points (n, 3), with the seconds between them.
  module.def("min_snap", [](const py::object& at, const py::object& seconds) {
    traj::TrajectoryRecord record;
    record.trajectory = traj::min_snap(points(at, "points"), rows(seconds, 0, "times"));
    return record;
  });
  module.def("write_trajectories", &write_records<TrajectoryRecord>, py::arg("path"),
             py::arg("records"));
}

// The ids, and (n, 6): from and to. Of the scene, or of any.
py::tuple read_queries(const std::string& path, const Scene* scene) {
  const geom::UsualArithmetic usual;
  cli::InputFile file(path);
  const auto list = geom::read_plan_queries(file.stream(), file.name());
  py::list ids;
  std::vector<double> ends;
  const auto ours = scene ? geom::provenance_of(scene->scene) : geom::Provenance();
  for (const geom::PlanQuery& query : list) {
    geom::require_asked_of(query.asked_of, ours, file.name(), query.line);
    ids.append(query.id);
    ends.insert(ends.end(), query.from.data(), query.from.data() + 3);
    ends.insert(ends.end(), query.to.data(), query.to.data() + 3);
  }
  return py::make_tuple(ids, owning(std::move(ends), {static_cast<py::ssize_t>(list.size()), 6}));
}

}  // namespace

void bind_records(py::module_& module) {
  bind_path(module);
  bind_trajectory(module);
  module.def("read_queries", &read_queries, py::arg("path"), py::arg("scene"));
}

}  // namespace binding
