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
  throw geom::InputError(what,
                         {.expected = "metres",
                          .found = fmt::format("[{}, {}], which look like degrees", p.x(), p.y()),
                          .advice = fmt::format("the map's origin is at latitude {}, longitude {}, "
                                                "and its coordinates are metres from there",
                                                frame.origin->latitude, frame.origin->longitude)});
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
            "limits",
            {.key = name, .expected = "> 0 and finite", .found = std::string(py::str(value))});
      }
      limits[kind.limit] = number;
    }
    if (!known)
      throw geom::InputError("limits", {.says = fmt::format("there is no limit \"{}\"", name)});
  }
  return limits;
}

// In the order of reports.
py::tuple limited_quantities() {
  py::list out;
  for (const traj::Limit limit : traj::kOrderOfLimits) out.append(traj::kind_of(limit).quantity);
  return py::tuple(out);
}

py::dict dict_of(const traj::Limits& limits) {
  py::dict out;
  for (const traj::LimitKind& kind : traj::kLimitKinds) {
    if (const auto& limit = limits[kind.limit]) out[kind.name] = *limit;
  }
  return out;
}

// Text of a file need not be UTF-8.
py::object text_of(std::string_view text) {
  const auto size = static_cast<Py_ssize_t>(text.size());
  return py::reinterpret_steal<py::object>(PyUnicode_DecodeUTF8(text.data(), size, "replace"));
}

// The fields of an error as attributes: "" and None where it does not say.
void set_fields(py::object& to, std::string_view source, std::size_t line,
                const geom::Fault& fault) {
  to.attr("source") = text_of(source);
  to.attr("line") = line ? py::object(py::int_(line)) : py::none();
  to.attr("item") = text_of(fault.item);
  to.attr("key") = text_of(fault.key);
  to.attr("expected") = text_of(fault.expected);
  to.attr("found") = text_of(fault.found);
  to.attr("advice") = text_of(fault.advice);
}

// A class of the package's errors.py, which lives as long as the process.
PyObject* error_class(const char* name) {
  return py::object(py::module_::import("skyway.errors").attr(name)).release().ptr();
}

geom::Fault in_python(geom::Fault fault) {
  for (std::string* text :
       {&fault.item, &fault.key, &fault.says, &fault.expected, &fault.found, &fault.advice}) {
    *text = in_python(*text);
  }
  return fault;
}

void bind_input_error(py::module_& module) {
  static PyObject* const type = error_class("InputError");
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const geom::InputError& error) {
      py::object instance =
          py::reinterpret_borrow<py::object>(type)(text_of(in_python(error.what())));
      set_fields(instance, error.source(), error.line(), in_python(error.fault()));
      PyErr_SetObject(type, instance.ptr());
    }
  });
  module.def(
      "_refuse",
      [](const std::string& source, std::size_t line, std::string key, std::string says,
         std::string expected, std::string found) {
        throw geom::InputError(source, line,
                               {.key = std::move(key),
                                .says = std::move(says),
                                .expected = std::move(expected),
                                .found = std::move(found)});
      },
      py::kw_only(), py::arg("source"), py::arg("line") = 0, py::arg("key") = "",
      py::arg("says") = "", py::arg("expected") = "", py::arg("found") = "");
}

void bind_errors(py::module_& module) {
  bind_input_error(module);
  static PyObject* const usage_error = error_class("UsageError");
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const geom::UsageError& error) {
      PyErr_SetObject(usage_error, text_of(in_python(error.what())).ptr());
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
  module.attr("_limited_quantities") = binding::limited_quantities();
  module.def("in_python", [](const std::string& text) { return binding::in_python(text); });
  binding::bind_errors(module);
  binding::bind_artefacts(module);
  binding::bind_import_boxes(module);
  binding::bind_scene(module);
  binding::bind_records(module);
  binding::bind_flight_log(module);
  binding::bind_planner(module);
  binding::bind_trajectories(module);
  binding::bind_home(module);
  binding::bind_missions(module);
  binding::bind_pictures(module);
  binding::bind_zones(module);
}
