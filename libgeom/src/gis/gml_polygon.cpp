#include "gml_polygon.h"

#include <fmt/format.h>

#include <algorithm>

#include "geom/base/error.h"
#include "geom/text/text_table.h"
#include "gml_words.h"

namespace geom::gis {
namespace {

const Words kStraight = {"LinearRing",        "Ring",           "LineString", "Curve",
                         "LineStringSegment", "CompositeCurve", "Point"};
const Words kSurfaceSides = {"exterior", "interior", "outerBoundaryIs", "innerBoundaryIs"};
const Words kNumbers = {"pos", "posList", "coordinates", "coord"};

}  // namespace

bool is_gml_numbers(std::string_view name) { return kNumbers.contains(name); }

std::optional<GmlNumbers> GmlPolygon::take(const XmlTag& tag, int dimension,
                                           const std::string& name) {
  if (kSurfaceSides.contains(tag.name)) rings.emplace_back();
  curved |= is_type(tag.name) && !kStraight.contains(tag.name);
  curved |= !tag.attribute("href").empty();
  if (!is_gml_numbers(tag.name)) return std::nullopt;
  if (tag.name == "coord") {
    throw InputError(name, tag.line, {.expected = "pos, posList or coordinates", .found = "coord"});
  }
  GmlNumbers form;
  form.dimension = dimension;
  form.one = tag.name == "pos";
  if (tag.name != "coordinates") return form;
  const auto mark = [&](const char* key, const char* usual) {
    const std::string_view value = tag.attribute(key);
    return std::string(value.empty() ? usual : value);
  };
  form.between_numbers = mark("cs", ",");
  form.between_points = mark("ts", " ");
  form.decimal = mark("decimal", ".")[0];
  return form;
}

void GmlPolygon::add(std::string_view text, GmlNumbers form, const std::string& name,
                     std::size_t line) {
  const auto refuse = [&](Fault fault) { throw InputError(name, line, std::move(fault)); };
  if (form.one) {
    GmlNumbers each = form;
    each.dimension = 1;
    const auto numbers = gml_numbers(text, each);
    form.dimension = numbers && numbers->size() == 2 ? 2 : 3;
  }
  const auto numbers = gml_numbers(text, form);
  if (!numbers) {
    refuse({.expected = fmt::format("numbers by {}", form.dimension),
            .found = in_quotes(std::string(trimmed(text)).substr(0, 60))});
  }
  if (rings.empty()) refuse({.expected = "points in an exterior or interior ring"});
  flat |= form.dimension == 2;
  for (std::size_t i = 0; form.dimension == 3 && i < numbers->size(); i += 3) {
    const Vec3 p((*numbers)[i], (*numbers)[i + 1], (*numbers)[i + 2]);
    if (!(p.cwiseAbs().maxCoeff() <= kLargestCoordinate)) {
      refuse({.expected = "coordinates within 1e8", .found = "a larger one"});
    }
    rings.back().push_back(p);
  }
}

std::string GmlPolygon::wrong() const {
  if (curved) return "surface with curves";
  if (flat) return "surface without heights";
  const bool empty =
      rings.empty() || std::any_of(rings.begin(), rings.end(),
                                   [](const std::vector<Vec3>& ring) { return ring.empty(); });
  return empty ? "surface without corners" : "";
}

}  // namespace geom::gis
