#include "gml_unfollowed.h"

#include <fmt/format.h>

#include "gml_words.h"
#include "text/xml_events.h"

namespace geom::gis {
namespace {

const Words kHolders = {"exterior",        "interior",        "outerBoundaryIs", "innerBoundaryIs",
                        "baseSurface",     "baseCurve",       "patches",         "polygonPatches",
                        "trianglePatches", "geometryMembers", "surfaceMembers",  "solidMembers"};

class Links : public XmlHandler {
 public:
  explicit Links(Skipped& skipped) : skipped_(skipped) {}

  void begin(const XmlTag& tag) override {
    const bool holds = tag.name.ends_with("Member") || kHolders.contains(tag.name);
    // GDAL reads a prefix that is not declared, too.
    const bool gml =
        tag.has_unknown_prefix() || tag.space.starts_with("http://www.opengis.net/gml");
    if (!holds || !gml) return;
    const std::string_view link = tag.attribute("href");
    if (link.empty()) return;
    skipped_.add("link that is not followed in this format",
                 fmt::format("line {}: {}", tag.line, link.substr(0, 60)));
  }
  void text(std::string_view) override {}
  void end(std::size_t) override {}

 private:
  Skipped& skipped_;
};

}  // namespace

void skip_unfollowed(std::istream& in, const std::string& name, Skipped& skipped) {
  Links links(skipped);
  read_xml(in, name, links);
}

}  // namespace geom::gis
