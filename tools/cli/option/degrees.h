#pragma once

// Latitudes and longitudes that were given where metres are expected.

#include <CLI/CLI.hpp>
#include <span>
#include <string>
#include <vector>

#include "geom/base/error.h"
#include "geom/map/degrees.h"
#include "geom/record/query_record.h"
#include "traj/curve/trajectory.h"
#include "traj/flight/flight_log.h"

namespace cli {

class MetresOption {
 public:
  // Whether the points may also be degrees with letters (geom::parse_place).
  explicit MetresOption(bool takes_letters = false) : takes_letters_(takes_letters) {}

  void add_to(CLI::App& app);  // --metres: insist

  // Throw cli::UsageError, and geom::InputError(source, line, …), where points look like degrees.
  void check_option(const geom::Frame& frame, std::span<const geom::Vec3> points,
                    const std::string& option) const;
  void check_input(const geom::Frame& frame, std::span<const geom::Vec3> points,
                   const std::string& source, std::size_t line) const;

  // And where a query says another map, frame, vehicle or margin than the scene's.
  void check_queries(const geom::CollisionScene& scene, std::span<const geom::PlanQuery> queries,
                     const std::string& source) const;

  void check_input(const geom::Frame& frame, const traj::Trajectory& trajectory,
                   const std::string& source, std::size_t line) const;
  void check_input(const geom::Frame& frame, const traj::FlightLog& flight,
                   const std::string& source, std::size_t line) const;

  // Of one volume, whose corners may also be degrees where nobody knows the frame's origin: those
  // of a volume less than 2 m across, none of whose numbers is whole. `source` names it.
  void check_outline(const geom::Frame& frame, std::span<const geom::Vec3> corners,
                     const std::string& source) const;

 private:
  geom::Fault what_stood_there(const geom::Frame& frame, const geom::Vec3& p) const;

  bool takes_letters_;
  bool insisted_ = false;
};

}  // namespace cli
