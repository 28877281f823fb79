#include "geom/zone/read_zones.h"

#include "ed269.h"
#include "ed318.h"
#include "faa_grid.h"

namespace geom {
namespace {

constexpr std::string_view kReaders[] = {"skyway-map"};

}  // namespace

// They begin as GeoJSON and other JSON do, so no beginning tells of them.
constexpr Format kEd269Zones{.what = "zones of airspace (EUROCAE ED-269)",
                             .readers = kReaders,
                             .advice = "skyway-map patch MAP --zones FILE closes them in a map"};

constexpr Format kEd318Zones{.what = "zones of airspace (EUROCAE ED-318)",
                             .readers = kReaders,
                             .advice = "skyway-map patch MAP --zones FILE closes them in a map"};

constexpr Format kFaaFacilityMap{
    .what = "a UAS facility map of the FAA",
    .readers = kReaders,
    .advice = "skyway-map patch MAP --zones FILE closes its cells in a map"};

Formats zone_formats() {
  static constexpr const Format* kAll[] = {&kEd269Zones, &kEd318Zones, &kFaaFacilityMap};
  return kAll;
}

ZoneFile read_zones(std::string_view text, std::string_view source) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  const nlohmann::json root = parse_json(text, source);
  const std::string name(source);
  ZoneFile out;
  if (zone::is_faa_grid(root)) {
    out = zone::read_faa_grid(root, name);
  } else if (zone::is_ed318(root)) {
    out = zone::read_ed318(root, name);
  } else if (zone::is_ed269(root)) {
    out = zone::read_ed269(root, name);
  } else {
    throw InputError(source, {.expected = "zones of ED-269 or ED-318, or a UAS facility map of the "
                                          "FAA, with one zone at least",
                              .found = shown(root).substr(0, 60),
                              .advice = "volumes of other GeoJSON are read by --keep-out"});
  }
  return out;
}

}  // namespace geom
