#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <istream>
#include <iterator>
#include <string>

#include "geom/base/error.h"
#include "geom/base/text_stream.h"
#include "geom/model/model.h"
#include "geom/model/model_format.h"
#include "geom/text/beginning.h"
#include "geom/text/excerpt.h"
#include "geom/text/text_table.h"
#include "text/unit_comment.h"

// 3D Systems' StereoLithography Interface Specification (1989).

namespace geom {
namespace {

constexpr std::size_t kText = 80;
constexpr std::size_t kHead = 84;
constexpr std::size_t kFacet = 50;

template <class T>
T value_at(std::string_view bytes, std::size_t at) {
  static_assert(std::endian::native == std::endian::little);
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

void add_triangle(Model& model, const std::array<Vec3, 3>& corners) {
  const auto first = static_cast<std::uint32_t>(model.mesh.vertices.size());
  model.mesh.vertices.insert(model.mesh.vertices.end(), corners.begin(), corners.end());
  model.mesh.triangles.push_back(
      {{first, first + 1, first + 2}, static_cast<std::uint32_t>(model.parts.size() - 1)});
}

Model read_binary(std::string_view bytes, std::string_view source) {
  Model model;
  model.parts = {""};
  model.unit = unit_of_comment(bytes.substr(0, kText));
  const auto count = value_at<std::uint32_t>(bytes, 80);
  model.mesh.triangles.reserve(count);
  model.mesh.vertices.reserve(3 * static_cast<std::size_t>(count));
  for (std::uint32_t i = 0; i < count; ++i) {
    std::array<Vec3, 3> corners;
    for (std::size_t k = 0; k < 9; ++k) {
      const std::size_t at = kHead + kFacet * i + 12 + 4 * k;
      const auto v = static_cast<double>(value_at<float>(bytes, at));
      if (!(std::abs(v) <= kLargestCoordinate)) {
        throw InputError(source,
                         {.item = fmt::format("triangle {}", i),
                          .expected = fmt::format("coordinates within {}", kLargestCoordinate),
                          .found = fmt::to_string(v)});
      }
      corners[k / 3][static_cast<Eigen::Index>(k % 3)] = v;
    }
    add_triangle(model, corners);
  }
  return model;
}

class StlText {
 public:
  StlText(std::istream& in, std::string_view source) : lines_(in, source) {}

  Model read() {
    while (lines_.next()) {
      if (lines_.line().empty()) continue;
      const std::string word = next_word();
      if (word == "solid") {
        begin_solid();
      } else if (word == "facet") {
        require_normal();
        read_facet();
      } else if (word == "endsolid") {
        if (!open_) refuse("solid");
        open_ = false;
      } else {
        refuse("solid, facet or endsolid");
      }
    }
    if (open_) lines_.refuse({.expected = "endsolid", .found = "the end of the file"});
    if (model_.parts.empty()) lines_.refuse({.expected = "a solid", .found = "none"});
    return std::move(model_);
  }

 private:
  std::string next_word() {
    words_.clear();
    words_.str(std::string(lines_.line()));
    std::string word;
    words_ >> word;
    return word;
  }

  // What stands behind on the same line would be a corner or a facet that nobody looks at.
  void require_line_end(std::string_view expected) {
    if (std::string more; words_ >> more) refuse(fmt::format("{} and nothing after it", expected));
  }

  // The normal itself is not believed: corners tell.
  void require_normal() {
    std::string word;
    if (!(words_ >> word)) return;
    if (word != "normal") refuse("facet normal");
    for (int i = 0; i < 3; ++i) words_ >> word;
    require_line_end("facet normal with three numbers");
  }

  [[noreturn]] void refuse(std::string_view expected) const {
    lines_.refuse(
        {.expected = std::string(expected), .found = in_quotes(excerpt(lines_.line(), 40))});
  }

  void begin_solid() {
    if (open_) refuse("facet or endsolid");
    open_ = true;
    const auto unit = unit_of_comment(lines_.line());
    if (!model_.parts.empty() && unit != model_.unit) {
      lines_.refuse(
          {.expected = "solids of one unit", .found = in_quotes(excerpt(lines_.line(), 40))});
    }
    model_.unit = unit;
    model_.parts.emplace_back(trimmed(lines_.line().substr(5)));
  }

  std::string next_line(std::string_view expected) {
    do {
      if (!lines_.next()) lines_.refuse({.expected = std::string(expected), .found = "the end"});
    } while (lines_.line().empty());
    return next_word();
  }

  void require_word(std::string_view word, std::string_view expected) {
    if (next_line(expected) != word) refuse(expected);
    require_line_end(word);
  }

  void read_facet() {
    if (!open_) refuse("solid");
    std::string loop;
    if (next_line("outer loop") != "outer" || !(words_ >> loop) || loop != "loop") {
      refuse("outer loop");
    }
    require_line_end("outer loop");
    std::array<Vec3, 3> corners;
    for (Vec3& corner : corners) {
      if (next_line("vertex") != "vertex") refuse("vertex");
      std::string number;
      for (int i = 0; i < 3; ++i) {
        if (!(words_ >> number)) refuse("vertex and three numbers");
        corner[i] = coordinate(lines_, "vertex", number);
      }
      require_line_end("vertex and three numbers");
    }
    require_word("endloop", "endloop after three vertices");
    require_word("endfacet", "endfacet");
    add_triangle(model_, corners);
  }

  TextLines lines_;
  TextInput words_;
  Model model_;
  bool open_ = false;
};

}  // namespace

Model read_stl(std::istream& in, std::string_view source) {
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (bytes.size() >= kHead) {
    const auto count = static_cast<std::size_t>(value_at<std::uint32_t>(bytes, 80));
    if (bytes.size() == kHead + kFacet * count) return read_binary(bytes, source);
    if (!bytes.starts_with("solid")) {
      throw InputError(source,
                       {.expected = fmt::format("{} bytes for the {} triangles that its head names",
                                                kHead + kFacet * count, count),
                        .found = fmt::to_string(bytes.size())});
    }
  }
  TextInput text(bytes);
  return StlText(text, source).read();
}

namespace {

LoadedModel load_stl(const ModelFile& file) {
  TextInput in(file.bytes);
  return {read_stl(in, file.path)};
}

constexpr std::string_view kReaders[] = {"skyway-mesh"};
constexpr Format kFormat{
    .word = "stl",
    .what = "an STL model",
    .begins = any_of<text_begins_with<"solid ">, begins_with<"solid\n">, begins_with<"solid\r">>,
    .readers = kReaders};

}  // namespace

constinit const ModelFormat kStlModel{.format = &kFormat, .ending = ".stl", .read = load_stl};

}  // namespace geom
