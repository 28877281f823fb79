#include "geom/gis/read_footprints.h"

#include <fstream>
#include <iterator>

#include "city_gml.h"
#include "geom/base/error.h"
#include "geom/gis/axis_order.h"
#include "import/city_footprints.h"
#include "import/city_json.h"

namespace geom::gis {
namespace {

// Whether a file's text says so; the word may stand at its very end.
bool says(const std::string& path, std::string_view word) {
  std::ifstream file(path, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  if (file.bad()) throw InputError(path, {.says = "reading failed"});
  return text.find(word) != std::string::npos;
}

// Heights in attributes name their unit, or are metres.
Source source_of(CityModel model, bool city_json, const std::string& name,
                 const ReadOptions& options) {
  orient(model, options.axes, city_json, name);
  Source source;
  source.crs = model.crs;
  const auto unit = height_unit(source.crs, name, options);
  if (!unit) refuse_heights(name, source.crs);
  HeightOptions heights = options.height;
  heights.unit = options.height_unit.value_or(1);
  CityFootprints city = footprints_of(model, *unit, heights);
  source.footprints = std::move(city.footprints);
  source.skipped = std::move(city.skipped);
  source.counts["objects"] = city.objects;
  for (const auto& [kind, n] : city.by_kind) source.counts[kind] = n;
  for (const auto& [which, height] : city.heights) count_height(height, which, source);
  return source;
}

Source read_gml(std::istream& file, const std::string& name, const ReadOptions& options) {
  CityGml city = read_city_gml(file, name, options.height.attribute);
  if (city.placed && !city.model.crs.empty()) require_metres(city.model.crs, name);
  return source_of(std::move(city.model), false, name, options);
}

Source read_any(const std::string& format, const std::string& path, const std::string& name,
                std::istream& file, const ReadOptions& options) {
  if (format == "cityjson") return source_of(read_city_json(file, name), true, name, options);
  if (format == "citygml") return read_gml(file, name, options);
  if (format == "osm") return read_osm(path, name, options);
  if (format == "raster") return read_raster(path, name, options);
  return read_vector(path, name, options);
}

}  // namespace

std::string detect(std::string_view head, const std::string& path) {
  for (const char* end : {".pbf", ".osm", ".osm.bz2", ".osm.gz"}) {
    if (path.ends_with(end)) return "osm";
  }
  const std::size_t first = head.find_first_not_of(" \t\r\n\xef\xbb\xbf");
  const bool markup = first != std::string_view::npos && head[first] == '<';
  if (markup && says(path, "CityModel")) return "citygml";
  if (first != std::string_view::npos && head[first] == '{') {
    const bool model = says(path, "\"CityJSON\"") || says(path, "\"CityJSONFeature\"");
    return model ? "cityjson" : "vector";
  }
  return is_raster(path) ? "raster" : "vector";
}

Source read(const std::string& format, const std::string& path, const std::string& name,
            std::istream& file, const ReadOptions& options) {
  Source source = read_any(format, path, name, file, options);
  if (format != "raster") require_attribute(source, options, name);
  if (source.footprints.empty()) {
    throw InputError(
        name,
        {.expected = "at least one footprint", .found = "none", .advice = source.skipped.text()});
  }
  return source;
}

}  // namespace geom::gis
