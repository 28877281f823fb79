#pragma once

// Questions to a database in its own language (gdal_*.cpp only).

#include <memory>
#include <string>

#include "gdal_handles.h"

namespace geom::gis {

// The first column of the first row; empty where there is no row, or where the database does not
// understand the question.
inline std::string first_text_of(const DatasetHandle& dataset, const std::string& sql) {
  const auto release = [&](void* result) { gdal().release_result(dataset.get(), result); };
  const std::unique_ptr<void, decltype(release)> result(
      gdal().execute_sql(dataset.get(), sql.c_str(), nullptr, nullptr), release);
  if (!result) return "";
  const FeatureHandle row{gdal().next_feature(result.get())};
  return row && gdal().field_count(row.get()) > 0 ? gdal().text(row.get(), 0) : "";
}

}  // namespace geom::gis
