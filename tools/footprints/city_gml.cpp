#include "city_gml.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "geom/base/error.h"
#include "geom/text/text_table.h"
#include "gml_drawn.h"
#include "gml_geometry.h"
#include "gml_polygon.h"
#include "gml_words.h"
#include "xml.h"

namespace footprints {
namespace {

constexpr std::size_t kMostSurfaces = 50'000'000;

class Reader : public XmlHandler {
 public:
  Reader(const std::string& name, const std::string& height_attribute)
      : name_(name), height_attribute_(height_attribute) {}

  void begin(XmlElement element) override {
    line_ = element.line;
    Frame frame;
    frame.name = element.name;
    frame.dimension = frames_.empty() ? 3 : frames_.back().dimension;
    if (frames_.empty()) require_city_model(element);
    const auto dimension = geom::parse_number(element.attribute("srsDimension"));
    if (dimension) frame.dimension = *dimension == 2 ? 2 : 3;
    note_srs(element);
    text_.clear();
    take(element, frame);
    frames_.push_back(std::move(frame));
  }

  void text(std::string_view part) override {
    if (!frames_.empty() && frames_.back().reads) text_ += part;
  }

  void end(std::size_t line) override {
    line_ = line;
    const Frame frame = std::move(frames_.back());
    frames_.pop_back();
    if (frame.reads) read_text(frame);
    if (frame.polygon) end_polygon();
    if (frame.shape) shapes_open_.pop_back();
    if (frame.implicit) end_implicit();
    if (frame.bounds) bounds_.pop_back();
    if (frame.object) objects_.pop_back();
    text_.clear();
  }

  CityGml finish() {
    for (const GmlDrawn& drawn : drawn_) place(drawn);
    std::erase_if(out_.model.objects, [](const geom::CityObject& object) {
      return object.geometries.empty() && kInterior.contains(object.type);
    });
    return std::move(out_);
  }

 private:
  // An element that is open, and what it has begun.
  struct Frame {
    std::string name;
    int dimension = 3;
    bool reads = false;  // its text
    bool object = false;
    bool bounds = false;  // a boundary surface
    bool shape = false;
    bool polygon = false;
    bool implicit = false;
    double lod = -1;      // of a property of this level of detail
    std::string unit;     // of a height
    std::string generic;  // the name of a generic attribute
    GmlNumbers numbers;
  };

  [[noreturn]] void refuse(const std::string& message) const {
    throw geom::InputError(name_, line_, message);
  }

  void require_city_model(const XmlElement& element) const {
    const bool version = element.space.ends_with("/citygml/1.0") ||
                         element.space.ends_with("/citygml/2.0") ||
                         element.space.ends_with("/citygml/1/0/0");
    if (element.name == "CityModel" && version) return;
    refuse(
        fmt::format("expected a CityModel of CityGML 1.0 or 2.0, found \"{}\" of \"{}\": convert "
                    "it, for example with citygml-tools",
                    element.name.substr(0, 40), element.space.substr(0, 80)));
  }

  void note_srs(const XmlElement& element) {
    const std::string_view srs = geom::trimmed(element.attribute("srsName"));
    if (srs.empty() || implicit_) return;
    if (out_.model.crs.empty()) out_.model.crs = srs;
    if (out_.model.crs != srs) {
      refuse(fmt::format("expected one coordinate reference system, found \"{}\" after \"{}\"",
                         srs.substr(0, 80), out_.model.crs.substr(0, 80)));
    }
  }

  // What an element begins.
  void take(const XmlElement& element, Frame& frame) {
    const std::string& name = element.name;
    if (polygon_) {
      take_in_polygon(element, frame);
    } else if (name.starts_with("lod") && name.size() > 4 && name[3] >= '0' && name[3] <= '4') {
      frame.lod = name[3] - '0';
      roof_edge_ = name == "lod0RoofEdge";
    } else if (name == "tin") {
      frame.lod = 1;
    } else if (name == "ImplicitGeometry") {
      begin_implicit(frame);
    } else if (implicit_ && take_in_implicit(element, frame)) {
      return;
    } else if (kPolygons.contains(name) || kShapes.contains(name)) {
      begin_shape(element, frame);
    } else if (kLines.contains(name) || name == "controlPoint") {
      const bool apart = shapes_open_.empty() || name == "controlPoint";
      if (!objects_.empty() && apart && !implicit_) {
        ++object().others;
        object().drawn += draws_lines(frames_.back().name);
      }
    } else if (is_type(name)) {
      take_type(element, frame);
    } else {
      take_property(element, frame);
    }
    take_link(element, frame);
  }

  void take_type(const XmlElement& element, Frame& frame) {
    const std::string& name = element.name;
    const bool member = !frames_.empty() && kMembers.contains(frames_.back().name);
    if (member || (!objects_.empty() && (kNested.contains(name) || kInterior.contains(name)))) {
      begin_object(element, member);
      frame.object = true;
    } else if (!objects_.empty() &&
               (name.ends_with("Surface") || name == "Door" || name == "Window")) {
      bounds_.push_back(name);
      frame.bounds = true;
    }
  }

  void take_property(const XmlElement& element, Frame& frame) {
    if (objects_.empty()) return;
    const std::string& name = element.name;
    const std::string& parent = frames_.back().name;
    if (frames_.back().object && kHeights.contains(name)) {
      frame.reads = true;
      frame.unit = unit_of(element.attribute("uom"));
    } else if (name.ends_with("Attribute")) {
      frame.generic = element.attribute("name");
    } else if (name == "value" && !frames_.back().generic.empty() &&
               frames_.back().generic == height_attribute_ && parent.ends_with("Attribute")) {
      frame.reads = true;
      frame.generic = frames_.back().generic;
      frame.unit = unit_of(element.attribute("uom"));
    }
  }

  // A member of a model or of a group stands by itself, other objects within one are parts of it.
  void begin_object(const XmlElement& element, bool member) {
    geom::CityObject object;
    object.type = element.name;
    object.name = element.attribute("id");
    if (object.name.empty()) object.name = fmt::format("{} of line {}", element.name, element.line);
    // Names may come twice; what belongs together must not depend on them.
    object.whole = fmt::format("{}", out_.model.objects.size());
    if (!objects_.empty()) {
      out_.model.objects[objects_.back()].has_parts = true;
      object.is_part = !member;
      if (!member) object.whole = out_.model.objects[objects_.back()].whole;
    }
    objects_.push_back(out_.model.objects.size());
    out_.model.objects.push_back(std::move(object));
  }

  geom::CityObject& object() { return out_.model.objects[objects_.back()]; }

  // A link in a property, in place of what would stand there.
  void take_link(const XmlElement& element, const Frame& frame) {
    const std::string_view link = element.attribute("href");
    if (link.empty() || objects_.empty()) return;
    const bool surfaces = frame.lod >= 0 || !shapes_open_.empty();
    if (!surfaces || is_type(element.name)) return;
    const GmlShapes::Index to = shapes_open_.empty() ? begin_drawn(frame.lod) : shapes_open_.back();
    shapes_.add_link(to, target(link));
  }

  // The id in this file; what is elsewhere is left as it stands, and leads nowhere.
  static std::string target(std::string_view link) {
    return std::string(link.starts_with('#') ? link.substr(1) : link);
  }

  // A geometry of the innermost object.
  GmlShapes::Index begin_drawn(double lod) {
    GmlDrawn drawn;
    drawn.object = objects_.back();
    drawn.geometry.lod = std::max(0.0, lod);
    drawn.geometry.roof_edge = roof_edge_;
    drawn.geometry.roofs_only = !bounds_.empty() && bounds_.back() == "RoofSurface";
    drawn.shape = shapes_.add_shape("");
    drawn_.push_back(drawn);
    return drawn.shape;
  }

  double lod_here() const {
    for (auto frame = frames_.rbegin(); frame != frames_.rend() && !frame->object; ++frame) {
      if (frame->lod >= 0) return frame->lod;
    }
    return -1;
  }

  void begin_shape(const XmlElement& element, Frame& frame) {
    if (objects_.empty()) {
      out_.model.skipped.add("surface of no object", fmt::format("line {}", line_));
    }
    const GmlShapes::Index shape = shapes_.add_shape(std::string(element.attribute("id")));
    const bool extent = std::any_of(frames_.begin(), frames_.end(),
                                    [](const Frame& f) { return f.name == "extent"; });
    if (!shapes_open_.empty()) {
      shapes_.add_part(shapes_open_.back(), shape);
    } else if (implicit_) {
      shapes_.add_part(implicit_->shape, shape);
      implicit_->drawn = true;
    } else if (!objects_.empty() && !extent) {  // an extent is where there is something, not that
      shapes_.add_part(begin_drawn(lod_here()), shape);
    }
    shapes_open_.push_back(shape);
    frame.shape = true;
    if (kPolygons.contains(element.name)) {
      polygon_.emplace();
      frame.polygon = true;
    }
  }

  void take_in_polygon(const XmlElement& element, Frame& frame) {
    const auto form = polygon_->take(element, frame.dimension, name_);
    frame.reads = form.has_value();
    if (form) frame.numbers = *form;
  }

  void end_polygon() {
    GmlPolygon polygon = std::move(*polygon_);
    polygon_.reset();
    const std::string wrong = polygon.wrong();
    if (wrong.empty()) {
      shapes_.add_polygon(shapes_open_.back(), std::move(polygon.rings));
    } else {
      out_.model.skipped.add(wrong, fmt::format("line {}", line_));
    }
  }

  void begin_implicit(Frame& frame) {
    if (implicit_ || objects_.empty()) return;
    implicit_.emplace();
    implicit_->shape = shapes_.add_shape("");
    frame.implicit = true;
  }

  // True where the element is settled.
  bool take_in_implicit(const XmlElement& element, Frame& frame) {
    const std::string& name = element.name;
    if (name == "transformationMatrix" || (is_gml_numbers(name) && shapes_open_.empty())) {
      frame.reads = true;
      frame.numbers.dimension = name == "transformationMatrix" ? 16 : 3;
      if (name == "coordinates") frame.numbers.between_numbers = ",";
      return true;
    }
    if (name == "libraryObject") {
      implicit_->elsewhere = true;
      return true;
    }
    const std::string_view link = element.attribute("href");
    if (link.empty() || !shapes_open_.empty()) return false;
    shapes_.add_link(implicit_->shape, target(link));
    implicit_->drawn = true;
    return true;
  }

  void end_implicit() {
    const GmlImplicit implicit = std::move(*implicit_);
    implicit_.reset();
    if (!implicit.drawn || !implicit.matrix || !implicit.at || implicit.at->size() != 3) {
      if (kInterior.contains(object().type)) return;
      out_.model.skipped.add(implicit.elsewhere ? "shape in another file" : "shape without a place",
                             object().name.substr(0, 60));
      return;
    }
    Eigen::Matrix4d matrix;
    for (int i = 0; i < 16; ++i)
      matrix(i / 4, i % 4) = (*implicit.matrix)[static_cast<std::size_t>(i)];
    for (int i = 0; i < 3; ++i) matrix(i, 3) += (*implicit.at)[static_cast<std::size_t>(i)];
    const GmlShapes::Index shape = begin_drawn(lod_here());
    shapes_.add_part(shape, implicit.shape);
    drawn_.back().place = matrix;
    out_.placed = true;
  }

  void read_text(const Frame& frame) {
    if (is_gml_numbers(frame.name) || frame.name == "transformationMatrix") {
      read_numbers(frame);
      return;
    }
    std::string value(geom::trimmed(text_));
    if (value.empty()) return;
    if (!frame.unit.empty()) value += " " + frame.unit;
    object().attributes[frame.generic.empty() ? frame.name : frame.generic] = value;
  }

  void read_numbers(const Frame& frame) {
    if (polygon_) {
      polygon_->add(text_, frame.numbers, frame.name == "pos", name_, line_);
      return;
    }
    const auto numbers = gml_numbers(text_, frame.numbers);
    if (!numbers || numbers->size() != static_cast<std::size_t>(frame.numbers.dimension)) {
      refuse(fmt::format("expected {} numbers, found \"{}\"", frame.numbers.dimension,
                         std::string(geom::trimmed(text_)).substr(0, 60)));
    }
    (frame.name == "transformationMatrix" ? implicit_->matrix : implicit_->at) = *numbers;
  }

  // A solid and the surfaces that bound an object are often the same polygons.
  void drop_known(const GmlDrawn& drawn, GmlShapes::Surfaces& found) {
    auto& known = known_[{drawn.object, drawn.geometry.lod}];
    std::vector<geom::CitySurface> fresh;
    for (std::size_t i = 0; i < found.surfaces.size(); ++i) {
      if (known.insert(found.polygons[i]).second) fresh.push_back(std::move(found.surfaces[i]));
    }
    found.surfaces = std::move(fresh);
  }

  void place(const GmlDrawn& drawn) {
    geom::CityObject& object = out_.model.objects[drawn.object];
    GmlShapes::Surfaces found = shapes_.surfaces_of(drawn.shape, drawn.place);
    if (!found.lost.empty()) {
      out_.model.skipped.add(
          "surface that a link does not lead to",
          fmt::format("{} of {}", found.lost.substr(0, 60), object.name.substr(0, 60)));
    }
    for (const geom::CitySurface& surface : found.surfaces) {
      for (const auto& ring : surface) {
        for (const geom::Vec3& p : ring) {
          if (p.allFinite() && p.cwiseAbs().maxCoeff() <= geom::kLargestCoordinate) continue;
          throw geom::InputError(name_,
                                 fmt::format("object \"{}\": expected coordinates within 1e8, "
                                             "found a shape that is placed beyond",
                                             object.name.substr(0, 60)));
        }
      }
    }
    if (!drawn.place) drop_known(drawn, found);
    taken_ += found.surfaces.size();
    if (taken_ > kMostSurfaces) {
      throw geom::InputError(name_,
                             fmt::format("expected at most {} surfaces, links followed, found "
                                         "more: cut the file",
                                         kMostSurfaces));
    }
    if (found.surfaces.empty()) return;
    geom::CityGeometry geometry = drawn.geometry;
    geometry.surfaces = std::move(found.surfaces);
    object.geometries.push_back(std::move(geometry));
  }

  const std::string& name_;
  const std::string& height_attribute_;
  std::vector<Frame> frames_;
  std::vector<std::size_t> objects_;  // that are open
  std::vector<std::string> bounds_;   // boundary surfaces that are open
  std::vector<GmlShapes::Index> shapes_open_;
  std::optional<GmlPolygon> polygon_;
  std::optional<GmlImplicit> implicit_;
  bool roof_edge_ = false;
  std::string text_;
  std::size_t line_ = 0;
  GmlShapes shapes_;
  std::vector<GmlDrawn> drawn_;
  std::size_t taken_ = 0;  // surfaces of objects
  std::map<std::pair<std::size_t, double>, std::set<GmlShapes::Index>> known_;
  CityGml out_;
};

}  // namespace

CityGml read_city_gml(std::istream& in, const std::string& name,
                      const std::string& height_attribute) {
  Reader reader(name, height_attribute);
  read_xml(in, name, reader);
  return reader.finish();
}

}  // namespace footprints
