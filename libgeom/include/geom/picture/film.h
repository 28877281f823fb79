#pragma once

// Frames of a film: the view of a vehicle's camera, a map, an overview, or these side by side.
//
// Example:
//   geom::picture::FilmOptions options{.kind = geom::picture::FilmKind::overview};
//   options.width = options.height = 320;
//   const geom::picture::Film film(map, {{geom::picture::way_line(0, "q1", path)}}, options);
//   const auto frames = film.frames({std::nullopt});
//   assert(frames.size() == 1 && frames[0].width == 320);

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geom/base/execution.h"
#include "geom/map/box_map.h"
#include "geom/picture/camera.h"
#include "geom/picture/line.h"
#include "geom/picture/look.h"
#include "geom/picture/picture.h"
#include "geom/picture/picture_scene.h"
#include "geom/picture/shade.h"
#include "geom/picture/take.h"
#include "geom/picture/view.h"
#include "geom/text/words.h"

namespace geom::picture {

enum class FilmKind { first_person, plan, overview, combined };
inline constexpr Words<FilmKind, 4> kFilmKindWords{{{FilmKind::first_person, "first-person"},
                                                    {FilmKind::plan, "plan"},
                                                    {FilmKind::overview, "overview"},
                                                    {FilmKind::combined, "combined"}}};

// Whether the frames show what a vehicle's camera sees.
constexpr bool has_eye(FilmKind kind) {
  return kind == FilmKind::first_person || kind == FilmKind::combined;
}

struct FilmOptions {
  FilmKind kind = FilmKind::first_person;
  Camera camera;
  int width = 1280;  // of a plan or an overview
  int height = 960;
  OverviewOptions overview;
  Light light;
  Wanted wanted;
};

// The vehicle of a film: where it is from `begin` to `end`, in seconds.
struct FilmedVehicle {
  double begin = 0;
  double end = 0;
  std::function<Pose(double)> pose;              // empty: there is no vehicle
  std::function<double(double)> speed;           // m/s
  std::function<double(double)> tracking_error;  // metres; empty where nobody knows it
};

// What a film shows on its map. What the vehicle calls must outlive the film.
struct FilmContent {
  std::vector<Line> lines = {};
  FilmedVehicle vehicle = {};
};

class StripChart;

class Film {
 public:
  // A film through an eye needs a vehicle (precondition).
  Film(const BoxMap& map, FilmContent content, const FilmOptions& options,
       const Execution& run = {});
  ~Film();
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;

  int width() const { return width_; }
  int height() const { return height_; }
  View view(double time) const;  // what depth and ids belong to

  // The frames at these times, in order. Nothing where no vehicle is to be shown.
  std::vector<Picture> frames(const std::vector<std::optional<double>>& times,
                              const Execution& run = {}) const;

 private:
  Picture on_map(const std::optional<double>& time) const;
  void place_map();  // from where it is taken
  // The map as it is before a vehicle is drawn on it. `flat`: lines are painted, and are no tubes.
  void take_map(const BoxMap& map, const Look& look, bool flat, const Execution& run);
  void put_beside(const Picture& eye, double time, Picture& whole) const;

  FilmOptions options_;
  FilmedVehicle vehicle_;
  std::vector<Line> lines_;
  int width_ = 0;
  int height_ = 0;
  std::unique_ptr<PictureScene> scene_;
  std::unique_ptr<Shader> shader_;
  Aabb shown_;  // on the map: all of it or, of a combined frame, what is around the lines
  View map_view_;
  Picture map_;  // with the lines, without a vehicle
  std::vector<StripChart> charts_;
};

}  // namespace geom::picture
