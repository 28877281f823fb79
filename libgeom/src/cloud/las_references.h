#pragma once

// The records of a LAS file that describe its coordinates, gathered while they pass.

#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <string_view>

#include "geom/earth/coordinate_reference.h"

namespace geom {

class LasReferences {
 public:
  explicit LasReferences(std::string_view source) : source_(source) {}

  // A record of any kind. Throws InputError(source, …) where it differs from one of its kind that
  // passed before, and where it says that points are to be transformed (2111).
  void take(std::string_view user, std::uint16_t id, const std::string& data);

  // Of text and keys the one that the header names. Throws where the other contradicts it.
  CoordinateReference reference(bool well_known_text) const;

  const std::string& source() const { return source_; }

 private:
  void keep(std::string& kept, std::string_view data, const char* what) const;

  std::string source_;
  std::string directory_;  // GeoTIFF keys, as bytes
  std::string doubles_;
  std::string text_;
  std::string liblas_;  // text, as an old library wrote it
};

// Refuses a record of `area` that describes the coordinates and is none of those at `heads`: the
// length of one before it is wrong, or the number of all.
void require_no_lost_reference(std::string_view area, const std::set<std::size_t>& heads,
                               const std::string& source);

// Looks through all that follows the points, whatever the header says of records there.
class LaterReferences {
 public:
  LaterReferences(LasReferences told, bool well_known_text)
      : told_(std::move(told)), well_known_text_(well_known_text) {}

  // Bytes that follow those before. Throws InputError(source, …) where a record describes the
  // coordinates, and none did before the points or that says something else.
  void take(std::span<const unsigned char> bytes);

  // No bytes follow. Throws as take().
  void finish() { look(true); }

 private:
  void look(bool last);
  void take_record(std::uint16_t id, std::size_t bytes);

  LasReferences told_;
  bool well_known_text_;
  std::string window_;  // what was not looked at yet
};

}  // namespace geom
