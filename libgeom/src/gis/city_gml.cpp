#include "city_gml.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "geom/base/error.h"
#include "geom/import/building_height.h"
#include "geom/text/text_table.h"
#include "gml_drawing.h"
#include "gml_frame.h"
#include "gml_height.h"
#include "gml_polygon.h"
#include "gml_words.h"
#include "text/xml_events.h"

namespace geom::gis {
namespace {

class Reader : public XmlHandler {
 public:
  Reader(const std::string& name, const std::string& height_attribute)
      : name_(name), height_attribute_(height_attribute) {}

  void begin(const XmlTag& tag) override {
    line_ = tag.line;
    GmlFrame frame;
    frame.name = tag.name;
    if (frames_.empty()) {
      require_city_model(tag);
    } else {
      frame.dimension = frames_.back().dimension;
      frame.data = frames_.back().data || kData.contains(tag.name);
    }
    note_dimension(tag, frame);
    if (!frame.data || is_shape(tag.name)) note_srs(tag);  // an address may have its own
    if (!trimmed(text_).empty()) {
      refuse({.expected = fmt::format("text alone in <{}>", frames_.back().name),
              .found = fmt::format("<{}> in it", tag.name.substr(0, 40))});
    }
    text_.clear();
    if (!polygon_ && !is_shape(tag.name)) drawing_.add_id(tag.attribute("id"));
    take(tag, frame);
    take_link(tag, frame);
    frames_.push_back(std::move(frame));
  }

  void text(std::string_view part) override {
    if (!frames_.empty() && frames_.back().reads) text_ += part;
  }

  void end(std::size_t line) override {
    line_ = line;
    const GmlFrame frame = std::move(frames_.back());
    frames_.pop_back();
    if (frame.reads) read_text(frame);
    if (frame.polygon) end_polygon();
    if (frame.shape) shapes_open_.pop_back();
    if (frame.implicit) end_implicit();
    if (frame.bounds) bounds_.pop_back();
    if (frame.height) end_height();
    if (frame.object) objects_.end();
    text_.clear();
  }

  CityGml finish() {
    drawing_.settle(out_.model, name_);
    return std::move(out_);
  }

 private:
  struct Boundary {
    std::string name;
    std::string id;
  };

  [[noreturn]] void refuse(Fault fault) const { throw InputError(name_, line_, std::move(fault)); }

  void skip(const std::string& kind) {
    out_.model.skipped.add(kind, fmt::format("line {}", line_));
  }

  void require_city_model(const XmlTag& tag) const {
    const bool version =
        tag.space.ends_with("/citygml/1.0") || tag.space.ends_with("/citygml/2.0") ||
        tag.space.ends_with("/citygml/3.0") || tag.space.ends_with("/citygml/1/0/0");
    if (tag.name == "CityModel" && version) return;
    refuse(
        {.expected = "a CityModel of CityGML 1.0 to 3.0",
         .found = fmt::format("\"{}\" of \"{}\"", tag.name.substr(0, 40), tag.space.substr(0, 80)),
         .advice = "convert it, for example with citygml-tools"});
  }

  void note_dimension(const XmlTag& tag, GmlFrame& frame) const {
    for (const char* key : {"srsDimension", "dimension"}) {  // the latter in GML 3.0
      const std::string_view said = trimmed(tag.attribute(key));
      if (said.empty() || (key[0] == 'd' && !is_gml_numbers(tag.name))) continue;
      if (said != "2" && said != "3") {
        refuse({.expected = fmt::format("{} to be 2 or 3", key),
                .found = in_quotes(said.substr(0, 20))});
      }
      frame.dimension = said == "2" ? 2 : 3;
    }
  }

  void note_srs(const XmlTag& tag) {
    const std::string_view srs = trimmed(tag.attribute("srsName"));
    const bool of_template = implicit_ && !within("referencePoint");  // it has axes of its own
    if (srs.empty() || of_template) return;
    if (out_.model.crs.empty()) out_.model.crs = srs;
    if (out_.model.crs != srs) {
      refuse({.expected = "one coordinate reference system",
              .found = fmt::format("\"{}\" after \"{}\"", srs.substr(0, 80),
                                   out_.model.crs.substr(0, 80))});
    }
  }

  // What an element begins.
  void take(const XmlTag& tag, GmlFrame& frame) {
    const std::string_view name = tag.name;
    if (polygon_) {
      take_in_polygon(tag, frame);
    } else if (name.starts_with("lod") && name.size() > 4 && name[3] >= '0' && name[3] <= '4') {
      frame.lod = name[3] - '0';
      roof_edge_ = name == "lod0RoofEdge";
    } else if (name == "tin") {
      frame.lod = 1;
    } else if (name == "ImplicitGeometry") {
      begin_implicit(frame);
    } else if (implicit_ && take_in_implicit(tag, frame)) {
      return;
    } else if (is_shape(name)) {
      begin_shape(tag, frame);
    } else if (kLines.contains(name) || name == "controlPoint") {
      note_lines();
    } else if (is_type(name)) {
      take_type(tag, frame);
    } else {
      take_property(tag, frame);
    }
  }

  // Lines and points are not built; those that are the object are missed.
  void note_lines() {
    std::size_t i =
        frames_.size() - 1;  // the property that holds them, or what they are members of
    while (i > 1 && is_geometry(frames_[i - 1].name)) i -= 2;
    const bool draws = draws_lines(frames_[i].name);
    if (!objects_.any_open()) {
      if (draws) skip("line or point of no object");
    } else if (implicit_) {
      if (!within("referencePoint")) {
        out_.model.skipped.add("placed shape of lines or points", object().name.substr(0, 60));
      }
    } else if (!kWays.contains(object().type) && (draws || shapes_open_.empty())) {
      ++objects_.use().others;
      object().drawn += draws;
    }
  }

  bool within(std::string_view name) const {
    return std::any_of(frames_.begin(), frames_.end(),
                       [&](const GmlFrame& frame) { return frame.name == name; });
  }

  void take_type(const XmlTag& tag, GmlFrame& frame) {
    const std::string_view name = tag.name;
    if (frames_.empty() || name.ends_with("Attribute") || name.ends_with("AttributeSet")) return;
    const GmlFrame& parent = frames_.back();
    if (!shapes_open_.empty() || parent.lod >= 0) {
      const bool beside = name == "LineStringSegment" || parent.data;
      if (!beside) out_.model.skipped.add("shape of an unknown kind", said(tag));
      return;
    }
    const bool member = kMembers.contains(parent.name);
    if (name == "Height" && parent.name == "height" && objects_.any_open()) {
      frame.height = true;
      height_ = {};
    } else if (name == "PointCloud" && objects_.any_open() && !member) {
      ++objects_.use().others;  // of what surfaces show, or else it is missed
    } else if (objects_.any_open() && !member && is_boundary(name)) {
      bounds_.push_back({std::string(name), std::string(tag.attribute("id"))});
      frame.bounds = true;
    } else {
      objects_.begin(tag, member, (member && !kRecords.contains(name)) || kNested.contains(name));
      frame.object = true;
    }
  }

  static std::string said(const XmlTag& tag) {
    return fmt::format("line {}: {}", tag.line, tag.name.substr(0, 40));
  }

  void take_property(const XmlTag& tag, GmlFrame& frame) {
    if (!objects_.any_open()) return;
    const std::string_view name = tag.name;
    const GmlFrame& parent = frames_.back();
    const bool attribute = parent.name.ends_with("Attribute");
    if (parent.height) {
      frame.reads = kHeightParts.contains(name);
    } else if (parent.object && kHeights.contains(name)) {
      frame.reads = true;
    } else if (name.ends_with("Attribute")) {
      frame.generic = tag.attribute("name");
    } else if (attribute && name == "name") {  // as CityGML 3.0 names it
      frame.reads = true;
    } else if (attribute && name == "value" && !parent.generic.empty() &&
               is_attribute(parent.generic, height_attribute_)) {
      frame.reads = true;
      frame.generic = height_attribute_;
    }
    if (frame.reads) frame.unit = unit_of(tag.attribute("uom"));
  }

  CityObject& object() { return objects_[objects_.innermost()]; }

  // A link in a property, in place of what would stand there.
  void take_link(const XmlTag& tag, const GmlFrame& frame) {
    const std::string_view link = tag.attribute("href");
    if (polygon_ || link.empty() || frame.placed) return;
    const bool surfaces = frame.lod >= 0 || !shapes_open_.empty();
    if (surfaces && objects_.any_open()) {
      objects_.use();
      const GmlShapes::Index to =
          shapes_open_.empty() ? begin_drawn(frame.lod) : shapes_open_.back();
      shapes_.add_link(to, target(link));
    } else if (!frame.data && !kRelations.contains(tag.name)) {
      std::optional<std::size_t> from;
      if (objects_.any_open()) {
        from = objects_.innermost();
        objects_.use();
      }
      drawing_.add_link({from, std::string(tag.name), target(link), tag.line});
    }
  }

  // The id in this file; what is elsewhere is left as it stands, and leads nowhere.
  static std::string target(std::string_view link) {
    return std::string(link.starts_with('#') && link.size() > 1 ? link.substr(1) : link);
  }

  // A geometry of the innermost object.
  GmlShapes::Index begin_drawn(double lod) {
    GmlDrawn drawn;
    drawn.object = objects_.innermost();
    objects_.use();
    drawn.geometry.lod = std::max(0.0, lod);
    drawn.geometry.roofs_only = !bounds_.empty() && bounds_.back().name == "RoofSurface";
    drawn.geometry.roof_edge = roof_edge_ || (lod == 0 && drawn.geometry.roofs_only);
    drawn.shape = shapes_.add_shape("");
    std::vector<std::string> boundaries;
    for (const Boundary& b : bounds_) boundaries.push_back(b.id);
    drawing_.add(drawn, boundaries);
    return drawn.shape;
  }

  double lod_here() const {
    for (auto frame = frames_.rbegin(); frame != frames_.rend() && !frame->object; ++frame) {
      if (frame->lod >= 0) return frame->lod;
    }
    return -1;
  }

  void begin_shape(const XmlTag& tag, GmlFrame& frame) {
    if (!objects_.any_open()) {
      skip("surface of no object");
    }
    const GmlShapes::Index shape = shapes_.add_shape(std::string(tag.attribute("id")));
    const bool extent =
        objects_.any_open() && object().type.ends_with("Relief") && within("extent");
    if (!shapes_open_.empty()) {
      shapes_.add_part(shapes_open_.back(), shape);
    } else if (implicit_) {
      shapes_.add_part(implicit_->shape, shape);
      implicit_->drawn = true;
    } else if (objects_.any_open() && !extent) {  // an extent is where there is something, not that
      shapes_.add_part(begin_drawn(lod_here()), shape);
    }
    shapes_open_.push_back(shape);
    frame.shape = true;
    if (kPolygons.contains(tag.name)) {
      polygon_.emplace();
      frame.polygon = true;
    }
  }

  void take_in_polygon(const XmlTag& tag, GmlFrame& frame) {
    const auto form = polygon_->take(tag, frame.dimension, name_);
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
      skip(wrong);
    }
  }

  void begin_implicit(GmlFrame& frame) {
    if (implicit_ || !objects_.any_open()) {
      skip(implicit_ ? "placed shape in a placed shape" : "surface of no object");
      return;
    }
    objects_.use();
    implicit_.emplace();
    implicit_->shape = shapes_.add_shape("");
    frame.implicit = true;
  }

  // True where the element is settled.
  bool take_in_implicit(const XmlTag& tag, GmlFrame& frame) {
    const std::string_view name = tag.name;
    if (name == "transformationMatrix" || (is_gml_numbers(name) && within("referencePoint"))) {
      frame.reads = true;
      frame.numbers.dimension = name == "transformationMatrix" ? 16 : 3;
      if (name == "coordinates") frame.numbers.between_numbers = ",";
      return true;
    }
    if (name == "libraryObject") {
      implicit_->elsewhere = true;
      return true;
    }
    const std::string_view link = tag.attribute("href");
    if (link.empty() || !shapes_open_.empty()) return false;
    shapes_.add_link(implicit_->shape, target(link));
    implicit_->drawn = true;
    frame.placed = true;
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
    const Eigen::Matrix4d matrix = implicit.place();
    if (matrix.row(3) != Eigen::RowVector4d(0, 0, 0, 1)) {
      refuse({.expected = "a transformationMatrix whose last row is 0 0 0 1", .found = "another"});
    }
    const GmlShapes::Index shape = begin_drawn(lod_here());
    shapes_.add_part(shape, implicit.shape);
    drawing_.place_last(matrix);
    out_.placed = true;
  }

  void read_text(const GmlFrame& frame) {
    if (is_gml_numbers(frame.name) || frame.name == "transformationMatrix") {
      read_numbers(frame);
      return;
    }
    std::string value(trimmed(text_));
    if (value.empty()) return;
    if (!frame.unit.empty()) value += " " + frame.unit;
    GmlFrame& parent = frames_.back();
    if (parent.height) {
      (frame.name == "value"           ? height_.value
       : frame.name == "highReference" ? height_.high
                                       : height_.low) = value;
    } else if (frame.name == "name") {
      parent.generic = value;
    } else {
      add_value(value, object().attributes[frame.generic.empty() ? frame.name : frame.generic]);
    }
  }

  void end_height() {
    if (height_.value.empty()) return;
    std::string& told = object().attributes["measuredHeight"];
    told = told.empty() ? height_.text() : GmlHeight::higher(told, height_.text());
  }

  void read_numbers(const GmlFrame& frame) {
    if (polygon_) {
      polygon_->add(text_, frame.numbers, name_, line_);
      return;
    }
    const auto numbers = gml_numbers(text_, frame.numbers);
    if (!numbers || numbers->size() != static_cast<std::size_t>(frame.numbers.dimension)) {
      refuse({.expected = fmt::format("{} numbers", frame.numbers.dimension),
              .found = in_quotes(std::string(trimmed(text_)).substr(0, 60))});
    }
    (frame.name == "transformationMatrix" ? implicit_->matrix : implicit_->at) = *numbers;
  }

  const std::string& name_;
  const std::string& height_attribute_;
  std::vector<GmlFrame> frames_;
  GmlDrawing drawing_;
  GmlObjects& objects_ = drawing_.objects;
  GmlShapes& shapes_ = drawing_.shapes;
  std::vector<Boundary> bounds_;  // that are open
  std::vector<GmlShapes::Index> shapes_open_;
  std::optional<GmlPolygon> polygon_;
  std::optional<GmlImplicit> implicit_;
  bool roof_edge_ = false;
  std::string text_;
  std::size_t line_ = 0;
  GmlHeight height_;  // that is open
  CityGml out_;
};

}  // namespace

CityGml read_city_gml(std::istream& in, const std::string& name,
                      const std::string& height_attribute) {
  Reader reader(name, height_attribute);
  read_xml(in, name, reader);
  return reader.finish();
}

}  // namespace geom::gis
