#pragma once

// The parts of the Python module.

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "geom/base/execution.h"
#include "geom/base/usual_arithmetic.h"
#include "geom/collision/collision.h"
#include "geom/record/agreed_room.h"
#include "geom/record/record.h"
#include "traj/proof/limits.h"

namespace binding {

namespace py = pybind11;

// What work of the libraries needs: no lock of Python, and the usual arithmetic.
struct Released {
  py::gil_scoped_release lock;
  geom::UsualArithmetic arithmetic;
};

void bind_errors(py::module_& module);
void bind_artefacts(py::module_& module);  // box maps, lattices, roadmaps
void bind_import_boxes(py::module_& module);
void bind_scene(py::module_& module);
void bind_records(py::module_& module);  // paths, trajectories, queries
void bind_flight_log(py::module_& module);
void bind_planner(py::module_& module);
void bind_trajectories(py::module_& module);  // solve and check
void bind_zones(py::module_& module);         // of airspace
void bind_home(py::module_& module);          // returns and ways home
void bind_missions(py::module_& module);      // export_mission, check_submission
void bind_pictures(py::module_& module);      // SVG, and the page of skyway-view

// A scene: the class that Python sees.
struct Scene {
  geom::CollisionScene scene;
};

geom::Execution on_threads(unsigned threads);  // 0: all

// A message of the libraries with the keyword arguments of Python in place of a tool's options.
std::string in_python(std::string_view message);

// The scene's vehicle, with the limits that hold for the record. A record of another map must not
// be taken for one of this: throws geom::InputError(id, …).
geom::Vehicle agreed_vehicle(const geom::Provenance& record, const geom::CollisionScene& scene,
                             geom::Differences differences, const std::string& id);

// A path record, or an array of points.
geom::PathRecord path_from(const py::object& object);

// Throws geom::InputError(what, …) for points that look like degrees (geom::look_like_degrees).
void require_metres(const geom::Frame& frame, std::span<const geom::Vec3> points,
                    const std::string& what);

traj::Limits limits_from(const py::object& object);  // a dict by the names of records, or None
py::dict dict_of(const traj::Limits& limits);

// What a record says of its origin, as attributes: None where it does not say.
template <class Class, class Get>
void def_provenance(Class& of, const Get& get) {
  using Self = typename Class::type;
  of.def_property_readonly("map", [get](const Self& self) { return get(self).map; });
  of.def_property_readonly("frame", [get](const Self& self) {
    const auto frame = get(self).frame;
    return frame ? std::optional(std::string(geom::name(*frame))) : std::nullopt;
  });
  of.def_property_readonly("vehicle", [get](const Self& self) { return get(self).vehicle; });
  of.def_property_readonly("margin", [get](const Self& self) { return get(self).margin; });
}

}  // namespace binding
