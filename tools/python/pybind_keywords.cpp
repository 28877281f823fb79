#include "pybind_keywords.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "cli/answer/exit.h"
#include "cli/option/units.h"

namespace binding {
namespace {

constexpr double kFurthest = 1e8;  // metres

std::string shown(const py::handle& object) { return py::str(py::repr(object)); }

}  // namespace

template <class T>
T Keywords::as(const char* name, const char* expected) const {
  try {
    return value(name).cast<T>();
  } catch (const py::cast_error&) {
    throw py::type_error(
        fmt::format("{}: expected {}, found {}", name, expected, shown(value(name))));
  }
}

double Keywords::number(const char* name, double least, double most) const {
  const auto number = as<double>(name, "a number");
  if (least <= number && number <= most) return number;
  throw cli::UsageError(fmt::format("{}: expected a number within {} to {}, found {}", name, least,
                                    most, shown(value(name))));
}

std::optional<double> Keywords::optional_number(const char* name, double least, double most) const {
  if (value(name).is_none()) return std::nullopt;
  return number(name, least, most);
}

std::size_t Keywords::count(const char* name, std::size_t least, std::size_t most) const {
  const auto count = as<std::size_t>(name, "a whole number");
  if (least <= count && count <= most) return count;
  throw cli::UsageError(fmt::format("{}: expected a whole number within {} to {}, found {}", name,
                                    least, most, count));
}

bool Keywords::flag(const char* name) const { return as<bool>(name, "True or False"); }

std::string Keywords::text(const char* name) const {
  return value(name).is_none() ? "" : as<std::string>(name, "text");
}

std::vector<std::string> Keywords::texts(const char* name) const {
  std::vector<std::string> out;
  for (const py::handle& one : as<py::sequence>(name, "a sequence")) {
    out.push_back(py::str(one));
  }
  return out;
}

std::vector<double> Keywords::numbers(const char* name) const {
  if (value(name).is_none()) return {};
  return as<std::vector<double>>(name, "a sequence of numbers");
}

std::string Keywords::word(const char* name, std::initializer_list<std::string_view> words) const {
  std::string word = text(name);
  const bool known = word.empty() || std::find(words.begin(), words.end(), word) != words.end();
  if (known) return word;
  throw cli::UsageError(
      fmt::format("{}: expected one of {}, found \"{}\"", name, fmt::join(words, ", "), word));
}

void Keywords::refuse_format(const std::string& word, const std::vector<std::string_view>& words) {
  throw cli::UsageError(fmt::format("format: expected auto or one of {}, found \"{}\"",
                                    fmt::join(words, ", "), word));
}

std::optional<double> Keywords::unit(const char* name) const {
  const std::string word = text(name);
  if (word.empty()) return std::nullopt;
  const auto known = cli::kMetres.find(word);
  if (known != cli::kMetres.end()) return known->second;
  throw cli::UsageError(
      fmt::format("{}: expected a unit of length, as \"ft\", found \"{}\"", name, word));
}

std::optional<geom::GeodeticOrigin> Keywords::origin(const char* name) const {
  if (value(name).is_none()) return std::nullopt;
  std::vector<double> v = numbers(name);
  if (v.size() == 2) v.push_back(0);
  const bool right =
      v.size() == 3 && std::abs(v[0]) <= 90 && std::abs(v[1]) <= 180 && std::abs(v[2]) <= kFurthest;
  if (right) return geom::GeodeticOrigin{v[0], v[1], v[2]};
  throw cli::UsageError(fmt::format(
      "{}: expected latitude and longitude in degrees, and a height in metres where it is known, "
      "found {}",
      name, shown(value(name))));
}

geom::MakeMapOptions Keywords::map() const {
  geom::MakeMapOptions map;
  map.seal = optional_number("seal", 0, 1e6);
  map.floor = optional_number("floor", -kFurthest, kFurthest);
  map.ceiling = optional_number("ceiling", -kFurthest, kFurthest);
  map.pad = optional_number("pad", 0, 1e6);
  map.scale = number("scale", 1e-9, 1e9);
  map.bloat_percent = number("bloat_percent", 0, 1000);
  map.inflate = number("inflate", 0, 1e4);
  map.tile_size = number("tile", 1, 1e6);
  if (value("bounds").is_none()) return map;
  const auto corners = as<std::vector<std::vector<double>>>("bounds", "two corners");
  if (corners.size() != 2 || corners[0].size() != 3 || corners[1].size() != 3) {
    throw cli::UsageError("bounds: expected the lower and the upper corner, found " +
                          shown(value("bounds")));
  }
  if (map.floor || map.ceiling || map.pad) {
    throw cli::UsageError("bounds: stand in place of floor, ceiling and pad, so give one of both");
  }
  const geom::Aabb box{geom::Vec3(corners[0].data()), geom::Vec3(corners[1].data())};
  if (!(box.min.array() <= box.max.array()).all() ||
      !(box.min.cwiseAbs().maxCoeff() <= kFurthest) ||
      !(box.max.cwiseAbs().maxCoeff() <= kFurthest)) {
    throw cli::UsageError("bounds: expected finite corners, the lower one first, found " +
                          shown(value("bounds")));
  }
  map.bounds = box;
  return map;
}

}  // namespace binding
