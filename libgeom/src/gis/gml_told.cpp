#include "gml_told.h"

#include <fmt/format.h>

#include "gml_words.h"
#include "text/xml_events.h"

namespace geom::gis {
namespace {

const Words kHolders = {"exterior",        "interior",        "outerBoundaryIs", "innerBoundaryIs",
                        "baseSurface",     "baseCurve",       "patches",         "polygonPatches",
                        "trianglePatches", "geometryMembers", "surfaceMembers",  "solidMembers"};

class Listener : public XmlHandler {
 public:
  explicit Listener(Skipped& skipped) : skipped_(skipped) {}

  void begin(const XmlTag& tag) override {
    ++depth_;
    // GDAL reads a prefix that is not declared, too.
    if (!tag.has_unknown_prefix() && !tag.space.starts_with("http://www.opengis.net/gml")) return;
    if (geometry_ == 0 && is_geometry(tag.name)) {
      geometry_ = depth_;
      ++told.geometries;
    }
    told.polygons += kPolygons.contains(tag.name);
    if (tag.name == "radius") told.radii.emplace(tag.attribute("uom"));
    take_system(tag);
    take_link(tag);
  }
  void text(std::string_view) override {}
  void end(std::size_t) override {
    if (geometry_ == depth_) geometry_ = 0;
    --depth_;
  }

  GmlTold told;

 private:
  void take_system(const XmlTag& tag) {
    const std::string_view system = tag.attribute("srsName");
    if (system.empty()) return;
    told.names_system = true;
    if (tag.name != "Envelope" && tag.name != "Box") told.systems.emplace(system);
  }

  void take_link(const XmlTag& tag) {
    if (!tag.name.ends_with("Member") && !kHolders.contains(tag.name)) return;
    const std::string_view link = tag.attribute("href");
    if (link.empty()) return;
    skipped_.add("link that is not followed in this format",
                 fmt::format("line {}: {}", tag.line, link.substr(0, 60)));
  }

  Skipped& skipped_;
  std::size_t depth_ = 0;
  std::size_t geometry_ = 0;  // the depth of the outermost one that is open; 0: none is
};

}  // namespace

GmlTold told_by_gml(std::string_view text, const std::string& name, Skipped& skipped) {
  Listener listener(skipped);
  read_xml(text, name, listener);
  return listener.told;
}

}  // namespace geom::gis
