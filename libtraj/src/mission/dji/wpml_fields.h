#pragma once

// The children of an element of WPML by name, with nothing overlooked.

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "geom/base/error.h"
#include "xml_element.h"

namespace traj {

// Which children an element may have: names with their prefix ("wpml:index", "Placemark").
struct WpmlChildren {
  std::vector<std::string_view> once;
  std::vector<std::string_view> many = {};
  bool others = false;  // whatever else there is, is passed over
};

class WpmlFields {
 public:
  // Throws geom::InputError(source, line, …) for other children, and for one of `once` that comes
  // twice. `element` must outlive this.
  WpmlFields(const XmlElement& element, std::string source, const WpmlChildren& children);

  [[noreturn]] void refuse(const XmlElement& at, geom::Fault fault) const;
  const XmlElement& element() const { return element_; }
  const std::string& source() const { return source_; }

  const XmlElement* find(std::string_view name) const;              // nothing where it is not there
  const XmlElement& child(std::string_view name) const;             // throws where it is not there
  std::vector<const XmlElement*> all(std::string_view name) const;  // of `many`, in their order

  // Their values, without white space around. They throw where the child is not there, has children
  // of its own, or has another value.
  std::string text(std::string_view name) const;
  double number(std::string_view name, double least, double most) const;
  int whole(std::string_view name) const;  // 0 to 65535
  std::string word(std::string_view name, std::initializer_list<std::string_view> known) const;

 private:
  const XmlElement& element_;
  std::string source_;
};

// "wpml:index" of the element of that name and prefix.
std::string wpml_name(const XmlElement& element);

// What stands in an element without children, without white space around.
std::string wpml_text(const XmlElement& element, const std::string& source);

// A number as it stands in such a text; nothing for what is none, or not finite.
bool read_wpml_number(std::string_view text, double& value);

}  // namespace traj
