#pragma once

// What each frame shows: the camera's view, a map, an overview, or all that matters side by side.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/drawing/drawn.h"
#include "render/drawing/strip_chart.h"
#include "render/picture_names.h"

namespace render {

struct FilmOptions {
  std::string kind = "first-person";  // or "plan", "overview", "combined"
  Camera camera;
  int width = 1280;  // of a plan or an overview
  int height = 960;
  OverviewOptions overview;
  Light light;
  Wanted wanted;
};

class Film {
 public:
  // `motion` is null for maps without a vehicle; it must outlive this.
  Film(const geom::BoxMap& map, std::vector<Line> lines, const Motion* motion,
       const FilmOptions& options, const geom::Execution& run);

  int width() const { return width_; }
  int height() const { return height_; }
  View view(double time) const;  // what depth and ids belong to

  // The frames at these times, in order. Nothing where no vehicle is to be shown.
  std::vector<Picture> frames(const std::vector<std::optional<double>>& times,
                              const geom::Execution& run) const;

 private:
  Picture on_map(const std::optional<double>& time) const;
  // The map as it is before a vehicle is drawn on it. `flat`: lines are painted, and are no tubes.
  void take_map(const geom::BoxMap& map, Look look, const geom::Aabb& shown, bool flat,
                const geom::Execution& run);
  void put_beside(const Picture& eye, double time, Picture& whole) const;

  FilmOptions options_;
  const Motion* motion_;
  std::vector<Line> lines_;
  int width_ = 0;
  int height_ = 0;
  std::unique_ptr<PictureScene> scene_;
  std::unique_ptr<Shader> shader_;
  View map_view_;
  Picture map_;  // with the lines, without a vehicle
  std::vector<StripChart> charts_;
};

}  // namespace render
