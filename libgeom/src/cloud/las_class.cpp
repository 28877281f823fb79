#include "geom/cloud/las_class.h"

#include <array>
#include <cmath>

#include "geom/text/text_table.h"

namespace geom {
namespace {

struct Named {
  std::string_view name;
  std::array<std::uint8_t, 3> classes;
  std::size_t count = 1;
};

constexpr Named kNames[] = {
    {"bridge", {17}},
    {"building", {6}},
    {"ground", {2}},
    {"high-vegetation", {5}},
    {"ignored-ground", {20}},
    {"low-vegetation", {3}},
    {"medium-vegetation", {4}},
    {"never-classified", {0}},
    {"noise", {7, 18}, 2},
    {"overhead-structure", {19}},
    {"rail", {10}},
    {"road", {11}},
    {"snow", {21}},
    {"temporal-exclusion", {22}},
    {"tower", {15}},
    {"unclassified", {1}},
    {"vegetation", {3, 4, 5}, 3},
    {"water", {9}},
    {"wire", {13, 14, 16}, 3},
};

constexpr std::string_view kText =
    "bridge, building, ground, high-vegetation, ignored-ground, low-vegetation, medium-vegetation, "
    "never-classified, noise, overhead-structure, rail, road, snow, temporal-exclusion, tower, "
    "unclassified, vegetation, water, wire";

}  // namespace

std::span<const std::uint8_t> las_classes(std::string_view name) {
  for (const Named& named : kNames) {
    if (named.name == name) return {named.classes.data(), named.count};
  }
  return {};
}

std::bitset<256> las_class_set(std::string_view word) {
  std::bitset<256> out;
  for (const std::uint8_t cls : las_classes(word)) out.set(cls);
  if (out.any()) return out;
  const auto number = parse_number(word);
  const bool known = number && *number >= 0 && *number <= 255 && *number == std::floor(*number);
  if (known) out.set(static_cast<std::size_t>(*number));
  return out;
}

std::string_view las_class_names() { return kText; }

}  // namespace geom
