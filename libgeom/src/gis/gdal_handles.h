#pragma once

// GDAL's datasets and reference systems that are given back by themselves.

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

// With x east and y north, or longitude before latitude. Throws InputError(name, …) for a text that
// PROJ does not know.
inline ReferenceHandle reference_named(const std::string& text, const std::string& name) {
  ReferenceHandle out(gdal().new_reference(nullptr));
  if (gdal().reference_from_text(out.get(), text.c_str()) != OGRERR_NONE) {
    throw InputError(name, {.expected = "a coordinate reference system that PROJ knows",
                            .found = in_quotes(text)});
  }
  gdal().set_axis_mapping(out.get(), OAMS_TRADITIONAL_GIS_ORDER);
  return out;
}

}  // namespace geom::gis
