#include "wpml_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geom/base/error.h"
#include "geom/text/excerpt.h"
#include "geom/text/number.h"

namespace traj {
namespace {

constexpr std::string_view kSpace = " \t\r\n";

bool has(const std::vector<std::string_view>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

std::string wpml_name(const XmlElement& element) {
  return element.prefix.empty() ? element.name : element.prefix + ':' + element.name;
}

std::string wpml_text(const XmlElement& element, const std::string& source) {
  if (!element.children.empty()) {
    throw geom::InputError(
        source, element.children.front().line,
        {.expected = fmt::format("a value in <{}>", geom::excerpt(wpml_name(element))),
         .found = "an element"});
  }
  const std::size_t first = std::min(element.text.find_first_not_of(kSpace), element.text.size());
  const std::size_t last = element.text.find_last_not_of(kSpace);
  return last == element.text.npos ? "" : element.text.substr(first, last + 1 - first);
}

bool read_wpml_number(std::string_view text, double& value) {
  const auto [rest, error] = geom::read_number(text.data(), text.data() + text.size(), value);
  return error == std::errc() && rest == text.data() + text.size() && std::isfinite(value);
}

WpmlFields::WpmlFields(const XmlElement& element, std::string source, const WpmlChildren& children)
    : element_(element), source_(std::move(source)) {
  std::vector<std::string> found;
  for (const XmlElement& child : element.children) {
    const std::string name = wpml_name(child);
    if (has(children.many, name)) continue;
    if (!has(children.once, name)) {
      if (children.others) continue;
      refuse(child,
             {.says = fmt::format("<{}> in <{}> is not known here, and might move the aircraft",
                                  geom::excerpt(name), geom::excerpt(wpml_name(element)))});
    }
    if (std::find(found.begin(), found.end(), name) != found.end()) {
      refuse(child,
             {.expected = fmt::format("one <{}> in <{}>", name, geom::excerpt(wpml_name(element))),
              .found = "two"});
    }
    found.push_back(name);
  }
}

void WpmlFields::refuse(const XmlElement& at, geom::Fault fault) const {
  throw geom::InputError(source_, at.line, std::move(fault));
}

const XmlElement* WpmlFields::find(std::string_view name) const {
  for (const XmlElement& child : element_.children) {
    if (wpml_name(child) == name) return &child;
  }
  return nullptr;
}

const XmlElement& WpmlFields::child(std::string_view name) const {
  const XmlElement* found = find(name);
  if (!found) {
    refuse(element_,
           {.expected = fmt::format("<{}> in <{}>", name, wpml_name(element_)), .found = "none"});
  }
  return *found;
}

std::vector<const XmlElement*> WpmlFields::all(std::string_view name) const {
  std::vector<const XmlElement*> found;
  for (const XmlElement& child : element_.children) {
    if (wpml_name(child) == name) found.push_back(&child);
  }
  return found;
}

std::string WpmlFields::text(std::string_view name) const {
  return wpml_text(child(name), source_);
}

double WpmlFields::number(std::string_view name, double least, double most) const {
  const std::string said = text(name);
  double value = 0;
  if (!read_wpml_number(said, value) || !(value >= least) || !(value <= most)) {
    refuse(child(name), {.key = fmt::format("<{}>", name),
                         .expected = fmt::format("a number from {} to {}", least, most),
                         .found = geom::in_quotes(geom::excerpt(said))});
  }
  return value;
}

int WpmlFields::whole(std::string_view name) const {
  const double value = number(name, 0, 65535);
  if (value != std::floor(value)) {
    refuse(child(name), {.key = fmt::format("<{}>", name),
                         .expected = "a whole number",
                         .found = fmt::to_string(value)});
  }
  return static_cast<int>(value);
}

std::string WpmlFields::word(std::string_view name,
                             std::initializer_list<std::string_view> known) const {
  const std::string said = text(name);
  if (std::find(known.begin(), known.end(), said) == known.end()) {
    refuse(child(name), {.key = fmt::format("<{}>", name),
                         .expected = fmt::to_string(fmt::join(known, " or ")),
                         .found = geom::in_quotes(geom::excerpt(said))});
  }
  return said;
}

}  // namespace traj
