#include "numbers_option.h"

#include <fmt/format.h>

#include <cmath>

#include "cli/answer/exit.h"
#include "geom/text/number.h"

namespace cli {

std::optional<std::vector<double>> parse_numbers(std::string_view text, std::size_t count) {
  std::vector<double> values;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (true) {
    double value = 0;
    const auto [rest, error] = geom::read_number(at, end, value);
    if (error != std::errc() || !(std::abs(value) <= geom::kLargestCoordinate)) return std::nullopt;
    values.push_back(value);
    if (rest == end) break;
    if (*rest != ',') return std::nullopt;
    at = rest + 1;
  }
  if (values.size() != count) return std::nullopt;
  return values;
}

CLI::Option* add_point(CLI::App& app, const std::string& flag, std::optional<geom::Vec3>& point,
                       const std::string& description) {
  return app
      .add_option_function<std::string>(
          flag,
          [&point, flag](const std::string& text) {
            const auto v = parse_numbers(text, 3);
            if (!v)
              throw UsageError(
                  flag + ": expected x,y,z in metres, as one word such as 12.5,30,5, found \"" +
                  text + '"');
            point = geom::Vec3((*v)[0], (*v)[1], (*v)[2]);
          },
          description)
      ->type_name("X,Y,Z");
}

CLI::Option* add_place(CLI::App& app, const std::string& flag, std::optional<geom::Place>& place,
                       const std::string& description) {
  return app
      .add_option_function<std::string>(
          flag,
          [&place, flag](const std::string& text) {
            place = geom::parse_place(text);
            if (place) return;
            throw UsageError(
                fmt::format("{}: expected {}, found \"{}\"", flag, geom::kPlaceForms, text));
          },
          description)
      ->type_name("PLACE");
}

CLI::Option* add_box(CLI::App& app, const std::string& flag, std::optional<geom::Aabb>& box,
                     const std::string& description) {
  return app
      .add_option_function<std::string>(
          flag,
          [&box, flag](const std::string& text) {
            const auto v = parse_numbers(text, 6);
            if (!v || (*v)[0] > (*v)[3] || (*v)[1] > (*v)[4] || (*v)[2] > (*v)[5]) {
              throw UsageError(flag +
                               ": expected x0,y0,z0,x1,y1,z1 in metres, min <= max, found \"" +
                               text + '"');
            }
            box = geom::Aabb{{(*v)[0], (*v)[1], (*v)[2]}, {(*v)[3], (*v)[4], (*v)[5]}};
          },
          description)
      ->type_name("X0,Y0,Z0,X1,Y1,Z1");
}

}  // namespace cli
