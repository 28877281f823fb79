// Flight logs, a column of the table at a time.

#include "cli/file/files.h"
#include "pybind_arrays.h"
#include "pybind_module.h"
#include "traj/flight/flight_log.h"

namespace binding {
namespace {

using traj::FlightLog;
using traj::FlightSample;

// `get` gives where the first row has its values.
template <class Get>
auto column_of(Shape inner, const Get& get) {
  return [=](const py::object& self) {
    const auto& samples = self.cast<const FlightLog&>().samples;
    return column(samples, samples.empty() ? nullptr : get(samples[0]), inner, self);
  };
}

// (n, 4): w, x, y, z, as in the file.
py::array attitudes(const FlightLog& log) {
  std::vector<double> out;
  for (const FlightSample& sample : log.samples) {
    const auto& q = sample.attitude;
    out.insert(out.end(), {q.w(), q.x(), q.y(), q.z()});
  }
  return owning(std::move(out), {static_cast<py::ssize_t>(log.samples.size()), 4});
}

py::array saturations(const FlightLog& log) {
  std::vector<std::uint8_t> out;
  for (const FlightSample& sample : log.samples) out.push_back(sample.saturated);
  return owning<std::uint8_t, bool>(std::move(out));
}

}  // namespace

void bind_flight_log(py::module_& module) {
  using S = FlightSample;
  py::class_<FlightLog>(module, "FlightLog")
      .def_readonly("id", &FlightLog::id)
      .def_readonly("map", &FlightLog::map)
      .def("__len__", [](const FlightLog& log) { return log.samples.size(); })
      .def_property_readonly("time", column_of({}, [](const S& s) { return &s.time; }))
      .def_property_readonly("position",
                             column_of({3}, [](const S& s) { return s.position.data(); }))
      .def_property_readonly("velocity",
                             column_of({3}, [](const S& s) { return s.velocity.data(); }))
      .def_property_readonly("attitude", &attitudes)
      .def_property_readonly("body_rates",
                             column_of({3}, [](const S& s) { return s.body_rates.data(); }))
      .def_property_readonly("setpoint_position",
                             column_of({3}, [](const S& s) { return s.setpoint_position.data(); }))
      .def_property_readonly("setpoint_velocity",
                             column_of({3}, [](const S& s) { return s.setpoint_velocity.data(); }))
      .def_property_readonly("setpoint_yaw",
                             column_of({}, [](const S& s) { return &s.setpoint_yaw; }))
      .def_property_readonly("motors", column_of({4}, [](const S& s) { return s.motors.data(); }))
      .def_property_readonly("saturated", &saturations)
      .def_property_readonly("battery", column_of({}, [](const S& s) { return &s.battery; }))
      .def_readonly("cut", &FlightLog::cut);
  module.def(
      "read_flight_logs",
      [](const std::string& path) {
        cli::InputFile file(path);
        return traj::read_flight_log(file.stream(), file.name());
      },
      py::arg("path"));
}

}  // namespace binding
