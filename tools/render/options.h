#pragma once

// What skyway-render is asked for.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/option/degrees.h"
#include "geom/picture/film.h"

namespace render {

// What the colour is written as.
enum class ColourFormat { by_name, png, y4m };

struct Options {
  std::string map;
  std::vector<std::string> inputs;
  std::string camera_file;
  std::string id;
  std::string colour = "-";
  std::string depth;
  std::string ids;
  std::string poses;
  ColourFormat format = ColourFormat::by_name;
  double depth_unit = 0.01;
  double rate = 30;
  std::optional<double> at;
  std::optional<int> samples;
  std::string size;
  geom::picture::FilmOptions film;
  cli::MetresOption metres;

  void add_to(CLI::App& app);
  // After parsing: fills in what depends on other options. Throws UsageError, or InputError for a
  // bad camera.
  void settle();
  // UsageError for names that end in what is not written.
  void require_endings() const;
  void refuse_idle(const CLI::App& app) const;  // UsageError for options that change nothing

  bool has_eye() const { return geom::picture::has_eye(film.kind); }
  bool is_video() const;   // colour goes into one stream
  bool is_moving() const;  // there is more than one picture
};

}  // namespace render
