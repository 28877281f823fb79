#pragma once

// The queries of a benchmark: a given list, or drawn one after another.
//
// Example:
//   plan::bench::QuerySet queries(scene, {.ends = plan::bench::Ends::uniform, .seed = 7});
//   assert(queries.at(2).from == queries.at(2).from && scene.free(queries.at(2).from));

#include <cstdint>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "geom/collision/collision.h"
#include "geom/record/query_record.h"
#include "geom/text/words.h"

namespace plan::bench {

enum class Ends {
  uniform,        // anywhere in free space
  street,         // both within 30 m of the floor
  street_blocked  // and the straight line between them blocked
};

inline constexpr geom::Words<Ends, 3> kEndsWords{{
    {Ends::uniform, "uniform"},
    {Ends::street, "street"},
    {Ends::street_blocked, "street-blocked"},
}};

struct RandomSpec {
  Ends ends = Ends::uniform;
  std::optional<std::pair<double, double>> length;  // metres between the ends, least and most
  std::uint64_t seed = 0;
};

// Draws that became no query, by why.
struct Rejected {
  std::size_t outside = 0;    // the goal outside the bounds, or too high
  std::size_t blocked = 0;    // an end touches an obstacle
  std::size_t line_free = 0;  // of street_blocked
};

// The i-th query is the same whatever was asked for before. The scene must outlive it.
class QuerySet {
 public:
  explicit QuerySet(std::vector<geom::PlanQuery> given) : queries_(std::move(given)) {}
  QuerySet(const geom::CollisionScene& scene, const RandomSpec& spec);

  // The start is uniform in the free part of the region; so is the goal or, where a length is
  // asked for, its length and direction are. Throws InputError where a million draws in a row
  // became no query.
  const geom::PlanQuery& at(std::size_t i);

  std::optional<std::size_t> size() const;  // nothing: as many as are asked for
  const Rejected& rejected() const { return rejected_; }

 private:
  bool draw(geom::PlanQuery& query);
  double uniform(double low, double high);
  geom::Vec3 point_in_region();
  geom::Vec3 goal_from(const geom::Vec3& start);

  const geom::CollisionScene* scene_ = nullptr;  // of random queries
  RandomSpec spec_;
  geom::Aabb region_{};
  std::mt19937_64 generator_;
  std::vector<geom::PlanQuery> queries_;
  Rejected rejected_;
};

}  // namespace plan::bench
