#include "degrees.h"

#include <fmt/format.h>

#include "cli/answer/exit.h"
#include "geom/collision/collision.h"
#include "geom/record/made_for_another.h"

namespace cli {

geom::Fault MetresOption::what_stood_there(const geom::Frame& frame, const geom::Vec3& p) const {
  return {.says = fmt::format("[{}, {}] look like degrees", p.x(), p.y()),
          .advice = fmt::format(
              "the map's origin is at latitude {}, longitude {}, and its coordinates are metres "
              "from there; give metres{}, or insist with --metres",
              frame.origin->latitude, frame.origin->longitude,
              takes_letters_ ? ", or degrees with letters (60.1719N,24.9414E,30)" : "")};
}

void MetresOption::add_to(CLI::App& app) {
  app.add_flag("--metres", insisted_,
               "coordinates are metres even if they look like the latitude and longitude of the "
               "map's origin");
}

void MetresOption::check_option(const geom::Frame& frame, std::span<const geom::Vec3> points,
                                const std::string& option) const {
  if (insisted_ || !geom::look_like_degrees(frame, points)) return;
  throw UsageError(option + ": " + sentence(what_stood_there(frame, points.front())));
}

void MetresOption::check_input(const geom::Frame& frame, std::span<const geom::Vec3> points,
                               const std::string& source, std::size_t line) const {
  if (insisted_ || !geom::look_like_degrees(frame, points)) return;
  throw geom::InputError(source, line, what_stood_there(frame, points.front()));
}

void MetresOption::check_queries(const geom::CollisionScene& scene,
                                 std::span<const geom::PlanQuery> queries,
                                 const std::string& source) const {
  const geom::Provenance ours = geom::provenance_of(scene);
  for (const geom::PlanQuery& query : queries) {
    check_input(scene.map().spec().frame, geom::ends_in_metres(query), source, query.line);
    geom::require_asked_of(query.asked_of, ours, source, query.line);
  }
}

void MetresOption::check_input(const geom::Frame& frame, const traj::Trajectory& trajectory,
                               const std::string& source, std::size_t line) const {
  for (const traj::Segment& s : trajectory.segments) {
    if (!geom::look_like_degrees(frame, s.point)) return;
  }
  if (!trajectory.segments.empty()) {
    check_input(frame, std::span(trajectory.segments[0].point), source, line);
  }
}

void MetresOption::check_input(const geom::Frame& frame, const traj::FlightLog& flight,
                               const std::string& source, std::size_t line) const {
  std::vector<geom::Vec3> points;
  for (const traj::FlightSample& sample : flight.samples) points.push_back(sample.position);
  check_input(frame, points, source, line);
}

void MetresOption::check_outline(const geom::Frame& frame, std::span<const geom::Vec3> corners,
                                 const std::string& source) const {
  check_input(frame, corners, source, 0);
  if (insisted_) return;
  const auto small = geom::may_be_degrees(corners);
  if (!small) return;
  const geom::Vec3 size = small->high - small->low;
  throw geom::InputError(
      source, {.expected = "a volume in metres",
               .found = fmt::format("one of {:.3g} by {:.3g} m about [{}, {}], which may be "
                                    "degrees; give metres, or insist with --metres",
                                    size.x(), size.y(), small->low.x(), small->low.y())});
}

}  // namespace cli
