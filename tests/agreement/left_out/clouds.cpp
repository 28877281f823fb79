// clouds [FILES]: random point clouds in the spellings of their formats, but for scans.cpp's. No
// marked point is left out in silence (support/left_out.h).

#include <liblzf/lzf.h>

#include <cstdlib>
#include <numeric>

#include "marked_points.h"

namespace {

using geom::Vec3;
using left_out::random_places;
using support::chance;
using support::MarkedFile;
using support::one_of;
using support::Random;

// Marks are written with all their digits.
template <class Read>
auto reader_of(const Read& read_cloud) {
  return [read_cloud](std::istream& in, const MarkedFile& file) {
    return left_out::read_points(read_cloud, in, file, 0);
  };
}

// Columns of a text: what they are called, and which hold x, y and z.
struct Columns {
  std::vector<std::string> names;
  std::size_t at[3];
  bool said = true;    // the file says their names
  bool metres = true;  // and these are lengths upward
};

Columns random_columns(Random& random) {
  Columns out;
  struct Names {
    const char* of_axis[3];
    bool metres;
  };
  static const std::vector<Names> kNames = {{{"x", "y", "z"}, true},
                                            {{"X", "Y", "Z"}, true},
                                            {{"Easting", "Northing", "Height"}, true},
                                            {{"E", "N", "H"}, true},
                                            {{"X_m", "Y_m", "Z_m"}, true},
                                            {{"x[m]", "y[m]", "z[m]"}, true},
                                            {{"\"x\"", "\"y\"", "\"z\""}, true},
                                            {{"point_x", "point_y", "elevation"}, true},
                                            {{"lon", "lat", "z"}, false},
                                            {{"Longitude", "Latitude", "Altitude"}, false},
                                            {{"x", "y", "depth"}, false},
                                            {{"X(ft)", "Y(ft)", "Z(ft)"}, false}};
  const Names& names = one_of(random, kNames);
  out.metres = names.metres;
  out.said = !chance(random, 3);
  std::vector<std::size_t> order = {0, 1, 2};
  if (out.said && chance(random, 2))
    std::swap(order[0], order[static_cast<std::size_t>(random.below(3))]);
  if (out.said && chance(random, 3)) out.names.push_back(one_of(random, {"id", "no", "name"}));
  for (const std::size_t axis : order) {
    out.at[axis] = out.names.size();
    out.names.push_back(names.of_axis[axis]);
    if (out.said && chance(random, 6)) out.names.push_back("time");
  }
  for (int i = random.below(4); i > 0; --i) out.names.push_back("RGB" + std::to_string(i));
  if (!out.said) out.metres = true;
  return out;
}

// Numbers as a program of some country writes them, between one separator or another.
MarkedFile xyz(Random& random) {
  MarkedFile out;
  out.marks = random_places(random);
  const Columns columns = random_columns(random);
  out.must_tell = !columns.metres;
  const std::string separator = one_of(random, {" ", "\t", ",", ";", ", ", "  ", " ; "});
  // Between commas without a header, no program could read them.
  const bool decimal_comma = chance(random, 8) && (columns.said || separator[0] != ',');
  const std::string other = chance(random, 12) ? one_of(random, {" ", ",", ";"}) : separator;
  const auto joined = [&](const std::vector<std::string>& fields, const std::string& by) {
    std::string line;
    for (const std::string& field : fields) line += (line.empty() ? "" : by) + field;
    return line;
  };
  std::string text = chance(random, 8) ? "\xef\xbb\xbf" : "";
  if (chance(random, 4)) text += one_of(random, {"# a scan\n", "// by hand\n", "\n", "#\n"});
  if (columns.said)
    text += one_of(random, {"", "", "# ", "//"}) + joined(columns.names, separator) + '\n';
  if (chance(random, 6)) text += std::to_string(out.marks.size()) + '\n';
  for (std::size_t i = 0; i < out.marks.size(); ++i) {
    std::vector<std::string> fields(columns.names.size());
    for (std::string& field : fields) field = std::to_string(random.below(256));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::string& field = fields[columns.at[axis]];
      field = fmt::format("{}", out.marks[i][static_cast<Eigen::Index>(axis)]);
      if (decimal_comma) field = support::replaced(field, ".", ",");
    }
    text += joined(fields, i % 2 ? other : separator) + '\n';
    if (chance(random, 10)) text += "# between\n";
  }
  out.bytes = support::with_line_ends(random, text);
  return out;
}

template <class T>
void put(std::string& out, T value, bool big_endian = false) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  if (big_endian) std::reverse(bytes.begin(), bytes.end());
  out += bytes;
}

// x, y and z in any order among others; seldom a second x.
std::vector<std::string> pcd_fields(Random& random) {
  std::vector<std::string> names = {"x", "y", "z", "rgb", "normal"};
  for (std::size_t i = names.size() - 1; i > 0; --i) {
    std::swap(names[i], names[static_cast<std::size_t>(random.below(static_cast<int>(i) + 1))]);
  }
  if (chance(random, 5)) {
    for (std::string& name : names) {
      if (name.size() == 1) name[0] = static_cast<char>(name[0] - 'a' + 'A');
    }
  }
  if (chance(random, 15)) names.push_back("x");  // again: which of them is meant?
  return names;
}

std::string pcd_head(Random& random, const std::vector<std::string>& names, std::size_t counted,
                     const std::string& data) {
  std::string head = "# .PCD v0.7\nVERSION 0.7\nFIELDS";
  std::string size = "SIZE";
  std::string type = "TYPE";
  std::string count = "COUNT";
  for (const std::string& name : names) {
    head += ' ' + name;
    size += name == "rgb" ? " 4" : " 8";
    type += name == "rgb" ? " U" : " F";
    count += name == "normal" ? " 3" : " 1";
  }
  head += '\n' + size + '\n' + type + '\n' + count + '\n';
  const std::string points = std::to_string(counted);
  head += "WIDTH " + points + "\nHEIGHT 1\n";
  if (chance(random, 2)) head += "VIEWPOINT 0 0 0 1 0 0 0\n";
  if (chance(random, 2)) head += "POINTS " + points + '\n';
  return head + "DATA " + data + '\n';
}

std::string pcd_compressed(const std::vector<std::string>& fields) {
  const std::string all = std::accumulate(fields.begin(), fields.end(), std::string());
  std::string packed(2 * all.size() + 64, '\0');
  packed.resize(lzf_compress(all.data(), static_cast<unsigned>(all.size()), packed.data(),
                             static_cast<unsigned>(packed.size())));
  std::string out;
  put(out, static_cast<std::uint32_t>(packed.size()));
  put(out, static_cast<std::uint32_t>(all.size()));
  return out + packed;
}

// Three encodings; points behind those that the header counts; and the zeros that PCL leaves behind
// its pages.
MarkedFile pcd(Random& random) {
  MarkedFile out;
  out.marks = random_places(random);
  const std::vector<std::string> names = pcd_fields(random);
  const std::string data = one_of(random, {"ascii", "binary", "binary_compressed"});
  const std::string head =
      pcd_head(random, names, out.marks.size() - (chance(random, 10) ? 1 : 0), data);
  std::string body;
  std::vector<std::string> fields(names.size());
  for (const Vec3& p : out.marks) {
    std::string line;
    for (std::size_t f = 0; f < names.size(); ++f) {
      const std::string& name = names[f];
      const bool other = f == 5;  // the second x holds something else
      if (name == "rgb") {
        line += "7 ";
        put(fields[f], std::uint32_t{7});
        continue;
      }
      for (int k = 0; k < (name == "normal" ? 3 : 1); ++k) {
        const double v =
            name == "normal" || other ? random.uniform(-1, 1) : p[(name[0] | 0x20) - 'x'];
        line += fmt::format("{} ", v);
        put(fields[f], v);
      }
    }
    if (data == "ascii") {
      body += line + '\n';
    } else if (data == "binary") {
      for (std::string& field : fields) {
        body += field;
        field.clear();
      }
    }
  }
  if (data == "binary_compressed") body = pcd_compressed(fields);
  if (data != "ascii" && chance(random, 3)) body.resize(body.size() + 4096 - head.size());
  out.must_tell = names.size() > 5;
  out.bytes = data == "ascii" ? support::with_line_ends(random, head + body) : head + body;
  return out;
}

// Rows of numbers as text, or as bytes of either order.
struct PlyRows {
  bool text;
  bool big_endian;
  std::string body;

  template <class T>
  void add(T value) {
    if (text) {
      body += fmt::format("{} ", +value);
    } else {
      put(body, value, big_endian);
    }
  }
  void end() {
    if (text) body += '\n';
  }
};

// An element that is not the vertices; whether it joins some.
bool add_ply_element(Random& random, std::string& head, PlyRows& rows) {
  const std::string name =
      one_of(random, {"camera", "face", "tristrips", "edge", "polygon", "lines"});
  head += "element " + name + " 1\n";
  if (name == "camera") {
    head += "property float view\n";
    rows.add(0.5f);
  } else if (name == "edge" || name == "lines") {
    head += "property int vertex1\nproperty int vertex2\n";
    for (int i = 0; i < 2; ++i) rows.add(std::int32_t{0});
  } else {
    head += "property list uchar int vertex_indices\n";
    rows.add(std::uint8_t{3});
    for (int i = 0; i < 3; ++i) rows.add(std::int32_t{0});
  }
  rows.end();
  return name != "camera";
}

// Elements of all kinds before and behind the points; those that join vertices are obstacles, and
// no points.
MarkedFile ply(Random& random) {
  MarkedFile out;
  out.marks = random_places(random);
  const std::string format = one_of(random, {"ascii", "binary_little_endian", "binary_big_endian"});
  PlyRows rows{format == "ascii", format == "binary_big_endian", ""};
  std::string head = "ply\nformat " + format + " 1.0\n";
  if (chance(random, 3)) head += "comment made by chance\n";
  if (chance(random, 6)) out.must_tell = add_ply_element(random, head, rows);
  head += fmt::format("element vertex {}\n", out.marks.size());
  std::vector<std::string> names = {"x", "y", "z", "red"};
  std::swap(names[0], names[static_cast<std::size_t>(random.below(4))]);
  for (const std::string& name : names) {
    head += (name == "red" ? "property uchar " : "property double ") + name + '\n';
  }
  for (const Vec3& p : out.marks) {
    for (const std::string& name : names) {
      if (name == "red") {
        rows.add(std::uint8_t{7});
      } else {
        rows.add(p[name[0] - 'x']);
      }
    }
    rows.end();
  }
  if (chance(random, 3)) out.must_tell = add_ply_element(random, head, rows) || out.must_tell;
  out.bytes = head + "end_header\n" + rows.body;
  if (rows.text) out.bytes = support::with_line_ends(random, out.bytes);
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  const auto n = static_cast<std::size_t>(argc > 1 ? std::atof(argv[1]) : 1e4);
  std::size_t lost = support::left_out("XYZ", n, xyz, reader_of(geom::read_xyz));
  lost += support::left_out("PCD", n, pcd, reader_of(geom::read_pcd));
  lost += support::left_out("PLY cloud", n, ply, reader_of(geom::read_ply));
  return lost != 0;
}
