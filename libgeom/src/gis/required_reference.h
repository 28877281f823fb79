#pragma once

// Reference systems that files name, and the ways from them, or the refusal where PROJ knows none.

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>

#include "geom/base/error.h"
#include "geom/earth/proj_way.h"

namespace geom::gis {

// Throws InputError(name, …) for a text that PROJ does not know.
inline ProjReference required_reference(const std::string& text, const std::string& name) {
  std::optional<ProjReference> out = ProjReference::of(text);
  if (out) return std::move(*out);
  throw InputError(name, {.expected = "a coordinate reference system that PROJ knows",
                          .found = in_quotes(text.substr(0, 80))});
}

// Throws InputError(name, …) where heights count downwards.
inline void require_upward(const ProjReference& system, const std::string& name) {
  if (!system.told().depths) return;
  throw InputError(
      name, {.expected = "heights that count upwards",
             .found = fmt::format("depths, as the reference system \"{}\" says",
                                  system.told().name.substr(0, 80)),
             .advice = "turn their sign, for example with `gdal_calc.py`, and name a system of "
                       "heights"});
}

// Throws InputError(name, …) where there is no way from the system.
inline ProjWay required_way(std::optional<ProjWay> way, const ProjReference& system,
                            const std::string& name) {
  if (way) return std::move(*way);
  throw InputError(
      name,
      {.says = fmt::format("PROJ knows no way from the reference system \"{}\" to places on Earth",
                           system.told().name.substr(0, 80)),
       .advice = "say in the file which it is, for example with `ogr2ogr -a_srs EPSG:25832`, or "
                 "`gdal_translate -a_srs` for a raster"});
}

}  // namespace geom::gis
