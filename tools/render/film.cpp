#include "film.h"

#include <algorithm>

#include "geom/map/label_colour.h"
#include "geom/map/outer_walls.h"
#include "render/drawing/map_key.h"

namespace render {
namespace {

constexpr int kSide = 480;      // width of the map in a combined frame
constexpr int kCharts = 200;    // height of the charts below
constexpr double kRoom = 0.03;  // around the map in an overview, of its longer side

geom::Aabb enu_bounds(const geom::BoxMap& map) {
  return geom::to_enu(map.spec().frame.axes, map.spec().bounds);
}

// What the lines take up, with room around, no less than a street; the whole map without lines.
geom::Aabb around_lines(const std::vector<Line>& lines, const geom::Aabb& bounds) {
  std::vector<Vec3> all;
  for (const Line& line : lines) all.insert(all.end(), line.points.begin(), line.points.end());
  const auto box = geom::bounds(all);
  if (!box) return bounds;
  const double room = std::max(20.0, 0.08 * (box->max - box->min).maxCoeff());
  geom::Aabb out{box->min.array() - room, box->max.array() + room};
  out.min.z() = bounds.min.z();
  out.max.z() = std::max(bounds.max.z(), box->max.z());
  return out;
}

// With room for the scale bar beside it.
geom::Aabb with_room(geom::Aabb bounds) {
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
std::vector<bool> unseen_from(const geom::BoxMap& map, const Vec3& eye) {
  const geom::Aabb bounds = enu_bounds(map);
  std::vector<geom::Aabb> boxes;
  for (const geom::Aabb& box : map.boxes()) {
    boxes.push_back(geom::to_enu(map.spec().frame.axes, box));
  }
  const bool room = map.spec().bounds_from != "obstacles";
  const auto sides = geom::outer_walls(boxes, bounds);
  std::vector<bool> out(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const bool cut = room && geom::hides_room(sides[i], boxes[i], eye);
    out[i] = cut || geom::is_keep_out(map.labels()[map.label()[i]]);
  }
  return out;
}

std::vector<geom::Aabb> zones_of(const geom::BoxMap& map) {
  std::vector<geom::Aabb> out;
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (!geom::is_keep_out(map.labels()[map.label()[i]])) continue;
    out.push_back(geom::to_enu(map.spec().frame.axes, map.boxes()[i]));
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

std::vector<StripChart> charts_of(const Motion& motion, int width) {
  const int half = width / 2;
  const double begin = motion.begin();
  const double end = motion.end();
  Chart speed{"speed, m/s", begin, end, [&motion](double t) { return motion.speed(t); }};
  Chart other{"height, m", begin, end, [&motion](double t) { return motion.pose(t).position.z(); }};
  if (motion.has_setpoints()) {
    other = {"tracking error, m", begin, end,
             [&motion](double t) { return motion.tracking_error(t); }};
  }
  return {StripChart(other, half, kCharts), StripChart(speed, width - half, kCharts)};
}

}  // namespace

Film::Film(const geom::BoxMap& map, std::vector<Line> lines, const Motion* motion,
           const FilmOptions& options, const geom::Execution& run)
    : options_(options), motion_(motion), lines_(std::move(lines)) {
  const geom::Aabb bounds = enu_bounds(map);
  const bool combined = options_.kind == "combined";
  const bool through_eye = options_.kind == "first-person" || combined;
  width_ = through_eye ? options_.camera.width + (combined ? kSide : 0) : options_.width;
  height_ = through_eye ? options_.camera.height + (combined ? kCharts : 0) : options_.height;
  geom::Aabb shown = bounds;
  std::vector<Tubes> tubes;
  if (options_.kind == "overview") {
    const int band = key_band(width_, height_);
    map_view_ =
        with_band(overview(with_room(bounds), width_, height_ - band, options_.overview), band);
    const double away = (0.5 * (bounds.min + bounds.max) - map_view_.eye).norm();
    tubes = tubes_of(lines_, away / map_view_.fx);
  } else if (combined) {
    shown = around_lines(lines_, bounds);
    const int band = key_band(kSide, options_.camera.height);
    map_view_ = with_band(plan_view(shown, kSide, options_.camera.height - band), band);
    charts_ = charts_of(*motion_, width_);
  } else {
    const int band = key_band(width_, height_);
    map_view_ = with_band(plan_view(bounds, width_, height_ - band), band);
  }
  if (options_.kind == "overview" || options_.kind == "plan") {
    Vec3 from = map_view_.eye;
    if (map_view_.parallel) from.z() = bounds.max.z() + 10;
    scene_ = std::make_unique<PictureScene>(map, tubes, unseen_from(map, from));
  } else {
    scene_ = std::make_unique<PictureScene>(map, tubes);
  }
  Look look = look_of(map);
  if (options_.kind != "first-person") take_map(map, look, shown, tubes.empty(), run);
  look.grid = grid_for_eye(grid_lines(bounds));
  shader_ = std::make_unique<Shader>(*scene_, look, options_.light, false);
}

void Film::take_map(const geom::BoxMap& map, Look look, const geom::Aabb& shown, bool flat,
                    const geom::Execution& run) {
  const geom::Aabb bounds = enu_bounds(map);
  const bool above = options_.kind != "overview";
  if (above) map_view_.eye.z() = bounds.max.z() + 10;
  Light light = options_.light;
  light.haze = 0;
  look.grid = grid_lines(shown);
  const Shader shader(*scene_, look, light, true);
  const Wanted wanted =
      options_.kind == "combined" ? Wanted{true, false, false, 3} : options_.wanted;
  map_ = std::move(take_pictures(*scene_, shader, std::span(&map_view_, 1), wanted, run)[0]);
  if (options_.kind != "combined") draw_zones(map_, map_view_, zones_of(map));
  if (flat) {
    draw_lines(map_, map_view_, lines_);
  } else {
    draw_faintly(map_, map_view_, lines_);
  }
  draw_ends(map_, map_view_, *scene_, lines_, std::max(1, key_scale(map_)));
  draw_map_key(map_, map_view_, {shown, look.grid, has_ways(lines_)});
}

View Film::view(double time) const {
  const bool eye = options_.kind == "first-person" || options_.kind == "combined";
  return eye ? view_from(options_.camera, motion_->pose(time)) : map_view_;
}

Picture Film::on_map(const std::optional<double>& time) const {
  Picture out = map_;
  if (motion_ && time) draw_vehicle(out, map_view_, motion_->pose(*time));
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
                                  const geom::Execution& run) const {
  std::vector<Picture> out;
  if (options_.kind == "plan" || options_.kind == "overview") {
    for (const auto& time : times) out.push_back(on_map(time));
    return out;
  }
  std::vector<View> views;
  for (const auto& time : times) views.push_back(view(time.value_or(motion_->begin())));
  out = take_pictures(*scene_, *shader_, views, options_.wanted, run);
  if (options_.kind != "combined") return out;
  for (std::size_t i = 0; i < out.size(); ++i) {
    Picture whole;
    put_beside(out[i], times[i].value_or(motion_->begin()), whole);
    whole.depth = std::move(out[i].depth);
    whole.id = std::move(out[i].id);
    out[i] = std::move(whole);
  }
  return out;
}

}  // namespace render
