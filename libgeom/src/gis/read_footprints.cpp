#include "geom/gis/read_footprints.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "base/watched_memory.h"
#include "city_gml.h"
#include "geom/base/error.h"
#include "geom/gis/axis_order.h"
#include "import/city_footprints.h"
#include "import/city_json.h"
#include "import/city_types.h"

namespace geom::gis {
namespace {

// Whether a file's text says so; the word may stand at its very end. `head`: how it begins.
bool says(std::string_view head, const std::string& path, std::string_view word) {
  if (head.find(word) != head.npos) return true;
  std::ifstream file(path, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  if (file.bad()) throw InputError(path, {.says = "reading failed"});
  return text.find(word) != std::string::npos;
}

// Heights in attributes name their unit, or are metres.
Source source_of(CityModel model, bool city_json, const std::string& name,
                 const ReadOptions& options) {
  Source source;
  source.crs = orient(model, options.axes, city_json, name);
  const auto unit = height_unit(source.crs, name, options);
  if (!unit) refuse_heights(name, *source.crs);
  HeightOptions heights = options.height;
  heights.unit = options.height_unit.value_or(1);
  require_types(types_of(model), options, name);
  LeftOutTypes left_out = leave_out(model, options.types, *unit);
  CityFootprints city = footprints_of(model, *unit, heights);
  for (Footprint& f : city.footprints) {
    const CityObject& object = model.objects.at(f.id);
    f.label = label_of(object.type, object.name, options, source);
  }
  if (options.types.empty() && !left_out.count.empty()) source.left_out_rise = left_out.rise;
  source.left_out = std::move(left_out.count);
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

// A row of the formats with their readers. What stands first wins.
struct Reader {
  const FootprintFormat* format;
  // Whether a file that begins with `head` is one.
  bool (*holds)(std::string_view head, const std::string& path);
  Source (*read)(const InputPath& file, const ReadOptions& options);
};

// The first letter behind a byte order mark and blanks.
char first_letter(std::string_view head) {
  const std::size_t first = head.find_first_not_of(" \t\r\n\xef\xbb\xbf");
  return first == head.npos ? '\0' : head[first];
}

bool is_osm(std::string_view, const std::string& path) {
  return path.ends_with(".pbf") || path.ends_with(".osm") || is_packed_osm(path);
}

bool is_city_gml(std::string_view head, const std::string& path) {
  return first_letter(head) == '<' && says(head, path, "CityModel");
}

bool is_city_json(std::string_view head, const std::string& path) {
  return first_letter(head) == '{' &&
         (says(head, path, "\"CityJSON\"") || says(head, path, "\"CityJSONFeature\""));
}

bool is_height_model(std::string_view head, const std::string& path) {
  return first_letter(head) != '{' && is_raster(path);
}

constexpr Reader kReaders[] = {
    {&kOsm, is_osm,
     [](const InputPath& in, const ReadOptions& options) {
       return read_osm(in.path, in.name, options);
     }},
    {&kCityGml, is_city_gml,
     [](const InputPath& in, const ReadOptions& options) {
       return read_gml(in.file, in.name, options);
     }},
    {&kCityJson, is_city_json,
     [](const InputPath& in, const ReadOptions& options) {
       return source_of(read_city_json(in.file, in.name), true, in.name, options);
     }},
    {&kRaster, is_height_model,
     [](const InputPath& in, const ReadOptions& options) {
       return read_raster(in.path, in.name, options);
     }},
    {&kVector, [](std::string_view, const std::string&) { return true; },
     [](const InputPath& in, const ReadOptions& options) {
       return read_vector(in.path, in.name, options);
     }},
};

const Reader& reader_of(const FootprintFormat& format) {
  return *std::find_if(std::begin(kReaders), std::end(kReaders),
                       [&](const Reader& reader) { return reader.format == &format; });
}

}  // namespace

const FootprintFormat& footprint_format_of(std::string_view head, const std::string& path) {
  const WatchedMemory memory;
  const auto holds = [&](const Reader& reader) { return reader.holds(head, path); };
  const auto* const found = std::find_if(std::begin(kReaders), std::end(kReaders), holds);
  memory.require_enough();
  return *found->format;
}

Source read(const FootprintFormat& format, const InputPath& in, const ReadOptions& options) {
  const WatchedMemory memory;
  Source source = reader_of(format).read(in, options);
  memory.require_enough();
  if (&format != &kRaster) require_attribute(source, options, in.name);
  if (source.footprints.empty()) {
    throw InputError(
        in.name,
        {.expected = "at least one footprint", .found = "none", .advice = source.skipped.text()});
  }
  return source;
}

}  // namespace geom::gis
