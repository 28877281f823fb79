#include "geom/picture/film.h"

#include <algorithm>

#include "drawn.h"
#include "geom/map/label_colour.h"
#include "geom/map/outer_walls.h"
#include "map_key.h"
#include "strip_chart.h"

namespace geom::picture {
namespace {

constexpr int kSide = 480;      // width of the map in a combined frame
constexpr int kCharts = 200;    // height of the charts below
constexpr double kRoom = 0.03;  // around the map in an overview, of its longer side

Aabb enu_bounds(const BoxMap& map) { return to_enu(map.spec().frame.axes, map.spec().bounds); }

// What the lines take up, with room around, no less than a street; the whole map without lines.
Aabb around_lines(const std::vector<Line>& lines, const Aabb& bounds) {
  std::vector<Vec3> all;
  for (const Line& line : lines) all.insert(all.end(), line.points.begin(), line.points.end());
  const auto box = geom::bounds(all);
  if (!box) return bounds;
  const double room = std::max(20.0, 0.08 * (box->max - box->min).maxCoeff());
  Aabb out{box->min.array() - room, box->max.array() + room};
  out.min.z() = bounds.min.z();
  out.max.z() = std::max(bounds.max.z(), box->max.z());
  return out;
}

// With room for the scale bar beside it.
Aabb with_room(Aabb bounds) {
  const double room = kRoom * (bounds.max - bounds.min).head<2>().maxCoeff();
  bounds.min.head<2>().array() -= room;
  bounds.max.head<2>().array() += room;
  return bounds;
}

// What the eye of a vehicle sees moves by: never wider than streets are.
GridLines grid_for_eye(const GridLines& grid) {
  return {std::min(grid.cell, 100.0), std::min(grid.fine, 10.0)};
}

// What a map from outside leaves out: keep-out volumes, whose edges are drawn instead, and walls
// and ceilings of a room that stand between it and the eye.
std::vector<bool> unseen_from(const BoxMap& map, const Vec3& eye) {
  const Aabb bounds = enu_bounds(map);
  std::vector<Aabb> boxes;
  for (const Aabb& box : map.boxes()) {
    boxes.push_back(to_enu(map.spec().frame.axes, box));
  }
  const bool room = map.spec().bounds_from != "obstacles";
  const auto sides = outer_walls(boxes, bounds);
  std::vector<bool> out(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const bool cut = room && hides_room(sides[i], boxes[i], eye);
    out[i] = cut || is_keep_out(map.labels()[map.label()[i]]);
  }
  return out;
}

std::vector<Aabb> zones_of(const BoxMap& map) {
  std::vector<Aabb> out;
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (!is_keep_out(map.labels()[map.label()[i]])) continue;
    out.push_back(to_enu(map.spec().frame.axes, map.boxes()[i]));
  }
  return out;
}

// Above the band of the key (map_key.h): the rows below the map show the ground around it.
View with_band(View view, int band) {
  view.height += band;
  return view;
}

bool has_ways(const std::vector<Line>& lines) {
  return std::any_of(lines.begin(), lines.end(), [](const Line& line) { return line.way; });
}

std::vector<StripChart> charts_of(const FilmedVehicle& vehicle, int width) {
  const int half = width / 2;
  Chart speed{"speed, m/s", vehicle.begin, vehicle.end, vehicle.speed};
  Chart other{"height, m", vehicle.begin, vehicle.end,
              [pose = vehicle.pose](double t) { return pose(t).position.z(); }};
  if (vehicle.tracking_error) {
    other = {"tracking error, m", vehicle.begin, vehicle.end, vehicle.tracking_error};
  }
  return {StripChart(other, half, kCharts), StripChart(speed, width - half, kCharts)};
}

}  // namespace

Film::Film(const BoxMap& map, FilmContent content, const FilmOptions& options, const Execution& run)
    : options_(options), vehicle_(std::move(content.vehicle)), lines_(std::move(content.lines)) {
  const Aabb bounds = enu_bounds(map);
  const bool combined = options_.kind == FilmKind::combined;
  const bool eye = has_eye(options_.kind);
  width_ = eye ? options_.camera.width + (combined ? kSide : 0) : options_.width;
  height_ = eye ? options_.camera.height + (combined ? kCharts : 0) : options_.height;
  shown_ = combined ? around_lines(lines_, bounds) : bounds;
  place_map();
  if (combined) charts_ = charts_of(vehicle_, width_);
  std::vector<Tubes> tubes;
  if (options_.kind == FilmKind::overview) {
    const double away = (0.5 * (bounds.min + bounds.max) - map_view_.eye).norm();
    tubes = tubes_of(lines_, away / map_view_.fx);
  }
  if (eye) {
    scene_ = std::make_unique<PictureScene>(map, tubes);
  } else {
    Vec3 from = map_view_.eye;
    if (map_view_.parallel) from.z() = bounds.max.z() + 10;
    scene_ = std::make_unique<PictureScene>(map, tubes, unseen_from(map, from));
  }
  Look look = look_of(map);
  look.grid = grid_lines(shown_);
  if (options_.kind != FilmKind::first_person) take_map(map, look, tubes.empty(), run);
  look.grid = grid_for_eye(grid_lines(bounds));
  shader_ = std::make_unique<Shader>(*scene_, look, options_.light, false);
}

Film::~Film() = default;

void Film::place_map() {
  const bool combined = options_.kind == FilmKind::combined;
  const int width = combined ? kSide : width_;
  const int height = combined ? options_.camera.height : height_;
  const int band = key_band(width, height);
  const View view = options_.kind == FilmKind::overview
                        ? overview(with_room(shown_), width, height - band, options_.overview)
                        : plan_view(shown_, width, height - band);
  map_view_ = with_band(view, band);
}

void Film::take_map(const BoxMap& map, const Look& look, bool flat, const Execution& run) {
  const Aabb bounds = enu_bounds(map);
  const bool above = options_.kind != FilmKind::overview;
  if (above) map_view_.eye.z() = bounds.max.z() + 10;
  Light light = options_.light;
  light.haze = 0;
  const Shader shader(*scene_, look, light, true);
  const Wanted wanted =
      options_.kind == FilmKind::combined ? Wanted{true, false, false, 3} : options_.wanted;
  map_ = std::move(take_pictures(*scene_, shader, std::span(&map_view_, 1), wanted, run)[0]);
  if (options_.kind != FilmKind::combined) draw_zones(map_, map_view_, zones_of(map));
  if (flat) {
    draw_lines(map_, map_view_, lines_);
  } else {
    draw_faintly(map_, map_view_, lines_);
  }
  draw_ends(map_, map_view_, *scene_, lines_);
  draw_map_key(map_, map_view_, {shown_, look.grid, has_ways(lines_)});
}

View Film::view(double time) const {
  return has_eye(options_.kind) ? view_from(options_.camera, vehicle_.pose(time)) : map_view_;
}

Picture Film::on_map(const std::optional<double>& time) const {
  Picture out = map_;
  if (vehicle_.pose && time) draw_vehicle(out, map_view_, vehicle_.pose(*time));
  return out;
}

void Film::put_beside(const Picture& eye, double time, Picture& whole) const {
  whole.width = width_;
  whole.height = height_;
  fill(whole, {255, 255, 255});
  put(eye, 0, 0, whole);
  put(on_map(time), eye.width, 0, whole);
  int x = 0;
  for (const StripChart& chart : charts_) {
    const Picture part = chart.at(time);
    put(part, x, eye.height, whole);
    x += part.width;
  }
}

std::vector<Picture> Film::frames(const std::vector<std::optional<double>>& times,
                                  const Execution& run) const {
  std::vector<Picture> out;
  if (!has_eye(options_.kind)) {
    for (const auto& time : times) out.push_back(on_map(time));
    return out;
  }
  std::vector<View> views;
  for (const auto& time : times) views.push_back(view(time.value_or(vehicle_.begin)));
  out = take_pictures(*scene_, *shader_, views, options_.wanted, run);
  if (options_.kind != FilmKind::combined) return out;
  for (std::size_t i = 0; i < out.size(); ++i) {
    Picture whole;
    put_beside(out[i], times[i].value_or(vehicle_.begin), whole);
    whole.depth = std::move(out[i].depth);
    whole.id = std::move(out[i].id);
    out[i] = std::move(whole);
  }
  return out;
}

}  // namespace geom::picture
