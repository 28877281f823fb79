// The Python module: errors, and what the parts share.

#include "pybind_module.h"

#include <fmt/format.h>

#include <cmath>
#include <system_error>

#include "cli/option/degrees.h"
#include "cli/run.h"
#include "geom/base/error.h"

namespace binding {

void require_metres(const geom::Frame& frame, std::span<const geom::Vec3> points,
                    const std::string& what) {
  if (!geom::look_like_degrees(frame, points)) return;
  const geom::Vec3& p = points.front();
  throw geom::InputError(
      what, fmt::format("expected metres, found [{}, {}], which look like degrees: the map's "
                        "origin is at latitude {}, longitude {}, and its coordinates are metres "
                        "from there",
                        p.x(), p.y(), frame.origin->latitude, frame.origin->longitude));
}

traj::Limits limits_from(const py::object& object) {
  traj::Limits limits;
  if (object.is_none()) return limits;
  for (const auto& [key, value] : py::cast<py::dict>(object)) {
    const auto name = key.cast<std::string>();
    bool known = false;
    for (const traj::LimitKind& kind : traj::kLimitKinds) {
      if (name != kind.name) continue;
      known = true;
      if (value.is_none()) continue;
      const double number = value.cast<double>();
      if (!(number > 0 && std::isfinite(number))) {
        throw geom::InputError(
            "limits", name + " must be > 0 and finite, found " + std::string(py::str(value)));
      }
      limits[kind.limit] = number;
    }
    if (!known) throw geom::InputError("limits", "there is no limit \"" + name + "\"");
  }
  return limits;
}

py::dict dict_of(const traj::Limits& limits) {
  py::dict out;
  for (const traj::LimitKind& kind : traj::kLimitKinds) {
    if (const auto& limit = limits[kind.limit]) out[kind.name] = *limit;
  }
  return out;
}

void bind_errors(py::module_& module) {
  py::register_exception<geom::InputError>(module, "InputError", PyExc_ValueError);
  py::register_exception<geom::OptionError>(module, "UsageError", PyExc_ValueError);
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const std::system_error& error) {
      // With a number, OSError becomes FileNotFoundError and the like.
      const py::tuple arguments = py::make_tuple(error.code().value(), error.what());
      PyErr_SetObject(PyExc_OSError, arguments.ptr());
    }
  });
}

}  // namespace binding

PYBIND11_MODULE(_skyway, module) {
  module.attr("__version__") = SKYWAY_VERSION;
  binding::bind_errors(module);
  binding::bind_artefacts(module);
  binding::bind_import_boxes(module);
  binding::bind_scene(module);
  binding::bind_records(module);
  binding::bind_flight_log(module);
  binding::bind_planner(module);
  binding::bind_trajectories(module);
}
