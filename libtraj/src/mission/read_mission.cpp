#include "traj/mission/read_mission.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "geom/base/text_stream.h"

namespace traj {

std::vector<FileFlight> read_mission(const std::string& text, const std::string& source,
                                     const MissionFormat& format, const MissionReading& reading,
                                     const geom::Frame& frame) {
  geom::TextInput in(text);
  ReadFlights read = format.read(in, {source, reading, frame});
  const std::string name = std::filesystem::path(source).stem().string();
  const std::size_t count = read.flights.size();
  std::vector<FileFlight> files;
  for (std::size_t i = 0; i < count; ++i) {
    Flown& flown = read.flights[i];
    if (format.is_flown) flown.navigation = reading.flier.allowance(!has_drift(flown));
    std::string id = !read.ids.empty() ? std::move(read.ids[i])
                     : count == 1      ? name
                                       : fmt::format("{}-{}", name, i + 1);
    files.push_back(
        {std::move(id), &format, to_enu(frame.axes, std::move(flown)), read.notes, read.vehicle});
  }
  return files;
}

}  // namespace traj
