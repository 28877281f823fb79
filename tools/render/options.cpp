#include "options.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

#include "cli/file/ending.h"
#include "cli/file/files.h"
#include "cli/file/frame_output.h"
#include "cli/option/numbers_option.h"
#include "cli/option/option_check.h"
#include "cli/option/output_option.h"
#include "cli/run.h"
#include "geom/text/words.h"

namespace render {
namespace {

using geom::picture::FilmKind;

constexpr double kDegree = 0.017453292519943295;
constexpr int kMostPixels = 16384;

constexpr geom::Words<ColourFormat, 3> kColourFormatWords{
    {{ColourFormat::by_name, "auto"}, {ColourFormat::png, "png"}, {ColourFormat::y4m, "y4m"}}};

// An option that says a value by one of the words.
template <class Enum, std::size_t N>
CLI::Option* add_choice(CLI::App& app, const char* flag, Enum& value,
                        const geom::Words<Enum, N>& words) {
  std::vector<std::string> known;
  for (const auto& [each, word] : words) known.emplace_back(word);
  return app
      .add_option_function<std::string>(
          flag, [&](const std::string& word) { value = *geom::value_of(words, word); })
      ->check(CLI::IsMember(known))
      ->default_str(std::string(geom::word_of(words, value)));
}

// "1280x960".
void parse_size(const std::string& word, geom::picture::FilmOptions& film) {
  const auto numbers = [&]() -> std::optional<std::vector<double>> {
    std::string text = word;
    const std::size_t cross = text.find('x');
    if (cross == std::string::npos) return std::nullopt;
    text[cross] = ',';
    return cli::parse_numbers(text, 2);
  }();
  const auto fits = [](double v) { return v == std::floor(v) && v >= 1 && v <= kMostPixels; };
  if (!numbers || !fits((*numbers)[0]) || !fits((*numbers)[1])) {
    throw cli::UsageError(fmt::format(
        "--image-size: expected WIDTHxHEIGHT, each from 1 to {}, found \"{}\"", kMostPixels, word));
  }
  film.width = static_cast<int>((*numbers)[0]);
  film.height = static_cast<int>((*numbers)[1]);
}

// An angle that options say in degrees.
CLI::Option* add_angle(CLI::App& app, const char* flag, double& radians, const char* words) {
  return app.add_option_function<double>(
      flag, [&radians](double degrees) { radians = degrees * kDegree; }, words);
}

}  // namespace

void Options::add_to(CLI::App& app) {
  app.add_option("map", map, "box map; - for stdin")->required();
  app.add_option("files", inputs,
                 "trajectories, flight logs, paths and search trees; the first motion is flown");
  add_choice(app, "--view", film.kind, geom::picture::kFilmKindWords)
      ->description("first-person, plan, overview or combined");
  app.add_option("--id", id,
                 "the trajectory or flight to fly (default: the first flight, else trajectory)");
  app.add_option("--camera", camera_file, "camera model, JSON (default: 640 x 480, 80 degrees)");
  app.add_option("--rate", rate, "frames a second of simulated time")
      ->check(CLI::Range(1e-3, 1e5))
      ->capture_default_str();
  app.add_option("--at", at, "one picture, at this time (s)")->check(CLI::Range(-1e9, 1e9));
  app.add_option("--image-size", size, "WIDTHxHEIGHT of a plan or an overview (default: 1280x960)");
  add_angle(app, "--azimuth", film.overview.azimuth,
            "overview: look this way, degrees from north clockwise (default: 34)")
      ->check(CLI::Range(-360.0, 360.0));
  add_angle(app, "--elevation", film.overview.elevation,
            "overview: look down by so many degrees (default: 34)")
      ->check(CLI::Range(1.0, 89.0));
  metres.add_to(app);
  app.add_flag("--shadows", film.light.shadows, "the sun casts soft shadows");
  app.add_option("--samples", samples,
                 "rays a side of each pixel (default: 1 through the camera, else 3)")
      ->check(CLI::Range(1, 8));
  add_choice(app, "--format", format, kColourFormatWords)
      ->description("format of the colour: png, y4m, or auto (by the name)");
  cli::add_output(app, "-o,--output", colour,
                  "colour: .y4m for a video, or .png, numbered as in f-%05d.png (default: stdout)");
  cli::add_output(app, "--depth", depth, "depth along the optical axis: .png (16 bit) or .pfm (m)");
  app.add_option("--depth-unit", depth_unit, "how many metres a step in a depth .png is")
      ->check(CLI::Range(1e-6, 1e3))
      ->capture_default_str();
  cli::add_output(app, "--ids", ids,
                  "which box each pixel shows: .png, red + 256 green + 65536 blue");
  cli::add_output(app, "--poses", poses, "where the camera was at each frame: CSV");
}

bool Options::is_video() const {
  if (format != ColourFormat::by_name) return format == ColourFormat::y4m;
  if (colour != "-") return colour.ends_with(".y4m");
  return has_eye() && !at;
}

bool Options::is_moving() const {
  return !at && (has_eye() || is_video() || cli::is_numbered(colour));
}

void Options::refuse_idle(const CLI::App& app) const {
  const bool over = film.kind == FilmKind::overview || film.kind == FilmKind::combined;
  cli::only_for(app, over, {"--azimuth", "--elevation"}, "overviews");
  cli::only_for(app, has_eye(), {"--camera"}, "views through the camera");
  cli::only_for(app, is_moving(), {"--rate"}, "videos and numbered pictures");
  cli::only_for(app, depth.ends_with(".png"), {"--depth-unit"}, "a --depth .png");
}

void Options::require_endings() const {
  constexpr std::string_view kAdvice =
      "; for another format write one of these and convert it: ffmpeg -i x.y4m -pix_fmt yuv420p "
      "x.mp4, convert x.png x.jpg";
  switch (format) {
    case ColourFormat::by_name:
      cli::require_ending("-o", colour, {".png", ".y4m"}, kAdvice);
      break;
    case ColourFormat::png:
      cli::require_ending("-o", colour, {".png"}, ", as --format png is asked for");
      break;
    case ColourFormat::y4m:
      cli::require_ending("-o", colour, {".y4m"}, ", as --format y4m is asked for");
      break;
  }
  cli::require_ending("--ids", ids, {".png"}, "");
}

void Options::settle() {
  require_endings();
  if (!camera_file.empty()) {
    cli::InputFile file(camera_file);
    film.camera = geom::picture::parse_camera(geom::JsonFields(file.read_all(), camera_file, 0));
  }
  if (!size.empty()) {
    if (has_eye())
      throw cli::UsageError("--image-size is for plans and overviews: the camera has its own");
    parse_size(size, film);
  }
  if (!depth.empty() && !depth.ends_with(".png") && !depth.ends_with(".pfm")) {
    throw cli::UsageError(fmt::format("--depth: expected .png or .pfm, found \"{}\"", depth));
  }
  if (!poses.empty() && !has_eye()) {
    throw cli::UsageError("--poses is for views through the camera");
  }
  film.wanted.samples = samples.value_or(has_eye() ? 1 : 3);
  film.wanted.depth = !depth.empty();
  film.wanted.id = !ids.empty();
}

}  // namespace render
