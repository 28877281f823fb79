#include "gdal_gml.h"

#include <atomic>

#include "gdal_whole.h"

namespace geom::gis {
namespace {

bool is_gml(const std::string& path) {
  const GDALDriverH driver = gdal().identify(path.c_str(), GDAL_OF_VECTOR, nullptr, nullptr);
  return driver && std::string_view(gdal().driver_name(driver)) == "GML";
}

}  // namespace

std::unique_ptr<GmlInMemory> GmlInMemory::of(const std::string& path, const std::string& name) {
  if (!is_gml(path)) return nullptr;
  std::string text = content_of(path, name);
  if (text.starts_with("\x1f\x8b")) text = content_of("/vsigzip/" + path, name);
  return std::unique_ptr<GmlInMemory>(new GmlInMemory(std::move(text)));
}

GmlInMemory::GmlInMemory(std::string text) : text_(std::move(text)) {
  static std::atomic<unsigned> number = 0;
  path_ = fmt::format("/vsimem/skyway_{}.gml", ++number);
  const FileHandle file(gdal().file_in_memory(path_.c_str(), reinterpret_cast<GByte*>(text_.data()),
                                              text_.size(), FALSE));
}

GmlInMemory::~GmlInMemory() {
  gdal().remove(path_.c_str());
  gdal().remove(gdal().with_extension(path_.c_str(), "gfs"));
}

}  // namespace geom::gis
