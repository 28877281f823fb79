#include "pybind_arrays.h"

#include <fmt/format.h>

#include <cmath>

#include "geom/base/error.h"
#include "geom/base/usual_arithmetic.h"

namespace binding {
std::span<const double> rows(const py::handle& object, py::ssize_t columns, const char* what) {
  if (py::isinstance<py::array_t<double, py::array::c_style>>(object)) {
    const auto array = py::reinterpret_borrow<py::array>(object);
    const bool fits = columns ? array.ndim() == 2 && array.shape(1) == columns : array.ndim() == 1;
    if (fits) {
      return {static_cast<const double*>(array.data()), static_cast<std::size_t>(array.size())};
    }
  }
  throw py::type_error(std::string(what) + ": expected a C-contiguous float64 array");
}

void require_coordinates(std::span<const double> values, std::size_t columns, const char* what,
                         std::size_t first) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::abs(values[i]) <= geom::kLargestCoordinate) continue;  // false for NaN too
    throw geom::InputError(fmt::format("{}[{}]", what, first + i / columns),
                           {.key = "coordinates",
                            .expected = "finite and within 1e8",
                            .found = fmt::to_string(values[i])});
  }
}

std::span<const geom::Vec3> points(const py::handle& object, const char* what) {
  static_assert(sizeof(geom::Vec3) == 3 * sizeof(double));
  const std::span<const double> values = rows(object, 3, what);
  require_coordinates(values, 3, what);
  return {reinterpret_cast<const geom::Vec3*>(values.data()), values.size() / 3};
}

geom::Vec3 vec3(const py::handle& object, const char* what) {
  const std::span<const double> values = rows(object, 0, what);
  if (values.size() != 3) throw py::type_error(std::string(what) + ": expected three numbers");
  require_coordinates(values, 3, what);
  return geom::Vec3(values.data());
}

py::tuple tuple_of(const geom::Vec3& v) { return py::make_tuple(v[0], v[1], v[2]); }

py::object from_json(std::string_view text) {
  if (text.empty()) return py::none();
  const geom::UsualArithmetic usual;
  return py::module_::import("json").attr("loads")(text);
}

}  // namespace binding
