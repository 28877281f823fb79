#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <new>
#include <osmium/area/assembler.hpp>
#include <osmium/area/multipolygon_manager.hpp>
#include <osmium/area/problem_reporter.hpp>
#include <osmium/handler.hpp>
#include <osmium/handler/check_order.hpp>
#include <osmium/handler/node_locations_for_ways.hpp>
#include <osmium/index/map/flex_mem.hpp>
#include <osmium/io/bzip2_compression.hpp>
#include <osmium/io/gzip_compression.hpp>
#include <osmium/io/pbf_input.hpp>
#include <osmium/io/xml_input.hpp>
#include <osmium/object_pointer_collection.hpp>
#include <osmium/osm/object_comparisons.hpp>
#include <osmium/visitor.hpp>
#include <set>

#include "geom/base/error.h"
#include "geom/gis/footprint_source.h"
#include "osm_obstacle.h"
#include "required_reference.h"
#include "xml_heads.h"

namespace geom::gis {
namespace {

OsmTags tags_of(const osmium::OSMObject& object) {
  OsmTags tags;
  for (const osmium::Tag& tag : object.tags()) tags.add(tag.key(), tag.value());
  return tags;
}

// Whether a relation is assembled to areas.
bool is_area(const OsmTags& tags) {
  return tags.has("type", "multipolygon") || tags.has("type", "boundary");
}

using Index = osmium::index::map::FlexMem<osmium::unsigned_object_id_type, osmium::Location>;
using Locations = osmium::handler::NodeLocationsForWays<Index, Index>;

Vec2 point_of(const osmium::Location& at) { return {at.lon(), at.lat()}; }

// Relations of which a ring within another is said to be an outline ("outer"): osmium goes by the
// places of rings alone, and makes a hole of it.
class OutlinesWithin : public osmium::area::ProblemReporter {
 public:
  bool contains(osmium::object_id_type relation) const { return relations_.contains(relation); }

  void report_role_should_be_inner(osmium::object_id_type, osmium::Location,
                                   osmium::Location) override {
    relations_.insert(m_object_id);
  }

 private:
  std::set<osmium::object_id_type> relations_;
};

// Edges of ways that stand in a multipolygon of a building without a role: nobody says that they go
// around a hole.
class EdgesWithoutRole : public osmium::handler::Handler {
 public:
  // Where each relation comes before the ways; a manager for osmium::relations::read_relations().
  void relation(const osmium::Relation& relation) {
    const OsmTags tags = tags_of(relation);
    if (!is_area(tags) || !is_built(tags)) return;
    for (const osmium::RelationMember& member : relation.members()) {
      const bool way = member.type() == osmium::item_type::way;
      if (way && *member.role() == '\0') relations_of_[member.ref()].push_back(relation.id());
    }
  }
  void prepare_for_lookup() {}

  // Once it has the locations of its nodes.
  void way(const osmium::Way& way) {
    const auto at = relations_of_.find(way.id());
    if (at == relations_of_.end()) return;
    for (const osmium::object_id_type relation : at->second) {
      for_each_edge(way.nodes(), [&](const Edge& edge) { edges_[relation].insert(edge); });
    }
  }

  bool touch(osmium::object_id_type relation, const osmium::NodeRefList& ring) const {
    const auto at = edges_.find(relation);
    bool out = false;
    if (at != edges_.end()) {
      for_each_edge(ring, [&](const Edge& edge) { out |= at->second.contains(edge); });
    }
    return out;
  }

 private:
  using Edge = std::pair<osmium::Location, osmium::Location>;

  template <class F>
  static void for_each_edge(const osmium::NodeRefList& nodes, const F& f) {
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      f(std::minmax<osmium::Location>({nodes[i - 1].location(), nodes[i].location()}));
    }
  }

  std::map<osmium::object_id_type, std::vector<osmium::object_id_type>> relations_of_;
  std::map<osmium::object_id_type, std::set<Edge>> edges_;
};

// Ways as they are, so that one that crosses itself is there too; relations as osmium assembles
// them, and what it cannot assemble by number.
class BuildingHandler : public osmium::handler::Handler {
 public:
  BuildingHandler(const ReadOptions& options, const OutlinesWithin& outlines_within,
                  const EdgesWithoutRole& edges_without_role, Source& out)
      : options_(options),
        outlines_within_(outlines_within),
        edges_without_role_(edges_without_role),
        out_(out) {}

  void node(const osmium::Node& node) {
    if (node.tags().empty()) return;
    const OsmTags tags = tags_of(node);
    const bool entrance = tags.text("building") == "entrance";
    if (is_built(tags) && !entrance && !is_chosen(tags)) return;
    if ((is_built(tags) && !entrance) || is_high_line(tags)) {
      skip("building or mast that is a point", fmt::format("node {}", node.id()), is_built(tags));
    } else {
      skip_other(tags, "node", node.id());
    }
  }

  void way(const osmium::Way& way) {
    if (way.tags().empty()) return;
    const std::string which = fmt::format("way {}", way.id());
    const OsmTags tags = tags_of(way);
    if (!is_built(tags)) {
      if (is_high_line(tags)) {
        skip("line in the air", which, false);
      } else {
        skip_other(tags, "way", way.id());
      }
      return;
    }
    if (!is_chosen(tags)) return;
    Footprint f;
    for (const osmium::NodeRef& node : way.nodes()) {
      if (node.location().valid()) f.polygon.outer.push_back(point_of(node.location()));
    }
    if (f.polygon.outer.size() < way.nodes().size() || way.nodes().empty()) {
      ++out_.counts["ways_without_all_nodes"];
      out_.skipped.add("part of an outline whose nodes are not in the file", which);
    }
    if (f.polygon.outer.empty()) return;
    if (!way.is_closed()) {
      ++out_.counts["ways_not_closed"];
      out_.skipped.add("outline that is not closed", which);
    }
    add(way, osmium::item_type::way, std::move(f));
  }

  void relation(const osmium::Relation& relation) {
    const OsmTags tags = tags_of(relation);
    if (!is_built(tags)) {
      skip_other(tags, "relation", relation.id());
    } else if (!is_chosen(tags)) {
      assembled_.insert(relation.id());  // done with
    } else if (!is_area(tags)) {
      out_.skipped.add("building that is a relation without an area",
                       fmt::format("relation {}", relation.id()));
    }
  }

  void area(const osmium::Area& area) {
    if (area.from_way() || !is_built(tags_of(area)) || !is_named(tags_of(area))) return;
    std::vector<Footprint> parts;
    bool filled = false;
    for (const osmium::OuterRing& outer : area.outer_rings()) {
      Footprint& f = parts.emplace_back();
      f.polygon.outer = points_of(outer);
      for (const osmium::InnerRing& inner : area.inner_rings(outer)) {
        if (is_hole(area, inner)) {
          f.polygon.holes.push_back(points_of(inner));
        } else {
          filled = true;
        }
      }
    }
    if (parts.empty()) return;
    if (filled) ++out_.counts["multipolygons_without_their_holes"];
    assembled_.insert(area.orig_id());
    const BuildingHeight height = count(area);
    for (Footprint& f : parts) push(area, area.id(), height, std::move(f));
  }

  void add(const osmium::OSMObject& object, osmium::item_type type, Footprint f) {
    push(object, osmium::object_id_to_area_id(object.id(), type), count(object), std::move(f));
  }

  bool is_assembled(osmium::object_id_type relation) const { return assembled_.contains(relation); }

  // How many objects of each type there are, built or not.
  const std::map<std::string, std::size_t>& types() const { return types_; }

 private:
  bool is_named(const OsmTags& tags) const {
    const std::vector<std::string>& types = options_.types;
    return types.empty() ||
           std::find(types.begin(), types.end(), type_of_built(tags)) != types.end();
  }

  // Whether the roles say so: osmium goes by the places of rings alone.
  bool is_hole(const osmium::Area& area, const osmium::InnerRing& ring) const {
    return !outlines_within_.contains(area.orig_id()) &&
           !edges_without_role_.touch(area.orig_id(), ring);
  }

  // Whether it is to be built, by its type; counts what is not. Asked once of each object.
  bool is_chosen(const OsmTags& tags) {
    const std::string type = type_of_built(tags);
    ++types_[type];
    if (is_named(tags)) return true;
    ++out_.left_out[type];
    return false;
  }

  // What cannot be built. Where types are named, all of other types is left out.
  void skip(const std::string& kind, const std::string& which, bool of_type) {
    if (options_.types.empty() || of_type) {
      out_.skipped.add(kind, which);
    } else {
      ++out_.left_out[kind];
    }
  }

  void skip_other(const OsmTags& tags, const char* type, osmium::object_id_type id) {
    const auto kind = other_obstacle(tags);
    if (kind) skip(*kind, fmt::format("{} {}", type, id), false);
  }

  BuildingHeight count(const osmium::OSMObject& object) {
    ++out_.counts["buildings"];
    const OsmTags tags = tags_of(object);
    const auto tag = [&](const char* key) -> std::string { return tags.text(key); };
    const BuildingHeight height = building_height(tag, options_.height);
    count_height(height, name_of(object), out_);
    if (height.from == HeightFrom::nothing) {
      for (const osmium::Tag& t : object.tags()) note_attribute(t.key(), t.value(), out_);
    }
    return height;
  }

  // "way 123", as in the file.
  static std::string name_of(const osmium::OSMObject& object) {
    const char* what = object.type() == osmium::item_type::way ? "way" : "relation";
    const auto id = object.type() == osmium::item_type::area
                        ? static_cast<const osmium::Area&>(object).orig_id()
                        : object.id();
    return fmt::format("{} {}", what, id);
  }

  void push(const osmium::OSMObject& object, osmium::object_id_type id,
            const BuildingHeight& height, Footprint f) {
    f.id = static_cast<std::uint64_t>(id);
    f.label = label_of(type_of_built(tags_of(object)), name_of(object), options_, out_);
    f.bottom = height.bottom;
    f.top = height.top;
    out_.footprints.push_back(std::move(f));
  }

  static std::vector<Vec2> points_of(const osmium::NodeRefList& ring) {
    std::vector<Vec2> points;
    for (const osmium::NodeRef& node : ring) points.push_back(point_of(node.location()));
    return points;
  }

  const ReadOptions& options_;
  const OutlinesWithin& outlines_within_;
  const EdgesWithoutRole& edges_without_role_;
  Source& out_;
  std::set<osmium::object_id_type> assembled_;
  std::map<std::string, std::size_t> types_;
};

// The convex hull, by Andrew's monotone chain; exact, as locations are whole numbers.
std::vector<Vec2> hull_of(std::vector<osmium::Location> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const auto turns_left = [](const auto& a, const auto& b, const auto& c) {
    const auto d = [](std::int64_t to, std::int64_t from) {
      return static_cast<long double>(to - from);
    };
    // Differences stay below 2^32, so 64 bits of mantissa hold the products.
    return d(b.x(), a.x()) * d(c.y(), a.y()) > d(b.y(), a.y()) * d(c.x(), a.x());
  };
  std::vector<osmium::Location> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t first = hull.size();
    for (const osmium::Location& p : points) {
      while (hull.size() >= first + 2 && !turns_left(hull[hull.size() - 2], hull.back(), p)) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    if (points.size() > 1) hull.pop_back();  // where the other side begins
    std::reverse(points.begin(), points.end());
  }
  std::vector<Vec2> out;
  for (const osmium::Location& p : hull) out.push_back(point_of(p));
  return out;
}

// Relations that could not be assembled, each by the convex hull of what is there of its ways.
class HullHandler : public osmium::handler::Handler {
 public:
  explicit HullHandler(std::set<osmium::object_id_type> wanted) : wanted_(std::move(wanted)) {}

  void way(const osmium::Way& way) {
    const auto at = relations_of_.find(way.id());
    if (at == relations_of_.end()) return;
    for (const osmium::object_id_type relation : at->second) {
      for (const osmium::NodeRef& node : way.nodes()) {
        if (node.location().valid()) {
          points_[relation].push_back(node.location());
        } else {
          torn_.insert(relation);
        }
      }
    }
    relations_of_.erase(at);
  }

  // Once all ways have passed: whether a way of the relation, or a node of one, was not among them.
  bool is_torn(osmium::object_id_type relation) const {
    return torn_.contains(relation) ||
           std::any_of(relations_of_.begin(), relations_of_.end(), [&](const auto& missing) {
             return std::find(missing.second.begin(), missing.second.end(), relation) !=
                    missing.second.end();
           });
  }

  void remember_members(const osmium::Relation& relation) {
    if (!wanted_.contains(relation.id())) return;
    for (const osmium::RelationMember& member : relation.members()) {
      if (member.type() == osmium::item_type::way) {
        relations_of_[member.ref()].push_back(relation.id());
      }
    }
  }

  std::vector<osmium::Location> points(osmium::object_id_type relation) {
    return points_[relation];
  }

 private:
  std::set<osmium::object_id_type> wanted_;
  std::set<osmium::object_id_type> torn_;
  std::map<osmium::object_id_type, std::vector<osmium::object_id_type>> relations_of_;
  std::map<osmium::object_id_type, std::vector<osmium::Location>> points_;
};

template <class F>
void for_each(const osmium::io::File& file, osmium::osm_entity_bits::type kind, const F& f) {
  osmium::io::Reader reader(file, kind);
  while (osmium::memory::Buffer buffer = reader.read()) {
    for (auto& object : buffer.select<osmium::OSMObject>()) f(object);
  }
  reader.close();
}

bool is_building_relation(const osmium::OSMObject& object) {
  const OsmTags tags = tags_of(object);
  return is_area(tags) && is_built(tags);
}

void add_hulls(const osmium::io::File& file, Locations& locations, BuildingHandler& buildings,
               Source& out) {
  namespace bits = osmium::osm_entity_bits;
  std::set<osmium::object_id_type> wanted;
  for_each(file, bits::relation, [&](const osmium::OSMObject& object) {
    if (is_building_relation(object) && !buildings.is_assembled(object.id())) {
      wanted.insert(object.id());
    }
  });
  if (wanted.empty()) return;
  HullHandler hulls(wanted);
  for_each(file, bits::relation, [&](const osmium::OSMObject& object) {
    hulls.remember_members(static_cast<const osmium::Relation&>(object));
  });
  for_each(file, bits::way, [&](osmium::OSMObject& object) {
    auto& way = static_cast<osmium::Way&>(object);
    locations.way(way);
    hulls.way(way);
  });
  for_each(file, bits::relation, [&](const osmium::OSMObject& object) {
    if (!wanted.contains(object.id())) return;
    Footprint f;
    f.polygon.outer = hull_of(hulls.points(object.id()));
    ++out.counts[f.polygon.outer.empty() ? "multipolygons_without_ways"
                                         : "multipolygons_by_their_hull"];
    if (f.polygon.outer.empty() || hulls.is_torn(object.id())) {
      out.skipped.add("part of a multipolygon whose ways are not in the file",
                      fmt::format("relation {}", object.id()));
    }
    if (!f.polygon.outer.empty()) {
      buildings.add(object, osmium::item_type::relation, std::move(f));
    }
  });
}

// Every object of the file to each of the handlers, in the order of the file.
struct InOrder {
  const osmium::io::File& file;

  template <class... Handlers>
  void operator()(Handlers&&... handlers) const {
    osmium::io::Reader reader(file);
    osmium::apply(reader, std::forward<Handlers>(handlers)...);
    reader.close();
  }
};

// The same, nodes before ways before relations and each by their numbers, as editors do not write
// them: all of the file in memory.
struct Sorted {
  const osmium::io::File& file;

  template <class... Handlers>
  void operator()(Handlers&&... handlers) const {
    osmium::memory::Buffer buffer = osmium::io::read_file(file);
    osmium::ObjectPointerCollection objects;
    osmium::apply(buffer, objects);
    objects.sort(osmium::object_order_type_id_version{});
    osmium::apply(objects.begin(), objects.end(), std::forward<Handlers>(handlers)...);
  }
};

template <class Each>
Source read_buildings(const osmium::io::File& file, const std::string& name,
                      const ReadOptions& options, const Each& each) {
  Source out;
  out.crs = required_reference("EPSG:4326", name);
  OutlinesWithin outlines_within;
  osmium::area::Assembler::config_type config;
  config.problem_reporter = &outlines_within;
  config.check_roles = true;
  osmium::area::MultipolygonManager<osmium::area::Assembler> manager(config);
  EdgesWithoutRole edges_without_role;
  osmium::relations::read_relations(file, manager, edges_without_role);
  Index index;
  Index index_of_new;  // nodes that an editor has made and no server numbered: negative ids
  Locations locations(index, index_of_new);
  locations.ignore_errors();  // a node that is not in the extract: skipped with its way
  BuildingHandler buildings(options, outlines_within, edges_without_role, out);
  each(locations, edges_without_role, buildings,
       manager.handler([&](osmium::memory::Buffer&& buffer) { osmium::apply(buffer, buildings); }));
  add_hulls(file, locations, buildings, out);
  require_types(buildings.types(), options, name);
  return out;
}

}  // namespace

Source read_osm(const std::string& path, const std::string& name, const ReadOptions& options) {
  try {
    require_plain_osm(path, name);
    const osmium::io::File file(path);
    try {
      return read_buildings(file, name, options, InOrder{file});
    } catch (const osmium::out_of_order_error&) {
      return read_buildings(file, name, options, Sorted{file});
    }
  } catch (const InputError&) {
    throw;
  } catch (const std::system_error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError(
        name,
        {.expected = "whole OpenStreetMap data, each object once",
         .found = fmt::format(
             "other data (libosmium: {}); `osmium sort` and `osmium check-refs` may tell more",
             error.what())});
  }
}

}  // namespace geom::gis
