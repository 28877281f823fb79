#include "gml_drawing.h"

#include <fmt/format.h>

#include "geom/base/error.h"

namespace geom::gis {
namespace {

constexpr std::size_t kMostSurfaces = 50'000'000;

}  // namespace

void GmlDrawing::add(GmlDrawn drawn, const std::vector<std::string>& boundaries) {
  for (const std::string& id : boundaries) {
    if (!id.empty()) drawn_of_[id].push_back(drawn_.size());
  }
  drawn_.push_back(std::move(drawn));
}

void GmlDrawing::settle(CityModel& model, const std::string& source) {
  for (const GmlLink& link : links_) follow(link, model);
  for (const GmlDrawn& drawn : drawn_) place(drawn, model, source);
  model.objects = objects.settle();
}

// A link from an object to what is a part of it, or bounds it. What stands elsewhere in the file
// is built there.
void GmlDrawing::follow(const GmlLink& link, CityModel& model) {
  const auto bounding = drawn_of_.find(link.target);
  if (const auto part = objects.find(link.target)) {
    if (link.from && *link.from != *part) objects.join(*link.from, *part);
  } else if (link.from && bounding != drawn_of_.end()) {
    for (const std::size_t i : bounding->second) {
      GmlDrawn drawn = drawn_[i];
      drawn.object = *link.from;
      drawn_.push_back(std::move(drawn));
    }
  } else if (!ids_.contains(link.target) && !shapes.has(link.target)) {
    const std::string name = link.from ? objects[*link.from].name : "the model";
    model.skipped.add(
        "object that a link does not lead to",
        fmt::format("line {}: {} of {}", link.line, link.target.substr(0, 60), name.substr(0, 60)));
  }
}

void GmlDrawing::place(const GmlDrawn& drawn, CityModel& model, const std::string& source) {
  CityObject& object = objects[drawn.object];
  GmlShapes::Surfaces found = shapes.surfaces_of(drawn.shape, drawn.place);
  if (!found.lost.empty()) {
    model.skipped.add("surface that a link does not lead to",
                      fmt::format("{} of {}", found.lost.substr(0, 60), object.name.substr(0, 60)));
  }
  if (!found.within_reach()) {
    throw InputError(source, {.item = fmt::format("object \"{}\"", object.name.substr(0, 60)),
                              .expected = "coordinates within 1e8",
                              .found = "a shape that is placed beyond"});
  }
  if (!drawn.place) drop_known(drawn, found);
  taken_ += found.surfaces.size();
  if (taken_ > kMostSurfaces) {
    throw InputError(source,
                     {.expected = fmt::format("at most {} surfaces, links followed", kMostSurfaces),
                      .found = "more",
                      .advice = "cut the file"});
  }
  if (found.surfaces.empty()) return;
  CityGeometry geometry = drawn.geometry;
  geometry.surfaces = std::move(found.surfaces);
  object.geometries.push_back(std::move(geometry));
}

// A solid and the surfaces that bound an object are often the same polygons.
void GmlDrawing::drop_known(const GmlDrawn& drawn, GmlShapes::Surfaces& found) {
  auto& known = known_[{drawn.object, drawn.geometry.lod}];
  std::vector<CitySurface> fresh;
  for (std::size_t i = 0; i < found.surfaces.size(); ++i) {
    if (known.insert(found.polygons[i]).second) fresh.push_back(std::move(found.surfaces[i]));
  }
  found.surfaces = std::move(fresh);
}

}  // namespace geom::gis
