#pragma once

// The points of a file that were asked for, in metres of the map.

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geom/cloud/copc.h"
#include "options.h"

namespace cloud {

class PointSource {
 public:
  // `options` must outlive it; the format and the placement are settled in it.
  PointSource(const std::string& path, Options& options, const geom::Execution& run)
      : path_(path), options_(options), run_(run) {}

  // Reads the file, once more each time. `f` is called by one thread at a time.
  void for_each(const std::function<void(const geom::CloudPoint&)>& f);

  // Of the last reading:
  const nlohmann::ordered_json& input() const { return input_; }  // for the map's history
  const geom::Skipped& skipped() const { return counts_.skipped; }
  bool says_nothing() const { return says_nothing_; }  // of what its coordinates mean
  void report(nlohmann::ordered_json& out) const;      // how many points, and how many dropped

 private:
  bool wants(const geom::CloudPoint& p);
  void read_whole(const geom::PointSink& sink, const std::string& name);
  void read_part(const geom::PointSink& sink, const std::string& name);
  geom::LasReading reading() const;
  geom::CopcPart part() const;
  bool reads_part(std::string_view head) const;
  void settle(const geom::CoordinateReference& told, const std::string& name);
  void place_wanted(std::span<const geom::CloudPoint> chunk, const std::string& name);

  std::string path_;
  Options& options_;
  geom::Execution run_;
  geom::CloudCounts counts_;
  bool says_nothing_ = false;
  std::size_t other_class_ = 0;
  std::size_t noise_ = 0;
  std::vector<geom::CloudPoint> wanted_;  // of a chunk
  nlohmann::ordered_json input_;
  std::optional<geom::CopcCounts> part_;  // where not all was read
};

}  // namespace cloud
