#pragma once

// An element of an SDF file, and the values in it.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geom/base/error.h"
#include "geom/text/xml_element.h"

namespace geom {

// Both must outlive it.
struct SdfNode {
  const XmlElement* element = nullptr;
  const std::string* source = nullptr;

  [[noreturn]] void refuse(Fault fault) const;

  SdfNode of(const XmlElement& child) const { return {&child, source}; }
  const std::string& name() const { return element->name; }

  // The child of that name, of no namespace; refuses more than one.
  std::optional<SdfNode> find(std::string_view child) const;
  SdfNode child(std::string_view child) const;  // refuses where there is none
  std::vector<SdfNode> all(std::string_view child) const;

  std::string attribute(std::string_view key) const;  // empty where it is not there

  // The text without white space around it.
  std::string_view text() const;
  // Of the text between white space: so many finite numbers within 1e8, without units.
  std::vector<double> numbers(std::size_t count) const;
  std::vector<double> not_negative(std::size_t count) const;
  double number_above_zero() const;
  bool flag() const;  // true or 1, false or 0
};

}  // namespace geom
