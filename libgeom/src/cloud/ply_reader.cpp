#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <sstream>

#include "geom/cloud/point_cloud.h"
#include "geom/text/text_table.h"
#include "point_chunks.h"

// The Stanford triangle format (Turk 1994).

namespace geom {
namespace {

enum class Encoding { ascii, little, big };

struct Property {
  std::string name;
  Scalar scalar;
  std::optional<Scalar> count;  // of a list
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

class PlyReader {
 public:
  PlyReader(std::istream& in, std::string_view source, const PointSink& sink)
      : in_(in), source_(source), chunks_(source, sink) {}

  CloudCounts read() {
    read_header();
    bool points = false;
    Skipped skipped;
    for (const Element& element : elements_) {
      read_element(element);
      points |= element.name == "vertex";
      if (is_surface(element.name) && element.count > 0) {
        skipped.add("surface of a mesh", fmt::format("element {} {}", element.name, element.count));
      }
    }
    if (in_ >> std::ws && in_.peek() != std::char_traits<char>::eof()) {
      refuse("expected the file to end after the elements that its header names, and it goes on");
    }
    if (!points) refuse("expected an element \"vertex\", found none");
    CloudCounts counts = chunks_.finish();
    counts.skipped = std::move(skipped);
    return counts;
  }

 private:
  static bool is_surface(const std::string& name) {
    return name == "face" || name == "tristrips" || name == "edge";
  }

  [[noreturn]] void refuse(std::string_view message) const {
    throw InputError(source_, line_, message);
  }

  std::string next_line() {
    std::string line;
    if (line_ > 10000 || !std::getline(in_, line)) refuse("the header is cut short");
    ++line_;
    return std::string(trimmed(line));
  }

  Scalar scalar(const std::string& word) const {
    static const std::pair<const char*, Scalar> kTypes[] = {
        {"char", {'I', 1}},  {"int8", {'I', 1}},    {"uchar", {'U', 1}},  {"uint8", {'U', 1}},
        {"short", {'I', 2}}, {"int16", {'I', 2}},   {"ushort", {'U', 2}}, {"uint16", {'U', 2}},
        {"int", {'I', 4}},   {"int32", {'I', 4}},   {"uint", {'U', 4}},   {"uint32", {'U', 4}},
        {"float", {'F', 4}}, {"float32", {'F', 4}}, {"double", {'F', 8}}, {"float64", {'F', 8}}};
    for (const auto& [name, type] : kTypes) {
      if (word == name) return type;
    }
    refuse(fmt::format("expected a type of PLY, found \"{}\"", word.substr(0, 40)));
  }

  void read_header() {
    if (const std::string first = next_line(); first != "ply") {
      refuse(fmt::format("expected a PLY file, whose first line is ply, found \"{}\"",
                         first.substr(0, 40)));
    }
    bool format = false;
    for (std::string line = next_line(); line != "end_header"; line = next_line()) {
      std::istringstream words(line);
      std::string key;
      words >> key;
      if (key == "format") {
        std::string name;
        words >> name;
        format = true;
        if (name == "ascii") {
          encoding_ = Encoding::ascii;
        } else if (name == "binary_little_endian") {
          encoding_ = Encoding::little;
        } else if (name == "binary_big_endian") {
          encoding_ = Encoding::big;
        } else {
          refuse("expected format ascii, binary_little_endian or binary_big_endian, found \"" +
                 name.substr(0, 40) + "\"");
        }
      } else if (key == "element") {
        Element element;
        if (!(words >> element.name >> element.count)) {
          refuse(fmt::format("expected \"element NAME COUNT\", found \"{}\"", line.substr(0, 40)));
        }
        elements_.push_back(std::move(element));
      } else if (key == "property") {
        if (elements_.empty()) refuse("expected an element before its properties, found none");
        add_property(words);
      }
    }
    if (!format) refuse("expected a line \"format …\" in the header, found none");
  }

  void add_property(std::istringstream& words) {
    std::string type;
    Property property;
    words >> type;
    if (type == "list") {
      std::string count;
      words >> count >> type;
      property.count = scalar(count);
      if (property.count->type == 'F')
        refuse("the count of a list must be an integer, found a float");
    }
    property.scalar = scalar(type);
    words >> property.name;
    elements_.back().properties.push_back(std::move(property));
  }

  void read_element(const Element& element) {
    int axis_of[3] = {-1, -1, -1};
    const bool vertex = element.name == "vertex";
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
      const Property& p = element.properties[k];
      if (p.name.size() == 1 && p.name[0] >= 'x' && p.name[0] <= 'z' && !p.count) {
        axis_of[p.name[0] - 'x'] = static_cast<int>(k);
      }
    }
    if (vertex && std::any_of(axis_of, axis_of + 3, [](int k) { return k < 0; })) {
      refuse("expected the properties x, y and z of element \"vertex\", found not all of them");
    }
    if (element.properties.empty()) return;  // takes no bytes, whatever count it claims
    for (std::uint64_t i = 0; i < element.count; ++i) {
      Vec3 p = Vec3::Zero();
      for (std::size_t k = 0; k < element.properties.size(); ++k) {
        const double value = next_value(element, element.properties[k], i);
        for (int axis = 0; axis < 3; ++axis) {
          if (axis_of[axis] == static_cast<int>(k)) p[axis] = value;
        }
      }
      if (vertex) chunks_.add(p);
    }
  }

  // The value, or the last one of a list.
  double next_value(const Element& element, const Property& property, std::uint64_t i) {
    double value = 0;
    std::uint64_t count = 1;
    if (property.count) {
      const double listed = next_scalar(element, *property.count, i);
      if (!(listed >= 0 && listed <= 0xffffffff)) {
        refuse(fmt::format("a list must have 0 to 2^32 - 1 entries, found {}", listed));
      }
      count = static_cast<std::uint64_t>(listed);
    }
    for (std::uint64_t k = 0; k < count; ++k) value = next_scalar(element, property.scalar, i);
    return value;
  }

  double next_scalar(const Element& element, const Scalar& scalar, std::uint64_t i) {
    const auto ended = [&] {
      refuse(fmt::format("expected {} of element \"{}\", and the file ends after {}", element.count,
                         element.name.substr(0, 40), i));
    };
    if (encoding_ == Encoding::ascii) {
      std::string word;
      if (!(in_ >> word)) ended();
      const auto value = parse_number(word);
      if (!value) {
        refuse(fmt::format("{} {}: expected a number, found \"{}\"", element.name.substr(0, 40), i,
                           word.substr(0, 40)));
      }
      return *value;
    }
    unsigned char bytes[8];
    in_.read(reinterpret_cast<char*>(bytes), scalar.size);
    if (in_.gcount() < scalar.size) ended();
    return scalar.at(bytes, encoding_ == Encoding::big);
  }

  std::istream& in_;
  std::string source_;
  PointChunks chunks_;
  std::size_t line_ = 0;
  Encoding encoding_ = Encoding::ascii;
  std::vector<Element> elements_;
};

}  // namespace

CloudCounts read_ply(std::istream& in, std::string_view source, const PointSink& sink) {
  return PlyReader(in, source, sink).read();
}

}  // namespace geom
