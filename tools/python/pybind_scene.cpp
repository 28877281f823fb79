// The collision structure: batches of queries on NumPy arrays as they stand, without the GIL.

#include <fmt/format.h>

#include <array>
#include <limits>
#include <string>

#include "cli/option/vehicle_word.h"
#include "geom/base/parallel.h"
#include "pybind_arrays.h"
#include "pybind_module.h"

namespace binding {
namespace {

using geom::Vec3;

constexpr std::size_t kBatch = 1024;

// Calls f(begin, end) for each batch of n, each on one thread.
template <class F>
void in_batches(std::size_t n, unsigned threads, const F& f) {
  geom::parallel_for((n + kBatch - 1) / kBatch, on_threads(threads), [&](std::size_t batch) {
    f(batch * kBatch, std::min(n, (batch + 1) * kBatch));
  });
}

// One point alone may look like degrees by chance.
void require_metres_of(const geom::Frame& frame, std::span<const Vec3> points) {
  if (points.size() > 1) require_metres(frame, points, "queries");
}

// Segments, (n, 6), or points, (n, 3), where they are.
struct Queries {
  std::span<const double> values;
  std::size_t columns;

  explicit Queries(const py::handle& object)
      : columns(py::hasattr(object, "shape") && py::len(object.attr("shape")) == 2 &&
                        object.attr("shape")[py::int_(1)].cast<std::size_t>() == 3
                    ? 3
                    : 6) {
    values = rows(object, static_cast<py::ssize_t>(columns), columns == 3 ? "points" : "segments");
  }
  std::size_t size() const { return values.size() / columns; }
  // While they are in the cache, not all of them beforehand.
  void require_coordinates(std::size_t begin, std::size_t end) const {
    binding::require_coordinates(values.subspan(begin * columns, (end - begin) * columns), columns,
                                 columns == 3 ? "points" : "segments", begin);
  }
  void require_metres(const geom::Frame& frame) const {
    require_metres_of(frame, {reinterpret_cast<const Vec3*>(values.data()), values.size() / 3});
  }
  Vec3 from(std::size_t i) const { return Vec3(values.data() + i * columns); }
  Vec3 to(std::size_t i) const { return Vec3(values.data() + i * columns + columns - 3); }
};

// answer(from, to) for each.
template <class Answer>
py::array each(const Scene& scene, const py::object& object, unsigned threads,
               const Answer& answer) {
  const Queries queries(object);
  queries.require_metres(scene.scene.map().spec().frame);
  std::vector<std::uint8_t> out(queries.size());
  {
    const Released released;
    in_batches(out.size(), threads, [&](std::size_t begin, std::size_t end) {
      queries.require_coordinates(begin, end);
      for (std::size_t i = begin; i < end; ++i) out[i] = answer(queries.from(i), queries.to(i));
    });
  }
  return owning<std::uint8_t, bool>(std::move(out));
}

py::array hits(const Scene& self, const py::object& object, unsigned threads) {
  return each(self, object, threads,
              [&](const Vec3& a, const Vec3& b) { return self.scene.hits(a, b); });
}

py::array is_free(const Scene& self, const py::object& object, unsigned threads) {
  return each(self, object, threads,
              [&](const Vec3& a, const Vec3& b) { return self.scene.free(a, b); });
}

py::array sweep_hits(const Scene& self, const py::object& object, const py::object& half_sizes,
                     unsigned threads) {
  const Vec3 half = vec3(half_sizes, "half");
  if (half.minCoeff() < 0) throw py::value_error("half: must be half sizes >= 0");
  return each(self, object, threads,
              [&](const Vec3& a, const Vec3& b) { return self.scene.sweep_hits(a, b, half); });
}

py::tuple nearest(const Scene& self, const py::object& object, double radius, unsigned threads) {
  const std::span<const Vec3> at = points(object, "points");
  if (!(radius >= 0)) throw py::value_error("radius: must be >= 0");
  require_metres_of(self.scene.map().spec().frame, at);
  std::vector<double> distance(at.size(), std::numeric_limits<double>::infinity());
  std::vector<std::int64_t> box(at.size(), -1);
  {
    const Released released;
    in_batches(at.size(), threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const auto found = self.scene.nearest(at[i], radius);
        if (!found) continue;
        distance[i] = found->distance;
        box[i] = static_cast<std::int64_t>(found->box);
      }
    });
  }
  return py::make_tuple(owning(std::move(distance)), owning(std::move(box)));
}

py::array boxes_meeting(const Scene& self, const py::object& min, const py::object& max) {
  const geom::Aabb region{vec3(min, "min"), vec3(max, "max")};
  if ((region.min.array() > region.max.array()).any()) {
    throw py::value_error("boxes_meeting: min must be <= max on every axis");
  }
  require_metres_of(self.scene.map().spec().frame, std::array{region.min, region.max});
  return owning(self.scene.boxes_meeting(region));
}

void bind_vehicle(py::module_& module) {
  using geom::Vehicle;
  py::class_<Vehicle>(module, "Vehicle")
      .def_readonly("name", &Vehicle::name)
      .def_property_readonly("half", [](const Vehicle& v) { return tuple_of(v.half); })
      .def_property_readonly("limits", [](const Vehicle& v) { return dict_of(v.limits); })
      .def("__eq__", [](const Vehicle& a, const Vehicle& b) { return a == b; });
  module.def(
      "vehicle", [](const std::string& word) { return cli::parse_vehicle(word).vehicle; },
      py::call_guard<geom::UsualArithmetic>());
}

}  // namespace

void bind_scene(py::module_& module) {
  bind_vehicle(module);
  py::class_<Scene>(module, "CollisionScene")
      .def(py::init([](const geom::BoxMap& map, const geom::Vehicle& vehicle, double margin) {
             if (!(margin >= 0 && margin <= 1e6)) {
               throw py::value_error(
                   fmt::format("margin: must be within 0 to 1e6 m, found {}", margin));
             }
             return Scene{geom::CollisionScene(map, vehicle, margin)};
           }),
           py::arg("map"), py::arg("vehicle"), py::arg("margin") = 0.0)
      .def_property_readonly("map", [](const Scene& s) { return s.scene.map(); })
      .def_property_readonly("vehicle", [](const Scene& s) { return s.scene.vehicle(); })
      .def_property_readonly("margin", [](const Scene& s) { return s.scene.margin(); })
      .def_property_readonly("limits",
                             [](const Scene& s) { return dict_of(s.scene.vehicle().limits); })
      .def_property_readonly("free_bounds",
                             [](const Scene& s) -> py::object {
                               const auto& bounds = s.scene.free_bounds();
                               if (!bounds) return py::none();
                               return py::make_tuple(tuple_of(bounds->min), tuple_of(bounds->max));
                             })
      .def("hits", &hits, py::arg("queries"), py::kw_only(), py::arg("threads") = 0)
      .def("free", &is_free, py::arg("queries"), py::kw_only(), py::arg("threads") = 0)
      .def("sweep_hits", &sweep_hits, py::arg("segments"), py::arg("half"), py::kw_only(),
           py::arg("threads") = 0)
      .def("nearest", &nearest, py::arg("points"),
           py::arg("radius") = std::numeric_limits<double>::infinity(), py::kw_only(),
           py::arg("threads") = 0)
      .def("boxes_meeting", &boxes_meeting, py::arg("min"), py::arg("max"));
}

}  // namespace binding
