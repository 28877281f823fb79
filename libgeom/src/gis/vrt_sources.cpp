#include "vrt_sources.h"

#include "geom/text/text_table.h"
#include "text/xml_events.h"

namespace geom::gis {
namespace {

bool is_source(std::string_view element) {
  return element == "SimpleSource" || element == "ComplexSource" || element == "AveragedSource" ||
         element == "KernelFilteredSource";
}

double number_of(const XmlTag& tag, std::string_view attribute) {
  return parse_number(tag.attribute(attribute)).value_or(0);
}

VrtRectangle rectangle_of(const XmlTag& tag) {
  return {number_of(tag, "xOff"), number_of(tag, "yOff"), number_of(tag, "xSize"),
          number_of(tag, "ySize")};
}

class VrtReader : public XmlHandler {
 public:
  void begin(const XmlTag& tag) override {
    path_.emplace_back(tag.name);
    text_.clear();
    if (tag.name == "VRTRasterBand" && path_.size() == 2) ++band_;
    if (path_.size() == 3 && path_[1] == "VRTRasterBand" && is_source(tag.name)) {
      sources_.push_back({.band_of_mosaic = band_});
    }
    if (!in_source()) return;
    if (tag.name == "SourceFilename")
      sources_.back().beside = tag.attribute("relativeToVRT") == "1";
    if (tag.name == "SrcRect") sources_.back().from = rectangle_of(tag);
    if (tag.name == "DstRect") sources_.back().to = rectangle_of(tag);
  }

  void text(std::string_view part) override { text_ += part; }

  void end(std::size_t) override {
    if (in_source() && path_.size() == 4) take(path_.back());
    path_.pop_back();
  }

  std::vector<VrtSource> take_sources() { return std::move(sources_); }

 private:
  bool in_source() const {
    return path_.size() >= 4 && path_[1] == "VRTRasterBand" && is_source(path_[2]);
  }

  void take(const std::string& element) {
    VrtSource& source = sources_.back();
    const std::string value(trimmed(text_));
    if (element == "SourceFilename") source.file = value;
    if (element == "NODATA") source.none = parse_number(value);
    if (element == "UseMaskBand") source.obeys_mask = value == "true" || value == "1";
    if (element == "SourceBand") source.band = static_cast<int>(parse_number(value).value_or(0));
  }

  std::vector<std::string> path_;  // from the root to the element
  std::string text_;
  int band_ = 0;
  std::vector<VrtSource> sources_;
};

}  // namespace

std::vector<VrtSource> vrt_sources(std::string_view text, const std::string& name) {
  VrtReader reader;
  read_xml(text, name, reader);
  return reader.take_sources();
}

}  // namespace geom::gis
