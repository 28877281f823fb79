#pragma once

// The points of a file that were asked for, in metres of the map.

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <vector>

#include "geom/cloud/copc.h"
#include "geom/cloud/draft_cloud.h"

namespace geom {

class CloudSource {
 public:
  // Both must outlive it. The options have a format.
  CloudSource(const CloudFile& file, const CloudDraftOptions& options, const Execution& run)
      : file_(file), options_(options), run_(run), place_(options.place) {}

  // Reads the file, once more each time. `f` is called by one thread at a time, for many points or
  // for each.
  void for_each_chunk(const PointSink& f);
  void for_each(const std::function<void(const CloudPoint&)>& f);

  // Of the last reading:
  const nlohmann::ordered_json& input() const { return input_; }  // for the map's history
  const CloudPlace& place() const { return place_; }
  const Skipped& skipped() const { return counts_.skipped; }
  bool says_nothing() const { return says_nothing_; }  // about its reference system
  std::vector<Fact> facts() const;                     // how many points, and how many dropped

 private:
  bool wants(const CloudPoint& p);
  void read(HashedStream& bytes, const PointSink& sink);
  void read_part(const PointSink& sink);
  LasReading reading() const;
  CopcPart part() const;
  bool reads_part(std::string_view head) const;
  void settle(const CoordinateReference& told);
  std::span<const CloudPoint> place_wanted(std::span<const CloudPoint> chunk);

  const CloudFile& file_;
  const CloudDraftOptions& options_;
  Execution run_;
  CloudPlace place_;
  bool read_before_ = false;
  CloudCounts counts_;
  bool says_nothing_ = false;
  std::size_t other_class_ = 0;
  std::size_t noise_ = 0;
  std::vector<CloudPoint> wanted_;  // of a chunk, where that is not all of it as it is
  nlohmann::ordered_json input_;
  std::optional<CopcCounts> part_;  // where not all was read
};

}  // namespace geom
