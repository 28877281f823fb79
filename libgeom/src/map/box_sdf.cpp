#include "geom/map/box_sdf.h"

#include <algorithm>
#include <array>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "geom/map/geographic_frame.h"
#include "geom/text/markup.h"
#include "geom/text/number.h"
#include "sdf_interval.h"

namespace geom {
namespace {

std::string numbers(std::initializer_list<double> values) {
  std::string out;
  for (const double v : values) {
    if (!out.empty()) out += ' ';
    append_number(out, v == 0 ? 0 : v);  // no -0
  }
  return out;
}

// In quotes.
std::string attribute(std::string_view value) { return '"' + escaped_markup(value) + '"'; }

// Whether it may be the name of a model beside those of `taken`, and is read back as it is.
bool is_name(const std::string& label, const std::set<std::string>& taken) {
  const auto plain = [](char c) { return static_cast<unsigned char>(c) >= ' '; };
  return !label.empty() && label != "world" && label.find("::") == label.npos &&
         !(label.starts_with("__") && label.ends_with("__")) &&
         std::all_of(label.begin(), label.end(), plain) && label.front() != ' ' &&
         label.back() != ' ' && !taken.contains(label);
}

// Text in which control characters stand as numbers; those that XML cannot hold at all as spaces.
std::string text_of(std::string_view label) {
  std::string out;
  while (true) {
    const std::size_t end = std::min(label.find_first_of("\n\t\r"), label.size());
    out += escaped_markup(label.substr(0, end));
    if (end == label.size()) return out;
    out += "&#" + std::to_string(static_cast<int>(label[end])) + ';';
    label.remove_prefix(end + 1);
  }
}

class Writer {
 public:
  Writer(std::ostream& out, const BoxMap& map) : out_(out), map_(map) {}

  std::size_t write() {
    out_ << "<?xml version=\"1.0\"?>\n<sdf version=\"1.7\" xmlns:skyway=\"urn:skyway\">\n"
            "<world name=\"skyway\">\n";
    write_place();
    write_floor();
    const std::vector<std::vector<std::size_t>> by_label = boxes_by_label();
    for (std::size_t label = 0; label < by_label.size(); ++label) {
      if (!by_label[label].empty()) write_model(map_.labels()[label], by_label[label]);
    }
    out_ << "</world>\n</sdf>\n";
    return larger_;
  }

 private:
  std::vector<std::vector<std::size_t>> boxes_by_label() const {
    std::vector<std::vector<std::size_t>> out(map_.labels().size());
    for (std::size_t i = 0; i < map_.size(); ++i) out[map_.label()[i]].push_back(i);
    return out;
  }

  void write_place() {
    const BoxMapSpec& spec = map_.spec();
    const Aabb b = to_enu(spec.frame.axes, spec.bounds);
    out_ << "<skyway:map bounds=\""
         << numbers({b.min.x(), b.min.y(), b.min.z(), b.max.x(), b.max.y(), b.max.z()}) << '"';
    if (!spec.frame.crs.empty()) out_ << " crs=" << attribute(spec.frame.crs);
    const bool counts = counts_from_origin(spec.frame);
    const GeodeticOrigin o = spec.frame.origin.value_or(GeodeticOrigin{});
    if (spec.frame.origin && !counts) {
      out_ << " origin=\"" << numbers({o.latitude, o.longitude, o.height}) << '"';
    }
    out_ << "/>\n";
    if (!counts) return;
    out_ << "<spherical_coordinates><surface_model>EARTH_WGS84</surface_model>"
            "<world_frame_orientation>ENU</world_frame_orientation><latitude_deg>"
         << numbers({o.latitude}) << "</latitude_deg><longitude_deg>" << numbers({o.longitude})
         << "</longitude_deg><elevation>" << numbers({o.height})
         << "</elevation><heading_deg>0</heading_deg></spherical_coordinates>\n";
  }

  void write_floor() {
    constexpr const char* kPlane =
        "<geometry><plane><normal>0 0 1</normal><size>100 100</size></plane></geometry>";
    taken_.insert("ground_plane");
    out_
        << "<light name=\"sun\" type=\"directional\"><direction>-0.5 0.1 -0.9</direction></light>\n"
           "<model name=\"ground_plane\"><static>true</static><pose>"
        << numbers({0, 0, map_.spec().bounds.min.z(), 0, 0, 0})
        << "</pose><link name=\"link\"><collision name=\"collision\">" << kPlane
        << "</collision><visual name=\"visual\">" << kPlane << "</visual></link></model>\n";
  }

  std::string name_of(const std::string& label) {
    if (is_name(label, taken_)) return label;
    std::string name;
    do {
      name = "boxes_" + std::to_string(unnamed_++);
    } while (taken_.contains(name));
    return name;
  }

  void write_model(const std::string& label, const std::vector<std::size_t>& boxes) {
    const std::string name = name_of(label);
    taken_.insert(name);
    out_ << "<model name=" << attribute(name) << "><static>true</static>";
    if (name != label) out_ << "<skyway:label>" << text_of(label) << "</skyway:label>";
    out_ << '\n';
    for (const std::size_t i : boxes) write_link(i);
    out_ << "</model>\n";
  }

  void write_link(std::size_t i) {
    const Aabb box = to_enu(map_.spec().frame.axes, map_.boxes()[i]);
    std::array<SdfInterval, 3> at;
    bool same = true;
    for (int k = 0; k < 3; ++k) {
      at[k] = sdf_interval(box.min[k], box.max[k]);
      same &= at[k].same;
    }
    larger_ += !same;
    std::string inside;
    if (at[0].offset != 0 || at[1].offset != 0 || at[2].offset != 0) {
      inside = "<pose>" + numbers({at[0].offset, at[1].offset, at[2].offset, 0, 0, 0}) + "</pose>";
    }
    inside += "<geometry><box><size>" + numbers({at[0].length, at[1].length, at[2].length}) +
              "</size></box></geometry>";
    out_ << "<link name=\"box_" << i << "\"><pose>"
         << numbers({at[0].place, at[1].place, at[2].place, 0, 0, 0})
         << "</pose><collision name=\"collision\">" << inside
         << "</collision><visual name=\"visual\">" << inside << "</visual></link>\n";
  }

  std::ostream& out_;
  const BoxMap& map_;
  std::set<std::string> taken_;  // names of models
  std::size_t unnamed_ = 0;
  std::size_t larger_ = 0;
};

}  // namespace

std::size_t write_box_sdf(std::ostream& out, const BoxMap& map) { return Writer(out, map).write(); }

}  // namespace geom
