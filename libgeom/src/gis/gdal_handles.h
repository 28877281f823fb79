#pragma once

// What GDAL gives out, given back by itself, and opened the same way everywhere (gdal_*.cpp only).

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <string>

#include "gdal_library.h"
#include "geom/base/error.h"

namespace geom::gis {

struct CloseDataset {
  void operator()(void* dataset) const { gdal().close(dataset); }
};
using DatasetHandle = std::unique_ptr<void, CloseDataset>;

struct DestroyReference {
  void operator()(void* reference) const { gdal().destroy_reference(reference); }
};
using ReferenceHandle = std::unique_ptr<void, DestroyReference>;

// GDAL keeps a conversion that is given back, and gives it to the next caller. PROJ would search
// for it again, which takes 10 ms.
struct DestroyConversion {
  void operator()(void* conversion) const { gdal().destroy_transformation(conversion); }
};
using ConversionHandle = std::unique_ptr<void, DestroyConversion>;

struct DestroyConversionOptions {
  void operator()(OGRCoordinateTransformationOptions* options) const {
    gdal().destroy_conversion_options(options);
  }
};

struct DestroyFeature {
  void operator()(void* feature) const { gdal().destroy_feature(feature); }
};
using FeatureHandle = std::unique_ptr<void, DestroyFeature>;

struct DestroyGeometry {
  void operator()(void* geometry) const { gdal().destroy_geometry(geometry); }
};
using GeometryHandle = std::unique_ptr<void, DestroyGeometry>;

struct CloseFile {
  void operator()(VSILFILE* file) const { gdal().close_file(file); }
};
using FileHandle = std::unique_ptr<VSILFILE, CloseFile>;

struct DestroyList {
  void operator()(char** list) const { gdal().destroy_list(list); }
};
using ListHandle = std::unique_ptr<char*, DestroyList>;  // of texts, up to a null pointer

struct FreeBytes {
  void operator()(void* bytes) const { gdal().free(bytes); }
};
template <class Byte>
using BytesHandle = std::unique_ptr<Byte, FreeBytes>;

// For reading; null where GDAL cannot.
inline DatasetHandle opened(const std::string& path, unsigned kind) {
  return DatasetHandle(
      gdal().open(path.c_str(), kind | GDAL_OF_READONLY, nullptr, nullptr, nullptr));
}

// With x east and y north, or longitude before latitude. Throws InputError(name, …) for a text that
// PROJ does not know.
inline ReferenceHandle reference_named(const std::string& text, const std::string& name) {
  ReferenceHandle out(gdal().new_reference(nullptr));
  if (gdal().reference_from_text(out.get(), text.c_str()) != OGRERR_NONE) {
    throw InputError(name, {.expected = "a coordinate reference system that PROJ knows",
                            .found = in_quotes(text.substr(0, 80))});
  }
  gdal().set_axis_mapping(out.get(), OAMS_TRADITIONAL_GIS_ORDER);
  return out;
}

// Throws InputError(name, …) where a system has a vertical part that counts downwards.
inline void require_upward(const ReferenceHandle& system, const std::string& name) {
  OGRAxisOrientation direction = OAO_Other;
  gdal().axis_of(system.get(), "VERT_CS", 0, &direction);
  if (direction != OAO_Down) return;
  const char* const said = gdal().reference_name(system.get());
  throw InputError(
      name, {.expected = "heights that count upwards",
             .found = fmt::format("depths, as the reference system \"{}\" says",
                                  std::string(said ? said : "").substr(0, 80)),
             .advice = "turn their sign, for example with `gdal_calc.py`, and name a system of "
                       "heights"});
}

// Null where PROJ knows none. Never one that takes two datums for one.
inline ConversionHandle conversion(const ReferenceHandle& from, const ReferenceHandle& to) {
  const std::unique_ptr<OGRCoordinateTransformationOptions, DestroyConversionOptions> options(
      gdal().new_conversion_options());
  gdal().allow_ballpark(options.get(), FALSE);
  return ConversionHandle(gdal().new_transformation(from.get(), to.get(), options.get()));
}

// The refusal where conversion() between this system and places on Earth is null.
[[noreturn]] inline void refuse_conversion(const ReferenceHandle& system, const std::string& name) {
  const char* const said = gdal().reference_name(system.get());
  throw InputError(
      name,
      {.says = fmt::format("PROJ knows no way from the reference system \"{}\" to places on Earth",
                           std::string(said ? said : "").substr(0, 80)),
       .advice = "say in the file which it is, for example with `ogr2ogr -a_srs EPSG:25832`, or "
                 "`gdal_translate -a_srs` for a raster"});
}

// Empty for none and for a local one, whose units must be metres.
inline std::string text_of(OGRSpatialReferenceH reference, const std::string& name) {
  if (!reference) return "";
  if (gdal().is_local(reference)) {
    const double unit = gdal().linear_unit(reference, nullptr);
    if (std::abs(unit - 1) > 1e-9) {
      throw InputError(name, {.expected = "local coordinates in metres",
                              .found = fmt::format("units of {} m", unit),
                              .advice = "convert them first"});
    }
    return "";
  }
  char* text = nullptr;
  gdal().reference_to_text(reference, &text);
  const BytesHandle<char> owner(text);
  return text ? text : "";
}

}  // namespace geom::gis
