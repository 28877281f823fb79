#pragma once

// The keyword arguments of a Python function that makes a map, held to the ranges of the tools.

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geom/base/format.h"
#include "geom/base/vec3.h"
#include "geom/map/frame.h"
#include "geom/map/make_map.h"
#include "pybind_module.h"

namespace binding {

// Each throws TypeError where a value is of another type, and cli::UsageError where it is out of
// its range or none of the words. None stands for an argument that was not given.
class Keywords {
 public:
  explicit Keywords(py::dict values) : values_(std::move(values)) {}

  double number(const char* name, double least, double most) const;
  std::optional<double> optional_number(const char* name, double least, double most) const;
  std::size_t count(const char* name, std::size_t least, std::size_t most) const;
  bool flag(const char* name) const;
  std::string text(const char* name) const;                // "" where it is None
  std::vector<std::string> texts(const char* name) const;  // numbers as their digits
  std::vector<double> numbers(const char* name) const;     // empty where it is None
  // One of the words, or "" where it is None.
  std::string word(const char* name, std::initializer_list<std::string_view> words) const;

  // The row of a table of formats that "format" names; null where it is "auto".
  template <class Row>
  const Row* format(geom::FormatRows<Row> table) const {
    const std::string word = text("format");
    if (word == "auto") return nullptr;
    if (const Row* const row = geom::row_named(word, table)) return row;
    refuse_format(word, geom::words_of(table));
  }

  // Metres in the unit of that name (cli::kMetres).
  std::optional<double> unit(const char* name) const;
  // (latitude, longitude) or (latitude, longitude, height): degrees and metres.
  std::optional<geom::GeodeticOrigin> origin(const char* name) const;
  // seal, floor, ceiling, pad, scale, bloat_percent, inflate, bounds and tile.
  geom::MakeMapOptions map() const;

 private:
  [[noreturn]] static void refuse_format(const std::string& word,
                                         const std::vector<std::string_view>& words);
  py::object value(const char* name) const { return values_[name]; }
  template <class T>
  T as(const char* name, const char* expected) const;

  py::dict values_;
};

}  // namespace binding
