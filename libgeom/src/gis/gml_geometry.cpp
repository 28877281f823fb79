#include "gml_geometry.h"

#include <algorithm>
#include <cmath>

#include "geom/text/text_table.h"

namespace geom::gis {

GmlShapes::Index GmlShapes::add_shape(const std::string& id) {
  shapes_.emplace_back();
  if (!id.empty() && !by_id_.emplace(id, shapes_.size() - 1).second) twice_.insert(id);
  return shapes_.size() - 1;
}

void GmlShapes::add_polygon(Index to, CitySurface polygon) {
  shapes_[to].polygons.push_back(polygons_.size());
  polygons_.push_back(std::move(polygon));
}

void GmlShapes::add_part(Index to, Index shape) { shapes_[to].parts.push_back(shape); }

void GmlShapes::add_link(Index to, std::string id) { shapes_[to].links.push_back(std::move(id)); }

void GmlShapes::collect(Index first, std::set<Index>& seen, std::vector<Index>& polygons,
                        std::string& lost) const {
  std::vector<Index> open = {first};  // no recursion: links may lead far, or back
  while (!open.empty()) {
    const Index at = open.back();
    open.pop_back();
    if (!seen.insert(at).second) continue;
    const Shape& shape = shapes_[at];
    polygons.insert(polygons.end(), shape.polygons.begin(), shape.polygons.end());
    open.insert(open.end(), shape.parts.begin(), shape.parts.end());
    for (const std::string& link : shape.links) {
      const auto found = by_id_.find(link);
      if (found == by_id_.end() || twice_.contains(link)) {
        if (lost.empty()) lost = link;
      } else {
        open.push_back(found->second);
      }
    }
  }
}

GmlShapes::Surfaces GmlShapes::surfaces_of(Index shape,
                                           const std::optional<Eigen::Matrix4d>& place) const {
  Surfaces out;
  std::set<Index> seen;
  std::vector<Index>& polygons = out.polygons;
  collect(shape, seen, polygons, out.lost);
  std::sort(polygons.begin(), polygons.end());
  polygons.erase(std::unique(polygons.begin(), polygons.end()), polygons.end());
  for (const Index i : polygons) {
    out.surfaces.push_back(polygons_[i]);
    if (!place) continue;
    for (auto& ring : out.surfaces.back()) {
      for (Vec3& p : ring) {
        p = Vec3(place->topLeftCorner<3, 3>() * p + place->topRightCorner<3, 1>());
      }
    }
  }
  return out;
}

bool GmlShapes::Surfaces::within_reach() const {
  for (const CitySurface& surface : surfaces) {
    for (const auto& ring : surface) {
      for (const Vec3& p : ring) {
        if (!p.allFinite() || p.cwiseAbs().maxCoeff() > kLargestCoordinate) return false;
      }
    }
  }
  return true;
}

std::optional<std::vector<double>> gml_numbers(std::string_view text, const GmlNumbers& form) {
  std::vector<double> out;
  std::string word;
  bool whole = true;
  const auto take = [&] {
    if (word.empty()) return;
    const auto number = parse_number(word);
    whole &= number && std::isfinite(*number);
    out.push_back(number.value_or(0));
    word.clear();
  };
  for (const char c : text) {
    const bool between = c == ' ' || c == '\t' || c == '\n' || c == '\r' ||
                         form.between_numbers.find(c) != std::string::npos ||
                         form.between_points.find(c) != std::string::npos;
    if (between) {
      take();
    } else {
      word += c == form.decimal ? '.' : c;
    }
  }
  take();
  if (!whole || out.size() % static_cast<std::size_t>(form.dimension) != 0) return std::nullopt;
  return out;
}

}  // namespace geom::gis
