#include "geom/gis/footprint_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geom/base/error.h"
#include "geom/text/text_table.h"
#include "required_reference.h"

namespace geom::gis {
namespace {

constexpr std::size_t kNamed = 4;  // attributes in a message

const char* key_of(HeightFrom from) {
  switch (from) {
    case HeightFrom::height:
      return "heights_given";
    case HeightFrom::levels:
      return "heights_from_levels";
    case HeightFrom::nothing:
      break;
  }
  return "heights_by_default";
}

std::size_t count_of(const Source& source, const char* what) {
  const auto at = source.counts.find(what);
  return at == source.counts.end() ? 0 : at->second;
}

// Those that most features have first.
std::string numeric_attributes(const Source& source) {
  std::vector<std::pair<std::string, NumericAttribute>> list(source.numeric.begin(),
                                                             source.numeric.end());
  std::stable_sort(list.begin(), list.end(), [](const auto& a, const auto& b) {
    return a.second.features > b.second.features;
  });
  std::string out;
  for (std::size_t i = 0; i < std::min(kNamed, list.size()); ++i) {
    const auto& [name, numbers] = list[i];
    out += fmt::format("{}\"{}\" ({} to {}, in {})", out.empty() ? "" : ", ", name.substr(0, 60),
                       numbers.low, numbers.high, numbers.features);
  }
  return list.size() > kNamed ? out + ", …" : out;
}

}  // namespace

void count_height(const BuildingHeight& height, const std::string& which, Source& source) {
  ++source.counts[key_of(height.from)];
  if (height.junk) ++source.counts["heights_not_understood"];
  source.has_height_attribute |= height.asked;
  if (height.unread) source.skipped.add("height that is not understood", which);
  if (height.from != HeightFrom::nothing) return;
  if (height.tower) source.skipped.add("tower, mast or the like without a height", which);
  source.defaults.add("footprint", which);
}

void require_attribute(const Source& source, const ReadOptions& options, const std::string& name) {
  if (options.height.attribute.empty() || source.has_height_attribute) return;
  throw InputError(name,
                   {.expected = fmt::format(
                        "an attribute \"{}\" (--height-attribute) of what is built by its height",
                        options.height.attribute),
                    .found = "none",
                    .advice = "correct the name, or leave the option out"});
}

std::uint32_t label_of(const std::string& type, const std::string& object,
                       const ReadOptions& options, Source& source) {
  std::string label = type;
  if (options.label_by == LabelBy::object) label += ": " + object;
  const auto next = static_cast<std::uint32_t>(source.labels.size() + 1);
  return source.labels.try_emplace(std::move(label), next).first->second;
}

void require_types(const std::map<std::string, std::size_t>& types, const ReadOptions& options,
                   const std::string& name) {
  for (const std::string& type : options.types) {
    if (types.contains(type)) continue;
    std::string known;
    for (const auto& [one, count] : types) {
      known += fmt::format("{}{} ({})", known.empty() ? "" : ", ", one.substr(0, 60), count);
    }
    throw InputError(name, {.expected = "types of the file in --types: " + known,
                            .found = fmt::format("\"{}\"", type.substr(0, 60))});
  }
}

void note_attribute(const std::string& name, const std::string& value, Source& source) {
  const auto number = parse_number(trimmed(value));
  if (!number || !std::isfinite(*number)) return;
  NumericAttribute& known =
      source.numeric.try_emplace(name, NumericAttribute{0, *number, *number}).first->second;
  ++known.features;
  known.low = std::min(known.low, *number);
  known.high = std::max(known.high, *number);
}

std::string heights_fault(const Source& source) {
  const std::size_t without = count_of(source, "heights_by_default");
  std::size_t all = without;
  for (const char* key : {"heights_given", "heights_from_levels", "heights_from_corners"}) {
    all += count_of(source, key);
  }
  if (without * 10 <= all) return "";
  const std::string numeric = numeric_attributes(source);
  return fmt::format(
      "expected heights of at least nine buildings in ten, found none for {} of {}: say how high "
      "those are with --default-height METRES{}",
      without, all,
      numeric.empty() ? "; they have no attribute of numbers"
                      : ", or name the attribute that is the height with --height-attribute; "
                        "numbers that they have: " +
                            numeric);
}

std::optional<double> height_unit(const std::optional<ProjReference>& crs, const std::string& name,
                                  const ReadOptions& options) {
  if (!crs) return options.height_unit.value_or(1);
  require_upward(*crs, name);
  if (options.height_unit) return options.height_unit;
  if (crs->told().up || crs->told().up_unclear) return crs->told().up;
  if (crs->is_geographic() || std::abs(crs->unit().value_or(0) - 1) < 1e-9) return 1;
  return std::nullopt;
}

void refuse_heights(const std::string& name, const ProjReference& crs) {
  throw InputError(
      name,
      {.says = fmt::format(
           "the file has coordinates in units of {} m, and does not say the unit of its heights",
           crs.unit().value_or(1)),
       .advice = "give --height-units m, ft or us-ft"});
}

}  // namespace geom::gis
