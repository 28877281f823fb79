#include <fmt/format.h>

#include <osmium/area/assembler.hpp>
#include <osmium/area/multipolygon_manager.hpp>
#include <osmium/handler.hpp>
#include <osmium/handler/node_locations_for_ways.hpp>
#include <osmium/index/map/flex_mem.hpp>
#include <osmium/io/pbf_input.hpp>
#include <osmium/io/xml_input.hpp>
#include <osmium/visitor.hpp>

#include "footprints/source.h"
#include "geom/error.h"

namespace footprints {
namespace {

bool is_building(const osmium::TagList& tags) {
  const char* building = tags.get_value_by_key("building");
  if (building && std::string_view(building) != "no") return true;
  const char* part = tags.get_value_by_key("building:part");
  return part && std::string_view(part) != "no";
}

class AreaHandler : public osmium::handler::Handler {
 public:
  AreaHandler(const ReadOptions& options, Source& out) : options_(options), out_(out) {}

  void area(const osmium::Area& area) {
    if (!is_building(area.tags())) return;
    ++out_.counts["buildings"];
    const auto tag = [&](const char* key) -> std::string {
      const char* value = area.tags().get_value_by_key(key);
      return value ? value : "";
    };
    const geom::BuildingHeight height = counted_height(tag, options_, out_);
    for (const osmium::OuterRing& outer : area.outer_rings()) {
      geom::Footprint f;
      f.id = static_cast<std::uint64_t>(area.id());
      f.bottom = height.bottom;
      f.top = height.top;
      f.polygon.outer = points_of(outer);
      for (const osmium::InnerRing& inner : area.inner_rings(outer)) {
        f.polygon.holes.push_back(points_of(inner));
      }
      out_.footprints.push_back(std::move(f));
    }
  }

 private:
  static std::vector<geom::Vec2> points_of(const osmium::NodeRefList& ring) {
    std::vector<geom::Vec2> points;
    for (const osmium::NodeRef& node : ring) points.push_back({node.lon(), node.lat()});
    return points;
  }

  const ReadOptions& options_;
  Source& out_;
};

}  // namespace

Source read_osm(const std::string& path, const std::string& name, const ReadOptions& options) {
  using Index = osmium::index::map::FlexMem<osmium::unsigned_object_id_type, osmium::Location>;
  Source out;
  out.crs = "EPSG:4326";
  try {
    const osmium::io::File file(path);
    osmium::area::MultipolygonManager<osmium::area::Assembler> manager(
        osmium::area::Assembler::config_type{});
    osmium::relations::read_relations(file, manager);
    Index index;
    osmium::handler::NodeLocationsForWays locations(index);
    locations.ignore_errors();  // a way with a node that is not in the extract is counted below
    AreaHandler areas(options, out);
    osmium::io::Reader reader(file);
    osmium::apply(reader, locations, manager.handler([&](osmium::memory::Buffer&& buffer) {
      osmium::apply(buffer, areas);
    }));
    reader.close();
    std::size_t incomplete = 0;
    manager.for_each_incomplete_relation(
        [&](const auto& handle) { incomplete += is_building(handle->tags()); });
    if (incomplete) out.counts["multipolygons_incomplete"] = incomplete;
    const auto& stats = manager.stats();
    if (stats.invalid_locations) out.counts["areas_without_all_nodes"] = stats.invalid_locations;
    const std::size_t broken = stats.open_rings + stats.short_ways;
    if (broken) out.counts["rings_not_closed"] = broken;
  } catch (const std::system_error&) {
    throw;
  } catch (const std::exception& error) {
    throw geom::InputError(name, fmt::format("expected OpenStreetMap data: {}", error.what()));
  }
  return out;
}

}  // namespace footprints
