#pragma once

// The Stanford triangle format (Turk 1994): its head, and rows of numbers of whatever elements.

#include <istream>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geom/base/error.h"
#include "moved_comment.h"
#include "point_chunks.h"

namespace geom {

struct PlyProperty {
  std::string name;
  Scalar scalar;
  std::optional<Scalar> count;  // of a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  // The one of that name, a list or not; nothing where there is none.
  std::optional<std::size_t> find(std::string_view property, bool list) const;

  // Whether its rows may join vertices to lines or surfaces: it is an edge, has a list, or
  // two whole numbers. Cameras and materials, as programs write them, do not.
  bool holds_indices() const;

  // Whether its rows are places: they have x, y and z.
  bool holds_places() const;

  // Whether its rows are splats of a radiance field, which reach beyond their places.
  bool holds_splats() const;
};

// The numbers of one of an element, property by property: lists have any number of them.
class PlyRow {
 public:
  std::span<const double> of(std::size_t property) const {
    return std::span(values_).subspan(begins_[property], begins_[property + 1] - begins_[property]);
  }

 private:
  friend class PlyFile;
  std::vector<double> values_;
  std::vector<std::size_t> begins_;
};

// Reads the head at once. All throw InputError(source, …) for what is malformed or cut short.
class PlyFile {
 public:
  PlyFile(std::istream& in, std::string_view source);

  const std::vector<PlyElement>& elements() const { return elements_; }
  const CoordinateReference& told() const { return comments_.told(); }

  // Calls f(row, number) for each of an element. Elements must be read in their order, each once.
  template <class F>
  void for_each_row(const PlyElement& element, const F& f) {
    if (element.properties.empty()) return;  // takes no bytes, whatever count it claims
    for (std::uint64_t i = 0; i < element.count; ++i) {
      read_row(element, i);
      f(row_, i);
    }
  }

  void require_end();  // after the last

  [[noreturn]] void refuse(Fault fault) const;

 private:
  enum class Encoding { ascii, little, big };

  std::string next_line();
  Scalar scalar(const std::string& word) const;
  void read_header();
  void set_format(const std::string& name);
  void add_property(std::istream& words);
  void read_row(const PlyElement& element, std::uint64_t i);
  void require_row_end(const PlyElement& element, std::uint64_t i);
  double next_scalar(const PlyElement& element, const Scalar& scalar, std::uint64_t i);

  std::istream& in_;
  std::string source_;
  std::size_t line_ = 0;
  Encoding encoding_ = Encoding::ascii;
  std::vector<PlyElement> elements_;
  MovedComments comments_;
  PlyRow row_;
};

}  // namespace geom
