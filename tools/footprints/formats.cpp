#include "formats.h"

#include "cli/file/files.h"
#include "geom/base/error.h"
#include "geom/import/city_json.h"

namespace footprints {
namespace {

// Whether a file's text says so; the word may stand at its very end.
bool says(const std::string& path, std::string_view word) {
  cli::InputFile file(path);
  return file.read_all().find(word) != std::string::npos;
}

Source read_city_json(std::istream& in, const std::string& name, const ReadOptions& options) {
  geom::CityJson city = geom::read_city_json(in, name);
  Source source;
  source.footprints = std::move(city.footprints);
  source.crs = city.crs;
  source.counts["objects"] = city.objects;
  source.skipped = std::move(city.skipped);
  const auto unit = height_unit(source.crs, name, options);
  if (!unit) refuse_heights(name, source.crs);
  for (geom::Footprint& f : source.footprints) {
    f.bottom *= *unit;
    f.top *= *unit;
  }
  return source;
}

Source read_any(const std::string& format, const std::string& path, const std::string& name,
                std::istream& file, const ReadOptions& options) {
  if (format == "cityjson") return read_city_json(file, name, options);
  if (format == "osm") return read_osm(path, name, options);
  if (format == "raster") return read_raster(path, name, options);
  return read_vector(path, name, options);
}

}  // namespace

std::string detect(std::string_view head, const std::string& path) {
  for (const char* end : {".pbf", ".osm", ".osm.bz2", ".osm.gz"}) {
    if (path.ends_with(end)) return "osm";
  }
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && head[first] == '{') {
    return says(path, "\"CityJSON\"") ? "cityjson" : "vector";
  }
  return is_raster(path) ? "raster" : "vector";
}

Source read(const std::string& format, const std::string& path, const std::string& name,
            std::istream& file, const ReadOptions& options) {
  Source source = read_any(format, path, name, file, options);
  if (source.footprints.empty()) {
    const std::string skipped = source.skipped.text();
    throw geom::InputError(name, "expected at least one footprint, found none" +
                                     (skipped.empty() ? "" : ": " + skipped));
  }
  return source;
}

}  // namespace footprints
