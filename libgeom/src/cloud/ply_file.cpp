#include "ply_file.h"

#include <fmt/format.h>

#include "geom/base/text_stream.h"
#include "geom/text/counted.h"
#include "geom/text/text_table.h"

namespace geom {

std::optional<std::size_t> PlyElement::find(std::string_view property, bool list) const {
  for (std::size_t k = 0; k < properties.size(); ++k) {
    if (properties[k].name == property && properties[k].count.has_value() == list) return k;
  }
  return std::nullopt;
}

bool PlyElement::holds_indices() const {
  if (count == 0 || name == "camera" || name == "material") return false;
  if (name == "edge") return true;
  std::size_t whole = 0;
  for (const PlyProperty& property : properties) {
    if (property.count) return true;
    whole += property.scalar.type != 'F' && property.scalar.size >= 2;
  }
  return whole >= 2;
}

bool PlyElement::holds_places() const {
  return count > 0 && find("x", false) && find("y", false) && find("z", false);
}

bool PlyElement::holds_splats() const {
  return holds_places() && find("scale_0", false) && find("rot_0", false);
}

PlyFile::PlyFile(std::istream& in, std::string_view source) : in_(in), source_(source) {
  read_header();
}

void PlyFile::refuse(Fault fault) const { throw InputError(source_, line_, std::move(fault)); }

std::string PlyFile::next_line() {
  std::string line;
  if (line_ > 10000 || !std::getline(in_, line)) refuse({.says = "the header is cut short"});
  ++line_;
  const std::string_view text = trimmed(line);
  if (text.find('\r') != text.npos) refuse(lone_return());
  return std::string(text);
}

Scalar PlyFile::scalar(const std::string& word) const {
  static const std::pair<const char*, Scalar> kTypes[] = {
      {"char", {'I', 1}},  {"int8", {'I', 1}},    {"uchar", {'U', 1}},  {"uint8", {'U', 1}},
      {"short", {'I', 2}}, {"int16", {'I', 2}},   {"ushort", {'U', 2}}, {"uint16", {'U', 2}},
      {"int", {'I', 4}},   {"int32", {'I', 4}},   {"uint", {'U', 4}},   {"uint32", {'U', 4}},
      {"float", {'F', 4}}, {"float32", {'F', 4}}, {"double", {'F', 8}}, {"float64", {'F', 8}}};
  for (const auto& [name, type] : kTypes) {
    if (word == name) return type;
  }
  refuse({.expected = "a type of PLY", .found = in_quotes(word.substr(0, 40))});
}

void PlyFile::set_format(const std::string& name) {
  if (name == "ascii") {
    encoding_ = Encoding::ascii;
  } else if (name == "binary_little_endian") {
    encoding_ = Encoding::little;
  } else if (name == "binary_big_endian") {
    encoding_ = Encoding::big;
  } else {
    refuse({.expected = "format ascii, binary_little_endian or binary_big_endian",
            .found = in_quotes(name.substr(0, 40))});
  }
}

void PlyFile::read_header() {
  if (const std::string first = next_line(); first != "ply") {
    refuse({.expected = "a PLY file, whose first line is ply",
            .found = in_quotes(first.substr(0, 40))});
  }
  bool format = false;
  for (std::string line = next_line(); line != "end_header"; line = next_line()) {
    TextInput words(line);
    std::string key;
    words >> key;
    if (key == "comment" || key == "obj_info") comments_.take(line.substr(key.size()));
    if (key == "comment" || key == "obj_info" || key.empty()) continue;
    if (key == "format") {
      std::string name;
      std::string version;
      words >> name >> version;
      format = true;
      set_format(name);
    } else if (key == "element") {
      PlyElement element;
      if (!(words >> element.name >> element.count)) {
        refuse({.expected = "\"element NAME COUNT\"", .found = in_quotes(line.substr(0, 40))});
      }
      elements_.push_back(std::move(element));
    } else if (key == "property") {
      if (elements_.empty())
        refuse({.expected = "an element before its properties", .found = "none"});
      add_property(words);
    } else {
      refuse({.expected = "format, element, property, comment, obj_info or end_header",
              .found = in_quotes(line.substr(0, 40))});
    }
    if (std::string more; words >> more) {
      refuse({.expected = fmt::format("nothing after \"{} …\"", key),
              .found = in_quotes(more.substr(0, 40))});
    }
  }
  if (!format) refuse({.expected = "a line \"format …\" in the header", .found = "none"});
}

void PlyFile::add_property(std::istream& words) {
  std::string type;
  PlyProperty property;
  words >> type;
  if (type == "list") {
    std::string count;
    words >> count >> type;
    property.count = scalar(count);
    if (property.count->type == 'F')
      refuse({.key = "the count of a list", .expected = "an integer", .found = "a float"});
  }
  property.scalar = scalar(type);
  if (!(words >> property.name)) refuse({.expected = "the name of the property", .found = "none"});
  std::vector<PlyProperty>& known = elements_.back().properties;
  for (const PlyProperty& other : known) {
    if (other.name == property.name) {
      refuse({.expected = fmt::format("one property {} of an element", property.name.substr(0, 40)),
              .found = "another"});
    }
  }
  known.push_back(std::move(property));
}

void PlyFile::read_row(const PlyElement& element, std::uint64_t i) {
  row_.values_.clear();
  row_.begins_.assign(1, 0);
  for (const PlyProperty& property : element.properties) {
    std::uint64_t count = 1;
    if (property.count) {
      const double listed = next_scalar(element, *property.count, i);
      if (!(listed >= 0 && listed <= 0xffffffff)) {
        refuse({.says = "a list must have 0 to 2^32 - 1 entries", .found = fmt::to_string(listed)});
      }
      count = static_cast<std::uint64_t>(listed);
    }
    for (std::uint64_t k = 0; k < count; ++k) {
      row_.values_.push_back(next_scalar(element, property.scalar, i));
    }
    row_.begins_.push_back(row_.values_.size());
  }
  if (encoding_ == Encoding::ascii) require_row_end(element, i);
}

// A row that is longer or shorter than its header says would move the numbers of the next.
void PlyFile::require_row_end(const PlyElement& element, std::uint64_t i) {
  std::string rest;
  std::getline(in_, rest);
  if (trimmed(rest).empty()) return;
  refuse(
      {.item = fmt::format("{} {}", element.name.substr(0, 40), i),
       .expected = fmt::format("the line to end after {}", counted(row_.values_.size(), "number")),
       .found = fmt::format("\"{}\" after it", trimmed(rest).substr(0, 40))});
}

double PlyFile::next_scalar(const PlyElement& element, const Scalar& scalar, std::uint64_t i) {
  const auto ended = [&] {
    refuse({.says = fmt::format("expected {} of element \"{}\", and the file ends after {}",
                                element.count, element.name.substr(0, 40), i)});
  };
  if (encoding_ == Encoding::ascii) {
    std::string word;
    if (!(in_ >> word)) ended();
    const auto value = parse_number(word);
    if (!value) {
      refuse({.item = fmt::format("{} {}", element.name.substr(0, 40), i),
              .expected = "a number",
              .found = in_quotes(word.substr(0, 40))});
    }
    return *value;
  }
  unsigned char bytes[8];
  in_.read(reinterpret_cast<char*>(bytes), scalar.size);
  if (in_.gcount() < scalar.size) ended();
  return scalar.at(bytes, encoding_ == Encoding::big);
}

void PlyFile::require_end() {
  if (in_ >> std::ws && in_.peek() != std::char_traits<char>::eof()) {
    refuse(
        {.says =
             "expected the file to end after the elements that its header names, and it goes on"});
  }
}

}  // namespace geom
