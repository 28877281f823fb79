#include <fmt/format.h>

#include <optional>

#include "geom/cloud/point_cloud.h"
#include "geom/text/text_table.h"
#include "point_chunks.h"

namespace geom {

CloudCounts read_xyz(std::istream& in, std::string_view source, const PointSink& sink) {
  constexpr std::string_view kSeparators = " \t,;\r";
  TextLines lines(in, source);
  PointChunks chunks(source, sink);
  std::optional<double> promised;  // by a header that is a count
  std::size_t found = 0;
  bool first = true;  // a header may still come: a line of words, or of a count alone
  while (lines.next()) {
    std::string_view rest = lines.line();
    if (rest.empty() || rest[0] == '#' || rest.starts_with("//")) continue;
    Vec3 p;
    bool words = false;
    for (int i = 0; i < 3 && !words; ++i) {
      const std::size_t at = rest.find_first_not_of(kSeparators);
      const std::size_t end = at == rest.npos ? at : rest.find_first_of(kSeparators, at);
      const std::string_view field = at == rest.npos ? "" : rest.substr(at, end - at);
      const auto value = parse_number(field);
      words = !value;
      const bool header = i == 0 || (i == 1 && field.empty());
      if (words && !(first && header)) {
        lines.refuse(
            fmt::format("expected three numbers, found \"{}\"", lines.line().substr(0, 60)));
      }
      if (value) p[i] = *value;
      if (words && i == 1) promised = p[0];
      rest = end == rest.npos ? std::string_view() : rest.substr(end);
    }
    if (!words) {
      chunks.add(p);
      ++found;
    }
    first = false;
  }
  if (promised && *promised != static_cast<double>(found)) {
    lines.refuse(
        fmt::format("expected {} points, as the first line says, found {}", *promised, found));
  }
  return chunks.finish();
}

}  // namespace geom
