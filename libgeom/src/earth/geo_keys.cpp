#include <fmt/format.h>

#include "geom/earth/coordinate_reference.h"

// GeoTIFF 1.1, OGC 19-008r4, 7.4: numbers of keys below are those of the standard.

namespace geom {
namespace {

using Kind = CoordinateReference::Kind;

constexpr std::uint16_t kModelType = 1024;
constexpr std::uint16_t kGeodeticCrs = 2048;
constexpr std::uint16_t kProjectedCrs = 3072;
constexpr std::uint16_t kPlaneUnit = 3076;
constexpr std::uint16_t kPlaneUnitSize = 3077;
constexpr std::uint16_t kVerticalCrs = 4096;
constexpr std::uint16_t kVerticalUnit = 4099;
constexpr std::uint16_t kUserDefined = 32767;
constexpr std::uint16_t kDoubles = 34736;

class Keys {
 public:
  Keys(std::span<const std::uint16_t> directory, std::span<const double> doubles)
      : directory_(directory), doubles_(doubles) {}

  bool valid() const {
    return directory_.size() >= 4 && directory_[0] == 1 &&
           directory_.size() >= 4 + 4 * std::size_t{directory_[3]};
  }

  // The short that stands for a key; nothing where it is absent or 0 (undefined).
  std::optional<std::uint16_t> code(std::uint16_t key) const {
    const std::uint16_t* const entry = find(key);
    if (!entry || entry[1] != 0 || entry[3] == 0) return std::nullopt;
    return entry[3];
  }
  std::optional<double> number(std::uint16_t key) const {
    const std::uint16_t* const entry = find(key);
    if (!entry || entry[1] != kDoubles || entry[3] >= doubles_.size()) return std::nullopt;
    return doubles_[entry[3]];
  }

 private:
  const std::uint16_t* find(std::uint16_t key) const {
    for (std::size_t i = 0; i < directory_[3]; ++i) {
      if (directory_[4 + 4 * i] == key) return &directory_[4 + 4 * i];
    }
    return nullptr;
  }

  std::span<const std::uint16_t> directory_;
  std::span<const double> doubles_;
};

// EPSG's units of length.
std::optional<double> metres_of_unit(std::uint16_t code) {
  switch (code) {
    case 9001:
      return 1.0;
    case 9002:
      return 0.3048;
    case 9003:
      return 1200.0 / 3937;
    case 9036:
      return 1000.0;
    default:
      return std::nullopt;
  }
}

// UTM on WGS 84, ETRS89 and NAD83.
bool is_utm(std::uint16_t code) {
  return (code >= 32601 && code <= 32660) || (code >= 32701 && code <= 32760) ||
         (code >= 25828 && code <= 25838) || (code >= 26901 && code <= 26923);
}

// Heights above EGM2008, NAVD88, NAP, EGM96, EVRF2007, DHHN92, DHHN2016 and N2000, in metres; above
// NAVD88 in feet.
std::optional<double> metres_of_vertical(std::uint16_t code) {
  for (const std::uint16_t metric : {3855, 5703, 5709, 5773, 5621, 5783, 7837, 3900}) {
    if (code == metric) return 1.0;
  }
  if (code == 6360) return 1200.0 / 3937;
  if (code == 8228) return 0.3048;
  return std::nullopt;
}

}  // namespace

CoordinateReference reference_of_geo_keys(std::span<const std::uint16_t> directory,
                                          std::span<const double> doubles) {
  const Keys keys(directory, doubles);
  CoordinateReference out;
  out.name = "GeoTIFF keys";
  if (!keys.valid()) {
    out.kind = Kind::not_known;
    return out;
  }
  const auto model = keys.code(kModelType);
  const auto projected = keys.code(kProjectedCrs);
  const bool lengths = model ? *model == 1 : projected || keys.code(kPlaneUnit);
  if (!lengths) {
    const bool degrees = model ? *model == 2 || *model == 3 : keys.code(kGeodeticCrs).has_value();
    out.kind = degrees ? Kind::no_plane : Kind::not_known;
    return out;
  }
  const bool mercator = projected && (*projected == 3857 || *projected == 3395);
  out.kind = mercator ? Kind::no_plane : Kind::metric;
  const bool named = projected && *projected != kUserDefined;
  out.crs = named ? fmt::format("EPSG:{}", *projected) : "GeoTIFF keys: user-defined";
  out.name = out.crs;
  if (named) out.epsg = *projected;
  if (const auto unit = keys.code(kPlaneUnit)) {
    out.plane = *unit == kUserDefined ? keys.number(kPlaneUnitSize) : metres_of_unit(*unit);
    if (out.plane && !(*out.plane > 0 && *out.plane < 1e9)) out.plane.reset();
  } else if (named && is_utm(*projected)) {
    out.plane = 1;
  }
  const auto vertical = keys.code(kVerticalCrs);
  const auto of_system = vertical ? metres_of_vertical(*vertical) : std::nullopt;
  if (const auto unit = keys.code(kVerticalUnit)) {
    out.up = metres_of_unit(*unit);
    // Of a system with a name, PROJ tells whether the two differ.
    if (!named && of_system && out.up != of_system) out.up.reset();
    out.up_unclear = !out.up;
  } else if (vertical) {
    out.up = of_system;
    out.up_unclear = !out.up;
  }
  if (vertical && *vertical != kUserDefined && named) out.crs += fmt::format("+{}", *vertical);
  return out;
}

}  // namespace geom
