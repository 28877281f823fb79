#pragma once

// NumPy arrays over memory of ours, and memory of theirs as spans: nothing is copied but where it
// says so.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "geom/base/vec3.h"

namespace binding {

namespace py = pybind11;

using Shape = std::vector<py::ssize_t>;

// A read-only array over `data`, which lives as long as the Python object `owner`. Without strides
// it is C-contiguous.
template <class T>
py::array view(const T* data, Shape shape, const py::object& owner, Shape strides = {}) {
  py::array out = strides.empty() ? py::array(py::dtype::of<T>(), shape, data, owner)
                                  : py::array(py::dtype::of<T>(), shape, strides, data, owner);
  out.attr("flags").attr("writeable") = false;
  return out;
}

// One member of each of many structs: `values` apart from its neighbours, and `stride` bytes on.
template <class Struct>
py::array column(const std::vector<Struct>& rows, const double* first, Shape inner,
                 const py::object& owner) {
  Shape shape{static_cast<py::ssize_t>(rows.size())};
  Shape strides{sizeof(Struct)};
  py::ssize_t step = sizeof(double);
  for (const py::ssize_t n : inner) step *= n;
  for (const py::ssize_t n : inner) {
    step /= n;
    shape.push_back(n);
    strides.push_back(step);
  }
  static const double kNone = 0;
  return view(rows.empty() ? &kNone : first, shape, owner, strides);
}

// An array that owns its values, which are moved into it.
template <class T, class U = T>
py::array owning(std::vector<T> values, Shape shape = {}) {
  static_assert(sizeof(T) == sizeof(U));
  if (shape.empty()) shape = {static_cast<py::ssize_t>(values.size())};
  auto* kept = new std::vector<T>(std::move(values));
  const py::capsule owner(kept, [](void* p) { delete static_cast<std::vector<T>*>(p); });
  return py::array(py::dtype::of<U>(), shape, kept->data(), owner);
}

// The rows of a C-contiguous float64 array of shape (n, columns), as they stand. The package's
// arguments.py makes such arrays of what users give; TypeError for others. `columns` 0: (n).
std::span<const double> rows(const py::handle& object, py::ssize_t columns, const char* what);

// InputError where a coordinate of the rows `first` and on is not finite or beyond
// geom::kLargestCoordinate. Needs no GIL.
void require_coordinates(std::span<const double> values, std::size_t columns, const char* what,
                         std::size_t first = 0);

// Both, and as points.
std::span<const geom::Vec3> points(const py::handle& object, const char* what);

geom::Vec3 vec3(const py::handle& object, const char* what);  // of an array (3)
py::tuple tuple_of(const geom::Vec3& v);

py::object from_json(std::string_view text);  // None where it is empty

}  // namespace binding
