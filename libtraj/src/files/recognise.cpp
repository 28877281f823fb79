#include "traj/files/recognise.h"

#include <fmt/format.h>

#include "geom/cloud/cloud_format.h"
#include "geom/gis/footprint_format.h"
#include "geom/import/import_boxes.h"
#include "geom/model/model_format.h"
#include "geom/text/beginning.h"
#include "geom/text/excerpt.h"
#include "geom/zone/read_zones.h"
#include "traj/files/drone_formats.h"
#include "traj/files/foreign_formats.h"
#include "traj/files/own_formats.h"

namespace traj::files {

std::vector<const geom::Format*> all_formats() {
  std::vector<const geom::Format*> all;
  const auto add = [&](geom::Formats table) { all.insert(all.end(), table.begin(), table.end()); };
  add(own_formats());
  add(geom::zone_formats());
  add(drone_formats());
  add(geom::formats_of(geom::box_formats()));
  add(geom::formats_of(geom::cloud_formats()));
  add(geom::formats_of(geom::model_formats()));
  add(geom::formats_of(geom::gis::footprint_formats()));
  add(foreign_formats());
  return all;
}

const geom::Format* recognise(std::string_view head) {
  static const std::vector<const geom::Format*> all = all_formats();
  return geom::recognise(head, all);
}

const geom::Format* recognise(std::string_view head, const std::string& name) {
  const bool packed = head.starts_with("BZh") || head.starts_with("\x1f\x8b");
  if (packed && geom::gis::is_packed_osm(name)) return &geom::gis::kPackedOsm;
  if (const geom::Format* const format = recognise(head)) return format;
  const geom::ModelFormat* const model = geom::model_format_by_ending(name);
  return model && !head.empty() ? model->format : nullptr;
}

std::string described(const geom::Format& format, std::string_view head) {
  if (&format != &kZip) return std::string(format.what);
  return fmt::format("{} whose first entry is \"{}\"", format.what,
                     geom::excerpt(geom::first_zip_entry(head), 40));
}

}  // namespace traj::files
