#include "traj/files/own_formats.h"

#include "geom/text/beginning.h"

namespace traj::files {
namespace {

using geom::Format;
using Tools = std::string_view[];

constexpr Tools kShardTools = {"skyway-join", "skyway-info"};
constexpr Tools kMapTools = {
    "skyway-map",           "skyway-plan",  "skyway-replan", "skyway-lattice",
    "skyway-roadmap",       "skyway-traj",  "skyway-check",  "skyway-export",
    "skyway-fly",           "skyway-query", "skyway-plot",   "skyway-view",
    "skyway-render",        "skyway-bench", "skyway-info",   "skyway-import-trajectory",
    "skyway-import-flight", "skyway-fleet"};
constexpr Tools kRoadmapTools = {"skyway-plan", "skyway-replan", "skyway-roadmap", "skyway-bench",
                                 "skyway-info"};
constexpr Tools kLatticeTools = {"skyway-plan", "skyway-replan", "skyway-lattice", "skyway-bench",
                                 "skyway-view", "skyway-plot",   "skyway-info"};
constexpr Tools kGroundTools = {"skyway-map",    "skyway-plan", "skyway-check",
                                "skyway-submit", "skyway-view", "skyway-import-trajectory"};
constexpr Tools kPathTools = {"skyway-traj", "skyway-check", "skyway-replan",
                              "skyway-plot", "skyway-view",  "skyway-render",
                              "skyway-map",  "skyway-query", "skyway-info"};
constexpr Tools kTrajectoryTools = {"skyway-check", "skyway-export", "skyway-fly", "skyway-plot",
                                    "skyway-view",  "skyway-render", "skyway-map", "skyway-query",
                                    "skyway-fleet", "skyway-info"};
constexpr Tools kMovingTools = {"skyway-check", "skyway-fleet", "skyway-info"};
constexpr Tools kTreeTools = {"skyway-plot", "skyway-view", "skyway-render", "skyway-map",
                              "skyway-info"};
constexpr Tools kCorridorTools = {"skyway-view", "skyway-map", "skyway-info"};
constexpr Tools kReportTools = {"skyway-plot", "skyway-view", "skyway-info"};
constexpr Tools kContingencyTools = {"skyway-check", "skyway-plot", "skyway-view", "skyway-info"};
constexpr Tools kFlightTools = {"skyway-check", "skyway-export", "skyway-submit",
                                "skyway-view",  "skyway-plot",   "skyway-info"};
constexpr Tools kInfo = {"skyway-info"};
constexpr Tools kQueryTools = {"skyway-plan", "skyway-bench", "skyway-info"};
constexpr Tools kQueryTableTools = {"skyway-plan", "skyway-bench"};
constexpr Tools kLogTools = {"skyway-check", "skyway-plot", "skyway-view", "skyway-render",
                             "skyway-map"};
constexpr Tools kBenchmarkTools = {"skyway-plot"};

// A query needs no type; what has another type may have a "from", too.
bool begins_as_queries(std::string_view head) {
  const bool typed = geom::json_with<"\"type\":">(head) && !geom::json_of_type<"query">(head);
  return !typed && geom::json_with<"\"from\":[">(head);
}

}  // namespace

constinit const Format kShard{
    .what = "a shard", .begins = geom::archive_of<"skyway-shard">, .readers = kShardTools};
constinit const Format kBoxMap{
    .what = "a box map", .begins = geom::archive_of<"skyway-boxmap">, .readers = kMapTools};
constinit const Format kRoadmap{
    .what = "a roadmap", .begins = geom::archive_of<"skyway-roadmap">, .readers = kRoadmapTools};
constinit const Format kLattice{
    .what = "a lattice", .begins = geom::archive_of<"skyway-lattice">, .readers = kLatticeTools};

constinit const Format kGround{.what = "the ground of a map",
                               .begins = geom::archive_of<"skyway-ground">,
                               .readers = kGroundTools,
                               .advice = "give it with --ground-model"};

constinit const Format kPaths{
    .what = "a stream of paths", .begins = geom::json_of_type<"path">, .readers = kPathTools};
constinit const Format kTrajectories{.what = "a stream of trajectories",
                                     .begins = geom::json_of_type<"trajectory">,
                                     .readers = kTrajectoryTools};
constinit const Format kMoving{.what = "a stream of obstacles that move",
                               .begins = geom::json_of_type<"moving">,
                               .readers = kMovingTools};
constinit const Format kTrees{.what = "a stream with search trees",
                              .begins = geom::json_of_type<"tree">,
                              .readers = kTreeTools};
constinit const Format kCorridors{.what = "a stream of corridors",
                                  .begins = geom::json_of_type<"corridor">,
                                  .readers = kCorridorTools};
constinit const Format kCertificates{
    .what = "a stream of certificates",
    .begins =
        geom::any_of<geom::json_of_type<"certificate">, geom::json_of_type<"enclosure">,
                     geom::json_of_type<"bound">, geom::json_of_type<"apart">,
                     geom::json_of_type<"clear_of">, geom::json_of_type<"returns">,
                     geom::json_of_type<"contingencies">, geom::json_of_type<"tube_certificate">>,
    .readers = kInfo};
constinit const Format kReports{
    .what = "a stream of reports",
    .begins = geom::any_of<geom::json_of_type<"report">, geom::json_of_type<"pair">>,
    .readers = kReportTools};
constinit const Format kContingencies{.what = "a stream of ways home (contingencies)",
                                      .begins = geom::json_of_type<"contingency">,
                                      .readers = kContingencyTools};
constinit const Format kFlights{.what = "a stream of simulated flights",
                                .begins = geom::json_of_type<"flight">,
                                .readers = kFlightTools};
constinit const Format kAnswers{
    .what = "a stream of answers", .begins = geom::json_of_type<"answer">, .readers = kInfo};
constinit const Format kQueries{
    .what = "a stream of queries", .begins = begins_as_queries, .readers = kQueryTools};

constinit const Format kQueryTable{.what = "a table of queries",
                                   .begins = geom::text_begins_with<"id,from_x,">,
                                   .readers = kQueryTableTools};
constinit const Format kFlightLog{.what = "a flight log",
                                  .begins = geom::any_of<geom::text_begins_with<"id,t_s,east_m,">,
                                                         geom::text_begins_with<"id,t_s,x_m,">>,
                                  .readers = kLogTools};
constinit const Format kBenchmark{.what = "a report of skyway-bench",
                                  .begins = geom::json_of_type<"benchmark">,
                                  .readers = kBenchmarkTools};
constinit const Format kVehicleProfile{.what = "a vehicle profile",
                                       .begins = geom::json_with<"\"tilt_max_deg\":">,
                                       .advice = "give it with --vehicle"};

geom::Formats own_formats() {
  static constexpr const Format* kTable[] = {
      &kShard,        &kBoxMap,       &kRoadmap,       &kLattice,   &kGround,
      &kPaths,        &kTrajectories, &kMoving,        &kTrees,     &kCorridors,
      &kCertificates, &kReports,      &kContingencies, &kFlights,   &kAnswers,
      &kQueries,      &kQueryTable,   &kFlightLog,     &kBenchmark, &kVehicleProfile};
  return kTable;
}

}  // namespace traj::files
