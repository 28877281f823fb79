#include "geom/picture/camera_poses.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <string_view>

#include "geom/text/text_table.h"

namespace geom::picture {
namespace {

using Row = std::array<double, 9>;  // as the header has them

Row parse(const TextLines& lines) {
  const std::vector<std::string> names = split_fields(kPosesHeader);
  const std::vector<std::string> fields = split_fields(lines.line());
  Row row{};
  if (fields.size() != row.size()) {
    lines.refuse({.expected = fmt::format("{} columns", row.size()),
                  .found = fmt::to_string(fields.size())});
  }
  for (std::size_t i = 0; i < row.size(); ++i) {
    const auto value = parse_number(fields[i]);
    if (!value || !(std::abs(*value) <= 1e9)) {
      lines.refuse({.key = std::string(names[i]),
                    .expected = "a finite number within 1e9",
                    .found = in_quotes(fields[i].substr(0, 40))});
    }
    row[i] = *value;
  }
  return row;
}

}  // namespace

const std::string_view kPosesHeader = "frame,t_s,east_m,north_m,up_m,qw,qx,qy,qz";

std::string pose_row(const View& view, std::size_t frame, double time) {
  const Eigen::Quaterniond q(view.axes);
  return fmt::format("{},{},{},{},{},{},{},{},{}\n", frame, time, view.eye.x(), view.eye.y(),
                     view.eye.z(), q.w(), q.x(), q.y(), q.z());
}

std::vector<CameraPose> read_camera_poses(std::istream& in, std::string_view name) {
  TextLines lines(in, name);
  if (!lines.next() || lines.line() != kPosesHeader) {
    lines.refuse({.expected = fmt::format("the header {}", kPosesHeader),
                  .found = in_quotes(lines.line().substr(0, 80))});
  }
  std::vector<CameraPose> out;
  while (lines.next()) {
    if (lines.line().empty()) continue;
    const Row row = parse(lines);
    if (row[0] != static_cast<double>(out.size())) {
      lines.refuse(
          {.expected = fmt::format("frame {}", out.size()), .found = fmt::to_string(row[0])});
    }
    if (!out.empty() && !(row[1] > out.back().time)) {
      lines.refuse(
          {.says = "t_s must grow", .found = fmt::format("{} after {}", row[1], out.back().time)});
    }
    out.push_back({row[1], {row[2], row[3], row[4]}});
  }
  if (out.empty()) lines.refuse({.expected = "a row a frame", .found = "none"});
  return out;
}

}  // namespace geom::picture
