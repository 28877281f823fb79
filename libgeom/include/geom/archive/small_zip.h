#pragma once

// Small ZIP archives, as other programs make and read them: a few files, whole in memory.
//
// Example:
//   const std::vector<geom::SmallFile> files = {{"wpmz/waylines.wpml", "<kml/>"}};
//   std::ostringstream out;
//   geom::write_small_zip(out, files);
//   const geom::SmallZip asked{.what = "a DJI mission (.kmz)", .wanted = {"wpmz/waylines.wpml"}};
//   assert(geom::files_of_zip(out.str(), "mission.kmz", asked)[0].content == "<kml/>");

#include <cstdint>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace geom {

struct SmallFile {
  std::string name;  // with its folders, "/" between them
  std::string content;
};

// Which files of an archive are wanted.
struct SmallZip {
  const char* what;                       // "a mission of DJI (.kmz)", for messages
  std::vector<std::string_view> wanted;   // names; others are not unpacked
  std::vector<std::string_view> alone;    // endings, as ".kml", that only the wanted may have
  std::uint64_t most_content = 64 << 20;  // bytes of each of them
};

// The wanted files that are in the archive, stored or deflated, in the order of `zip.wanted`.
// Throws InputError if `archive` is no whole ZIP, has more than 1000 entries, is encrypted, has
// bytes that belong to no entry, or has an unwanted file with an ending of `alone`. Names must not
// come twice, differ in case alone, or lead out of the archive's folder. A wanted file must not be
// damaged (its checksum is compared) or too large, as said or as found: above `most_content`, or
// over 1 MiB and more than 100 times what it takes in the archive.
std::vector<SmallFile> files_of_zip(std::string_view archive, const std::string& source,
                                    const SmallZip& zip);

// Stored without compression, so that the bytes depend on nothing else; the clock stands at
// 1980-01-01.
void write_small_zip(std::ostream& out, std::span<const SmallFile> files);

}  // namespace geom
