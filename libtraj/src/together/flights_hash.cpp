#include "traj/together/flights_hash.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "geom/base/sha256.h"

namespace traj {

std::string flights_hash(std::span<const std::string> ids, std::span<const TimedFlight> flights,
                         const std::optional<std::string>& epoch) {
  std::vector<std::size_t> order(flights.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return ids[a] < ids[b]; });
  geom::Sha256 sum;
  const auto add_line = [&](const std::string& text) {
    const std::string line = text + '\n';
    sum.update(std::as_bytes(std::span(line)));
  };
  add_line(epoch.value_or(""));
  std::vector<double> numbers;
  for (const std::size_t i : order) {
    const TimedFlight& flight = flights[i];
    numbers = {flight.start, static_cast<double>(flight.trajectory->segments.size())};
    for (const Segment& segment : flight.trajectory->segments) {
      numbers.push_back(segment.duration);
      for (const Vec3& p : segment.point) numbers.insert(numbers.end(), p.begin(), p.end());
    }
    add_line(ids[i]);
    sum.update(std::as_bytes(std::span(numbers)));
  }
  return sum.hex();
}

}  // namespace traj
