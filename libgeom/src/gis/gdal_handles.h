#pragma once

// What GDAL gives out, given back by itself, and opened the same way everywhere (gdal_*.cpp only).

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "gdal_journal.h"
#include "gdal_library.h"
#include "geom/base/error.h"
#include "required_reference.h"

namespace geom::gis {

struct CloseDataset {
  void operator()(void* dataset) const { gdal().close(dataset); }
};
using DatasetHandle = std::unique_ptr<void, CloseDataset>;

struct DestroyReference {
  void operator()(void* reference) const { gdal().destroy_reference(reference); }
};
using ReferenceHandle = std::unique_ptr<void, DestroyReference>;

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

// For reading; null where GDAL cannot. Throws as require_no_journal.
inline DatasetHandle opened(const std::string& path, unsigned kind) {
  require_no_journal(path);
  return DatasetHandle(
      gdal().open(path.c_str(), kind | GDAL_OF_READONLY, nullptr, nullptr, nullptr));
}

// For a file that GDAL writes. Throws InputError(path, …) for a text that PROJ does not know.
inline ReferenceHandle reference_to_write(const std::string& text, const std::string& path) {
  ReferenceHandle out(gdal().new_reference(nullptr));
  if (gdal().reference_from_text(out.get(), text.c_str()) != OGRERR_NONE) {
    throw InputError(path, {.expected = "a coordinate reference system that PROJ knows",
                            .found = in_quotes(text.substr(0, 80))});
  }
  gdal().set_axis_mapping(out.get(), OAMS_TRADITIONAL_GIS_ORDER);
  return out;
}

// Its well-known text; empty for none, and for one that GDAL did not understand.
inline std::string text_of(OGRSpatialReferenceH reference) {
  char* said = nullptr;
  if (reference) gdal().reference_to_text(reference, &said);
  const BytesHandle<char> owner(said);
  return said ? said : "";
}

// What a file that GDAL reads says. Nothing for none and for a local one, whose units must be
// metres.
inline std::optional<ProjReference> reference_of(OGRSpatialReferenceH reference,
                                                 const std::string& name) {
  const std::string text = text_of(reference);
  if (text.empty()) return std::nullopt;
  ProjReference out = required_reference(text, name);
  const CoordinateReference& told = out.told();
  if (told.kind != CoordinateReference::Kind::metric || out.places()) return out;
  if (told.plane && std::abs(*told.plane - 1) < 1e-9) return std::nullopt;
  throw InputError(name, {.expected = "local coordinates in metres",
                          .found = fmt::format("units of {} m", out.unit().value_or(0)),
                          .advice = "convert them first"});
}

}  // namespace geom::gis
