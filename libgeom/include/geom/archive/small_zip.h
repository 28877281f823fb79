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

// What an archive is read for.
struct SmallZip {
  const char* what;                       // "a mission of DJI (.kmz)", for messages
  std::vector<std::string_view> wanted;   // names; others are not unpacked
  std::vector<std::string_view> alone;    // endings, as ".kml", that only the wanted may have
  std::uint64_t most_content = 64 << 20;  // bytes of each of them
};

// Those of the wanted files that are there, in the order of `zip.wanted`; stored or deflated.
// InputError where `archive` is no whole ZIP or has more than 1000 entries, for encryption, names
// that come twice or differ in case alone, names that lead out of the archive's folder, bytes that
// belong to no entry, others with an ending of `alone`, and for a wanted file that is too large
// (said or found so; or over 1 MiB, and more than 100 times what it takes in the archive) or
// damaged (its checksum is compared).
std::vector<SmallFile> files_of_zip(std::string_view archive, const std::string& source,
                                    const SmallZip& zip);

// Stored without compression, so that the bytes depend on nothing else; the clock stands at
// 1980-01-01.
void write_small_zip(std::ostream& out, std::span<const SmallFile> files);

}  // namespace geom
