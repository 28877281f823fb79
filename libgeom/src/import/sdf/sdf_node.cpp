#include "sdf_node.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geom/base/error.h"
#include "geom/base/vec3.h"
#include "geom/text/text_table.h"

namespace geom {
namespace {

constexpr std::string_view kSpace = " \t\r\n";

}  // namespace

void SdfNode::refuse(Fault fault) const {
  throw InputError(*source, element->line, std::move(fault));
}

std::vector<SdfNode> SdfNode::all(std::string_view child) const {
  std::vector<SdfNode> out;
  for (const XmlElement& c : element->children) {
    if (c.name == child && c.prefix.empty()) out.push_back(of(c));
  }
  return out;
}

std::optional<SdfNode> SdfNode::find(std::string_view child) const {
  const std::vector<SdfNode> found = all(child);
  if (found.empty()) return std::nullopt;
  if (found.size() > 1) {
    found[1].refuse(
        {.expected = fmt::format("one <{}> in <{}>", child, name()), .found = "another"});
  }
  return found[0];
}

SdfNode SdfNode::child(std::string_view child) const {
  if (const auto found = find(child)) return *found;
  refuse({.expected = fmt::format("<{}> in <{}>", child, name()), .found = "none"});
}

std::string SdfNode::attribute(std::string_view key) const {
  for (const auto& [name, value] : element->attributes) {
    if (name == key) return value;
  }
  return {};
}

std::string_view SdfNode::text() const {
  std::string_view text = element->text;
  text.remove_prefix(std::min(text.find_first_not_of(kSpace), text.size()));
  return text.substr(0, text.find_last_not_of(kSpace) + 1);
}

std::vector<double> SdfNode::numbers(std::size_t count) const {
  std::vector<double> out;
  std::string_view rest = text();
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find_first_of(kSpace), rest.size());
    const std::string_view word = rest.substr(0, end);
    rest.remove_prefix(end);
    rest.remove_prefix(std::min(rest.find_first_not_of(kSpace), rest.size()));
    const bool two_signs = word.starts_with("+-") || word.starts_with("++");
    const auto value = two_signs ? std::nullopt : parse_number(word);
    if (!value || !(std::abs(*value) <= kLargestCoordinate)) {
      refuse({.says = fmt::format("<{}> must have finite numbers within 1e8 without units", name()),
              .found = in_quotes(word.substr(0, 40))});
    }
    out.push_back(*value);
  }
  if (out.size() != count) {
    refuse({.says = fmt::format("<{}> must have {} number{}", name(), count, count == 1 ? "" : "s"),
            .found = fmt::to_string(out.size())});
  }
  return out;
}

std::vector<double> SdfNode::not_negative(std::size_t count) const {
  std::vector<double> out = numbers(count);
  for (const double v : out) {
    if (v < 0)
      refuse({.key = fmt::format("<{}>", name()), .expected = ">= 0", .found = fmt::to_string(v)});
  }
  return out;
}

double SdfNode::number_above_zero() const {
  const double value = numbers(1)[0];
  if (!(value > 0))
    refuse({.key = fmt::format("<{}>", name()), .expected = "> 0", .found = fmt::to_string(value)});
  return value;
}

bool SdfNode::flag() const {
  const std::string_view word = text();
  if (word == "true" || word == "1") return true;
  if (word == "false" || word == "0") return false;
  refuse({.key = fmt::format("<{}>", name()),
          .expected = "true or false",
          .found = in_quotes(word.substr(0, 40))});
}

}  // namespace geom
