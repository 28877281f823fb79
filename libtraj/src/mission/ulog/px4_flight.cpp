#include "traj/mission/ulog/px4_flight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "geom/base/error.h"
#include "geom/map/geodetic_outline.h"
#include "mission/ulog/px4_state.h"
#include "traj/mission/ulog/px4_projection.h"

namespace traj {
namespace {

using geom::GeodeticPlace;
using geom::Vec3;

constexpr std::array<std::string_view, 9> kTopics = {
    "vehicle_local_position",   "vehicle_global_position", "vehicle_attitude",
    "vehicle_angular_velocity", "trajectory_setpoint",     "vehicle_local_position_setpoint",
    "battery_status",           "actuator_motors",         "vehicle_land_detected"};

constexpr double kLatest = 1e9;                // s: what a flight log may hold
constexpr std::uint64_t kSetBack = 1'000'000;  // microseconds by which a clock was set back
constexpr std::uint64_t kSilent = 1'000'000;   // microseconds from which on positions are missing
constexpr double kMoves = 0.5;    // m/s: more than an estimate of a vehicle that stands
constexpr double kCorrected = 1;  // m by which places in the air may be corrected
constexpr double kStanding = 10;  // s before a take-off in which the vehicle stood on the ground

Vec3 enu_of(const Vec3& ned) { return {ned.y(), ned.x(), -ned.z()}; }

// PX4's yaw, clockwise from north, as one from east: radians in (-pi, pi].
double yaw_of(double from_north) {
  return std::remainder(std::numbers::pi / 2 - from_north, 2 * std::numbers::pi);
}

// Turns the body axes of a flight log (x forward, y left, z up) into east, north, up.
Eigen::Quaterniond attitude_of(const Eigen::Quaterniond& px4) {
  const double half = std::sqrt(0.5);
  const Eigen::Quaterniond to_enu(0, half, half, 0);  // exchanges north and east, down becomes up
  const Eigen::Quaterniond from_flu(0, 1, 0, 0);      // half a turn about x
  return to_enu * px4 * from_flu;
}

// Of the two quaternions that say the same, the one with w >= 0.
Eigen::Quaterniond upright(const Eigen::Quaterniond& q) {
  Eigen::Quaterniond out = q.normalized();
  if (out.w() < 0) out.coeffs() *= -1;
  return out;
}

double seconds(std::uint64_t microseconds) { return static_cast<double>(microseconds) / 1e6; }

// One of the two kinds of places that a log knows.
struct Position {
  std::uint64_t time = 0;
  Vec3 ned = Vec3::Zero();                      // m from the reference
  std::optional<Vec3> velocity;                 // m/s north, east, down
  std::optional<GeodeticPlace> reference;       // height above the sea
  std::array<std::optional<double>, 2> resets;  // counters, across and up
  bool local = true;                            // whether setpoints count from the same reference
};

// Where the samples are: in the axes of the map, or about the log's own reference.
class Placing {
 public:
  explicit Placing(const MissionFrame& over) : frame_(over), earth_(over.origin) {}

  // East, north, up of a point near a reference, by its local coordinates.
  Vec3 at(const GeodeticPlace& reference, const Vec3& ned) const {
    GeodeticPlace place = px4_place(reference, ned.x(), ned.y());
    place.height += frame_.sea_level(place.latitude, place.longitude) - ned.z();
    return earth_.enu(place);
  }

  // How far the local north is turned there from the map's, clockwise: radians.
  double turn(const GeodeticPlace& reference, const Vec3& ned) const {
    constexpr double kStep = 10;  // m: long against rounding, short against the Earth
    const Vec3 way =
        at(reference, ned + Vec3(kStep, 0, 0)) - at(reference, ned - Vec3(kStep, 0, 0));
    return std::atan2(way.x(), way.y());
  }

  bool is_near(const GeodeticPlace& reference) const {
    return geom::is_near(frame_.origin, reference.latitude, reference.longitude);
  }

 private:
  MissionFrame frame_;
  geom::GeographicFrame earth_;
};

// The samples by the positions of one topic.
class Track {
 public:
  explicit Track(const Px4Options& options) {
    if (options.over) placing_ = std::make_unique<Placing>(*options.over);
    asked_ = options.over.has_value();
  }

  void skip() {
    ++positions_;
    leave_out(not_known_);
  }

  void add(const Position& position, const Px4State& state, bool stands) {
    ++positions_;
    if (!known_on_map(position)) return leave_out(nowhere_);
    if (samples_.empty()) {
      left_out_at_begin_ = left_out_since_;
      begin(position);
    } else if (!goes_on(position.time)) {
      return leave_out(back_);
    }
    FlightSample sample = sample_of(position, state);
    sample.time = seconds(position.time - first_);
    count_reset(position, sample, stands);
    last_ = position.time;
    left_out_since_ = 0;
    samples_.push_back(sample);
  }

  bool empty() const { return samples_.empty(); }
  std::size_t positions() const { return positions_; }
  std::uint64_t first() const { return first_; }
  std::uint64_t last() const { return last_; }
  std::size_t left_out_at_begin() const { return left_out_at_begin_; }
  bool begins_moving() const { return moves(samples_.front()); }
  bool ends_moving() const { return moves(samples_.back()); }

  void give(Px4Flight& out) && {
    out.log.samples = std::move(samples_);
    out.positions = positions_;
    out.not_known = not_known_;
    out.nowhere = nowhere_;
    out.back = back_;
    out.left_out_at_begin = left_out_at_begin_;
    out.left_out_at_end = left_out_since_;
    out.reference = reference_;
    out.resets = resets_;
    out.largest_reset = largest_reset_;
    out.largest_reset_in_air = largest_reset_in_air_;
    out.corrected_in_air = largest_reset_in_air_ > kCorrected;
  }

 private:
  void leave_out(std::size_t& why) { ++why, ++left_out_since_; }

  static bool moves(const FlightSample& sample) { return sample.velocity.norm() > kMoves; }

  // Whether the time grows. Where a clock was set back, later times say nothing about how long
  // after the last row they are.
  bool goes_on(std::uint64_t time) {
    set_back_ = set_back_ || time + kSetBack < last_;
    return !set_back_ && time > last_ && seconds(time - first_) <= kLatest;
  }

  bool known_on_map(const Position& position) const {
    if (!placing_) return true;
    return position.reference && placing_->is_near(*position.reference);
  }

  void begin(const Position& position) {
    first_ = position.time;
    reference_ = position.reference;
    if (asked_ || !reference_) return;
    placing_ = std::make_unique<Placing>(MissionFrame{*reference_, 0});
  }

  Vec3 place(const Position& position, const Vec3& ned) const {
    return placing_ ? placing_->at(*position.reference, ned) : enu_of(ned);
  }

  FlightSample sample_of(const Position& position, const Px4State& state) const {
    const double turn = placing_ ? placing_->turn(*position.reference, position.ned) : 0;
    const Eigen::Quaterniond turned(Eigen::AngleAxisd(-turn, Vec3::UnitZ()));
    FlightSample out = nothing_known();
    out.position = place(position, position.ned);
    if (position.velocity) out.velocity = turned * enu_of(*position.velocity);
    if (const auto q = state.attitude.at(position.time))
      out.attitude = upright(turned * attitude_of(*q));
    if (const auto rates = state.body_rates.at(position.time)) {
      out.body_rates = {rates->x(), -rates->y(), -rates->z()};
    }
    if (const auto motors = state.motors.at(position.time)) out.motors = *motors;
    if (const auto share = state.battery.at(position.time)) out.battery = *share;
    const auto asked = state.setpoint.at(position.time);
    const auto local = state.local_setpoint.at(position.time);
    add_setpoint(position, asked && asked->position ? asked : local ? local : asked, turned, out);
    return out;
  }

  void add_setpoint(const Position& position, const std::optional<Px4Setpoint>& setpoint,
                    const Eigen::Quaterniond& turned, FlightSample& out) const {
    if (!setpoint) return;
    if (setpoint->position && position.local)
      out.setpoint_position = place(position, *setpoint->position);
    if (setpoint->velocity) out.setpoint_velocity = turned * enu_of(*setpoint->velocity);
    if (!setpoint->yaw) return;
    const Vec3 heading =
        turned * Vec3(std::cos(yaw_of(*setpoint->yaw)), std::sin(yaw_of(*setpoint->yaw)), 0);
    out.setpoint_yaw = std::atan2(heading.y(), heading.x());
  }

  void count_reset(const Position& position, const FlightSample& sample, bool stands) {
    if (!samples_.empty() && (position.resets != counters_ || moved_reference(position))) {
      const double step = step_of(samples_.back(), sample);
      ++resets_;
      largest_reset_ = std::max(largest_reset_, step);
      if (!stands) largest_reset_in_air_ = std::max(largest_reset_in_air_, step);
    }
    counters_ = position.resets;
    last_reference_ = position.reference;
  }

  // Whether its local coordinates count from elsewhere than those before.
  bool moved_reference(const Position& position) const {
    return placing_ && position.local && position.reference != last_reference_;
  }

  // What the estimate moved beside what the vehicle flew, as far as its velocity is known.
  static double step_of(const FlightSample& before, const FlightSample& after) {
    Vec3 step = after.position - before.position;
    if (is_known(before.velocity)) step -= before.velocity * (after.time - before.time);
    return step.norm();
  }

  std::unique_ptr<Placing> placing_;  // none: local coordinates as they are
  bool asked_ = false;
  std::vector<FlightSample> samples_;
  std::uint64_t first_ = 0;
  std::uint64_t last_ = 0;
  std::size_t positions_ = 0;
  std::size_t not_known_ = 0;
  std::size_t nowhere_ = 0;
  std::size_t back_ = 0;
  std::size_t left_out_at_begin_ = 0;
  std::size_t left_out_since_ = 0;  // the last row
  bool set_back_ = false;
  std::optional<GeodeticPlace> reference_;  // the first
  std::optional<GeodeticPlace> last_reference_;
  std::array<std::optional<double>, 2> counters_;
  std::size_t resets_ = 0;
  double largest_reset_ = 0;
  double largest_reset_in_air_ = 0;
};

bool on_earth(double latitude, double longitude) {
  return std::abs(latitude) <= 90 && std::abs(longitude) <= 180;
}

// Where the vehicle says that its local coordinates count from; nothing where it does not know.
std::optional<GeodeticPlace> reference_of(const UlogMessage& message) {
  if (!message.flag("xy_global").value_or(false) || !message.flag("z_global").value_or(false)) {
    return std::nullopt;
  }
  const auto v = vector_of(message, "ref_lat", "ref_lon", "ref_alt");
  if (!v || !on_earth(v->x(), v->y())) return std::nullopt;
  return GeodeticPlace{v->x(), v->y(), v->z()};
}

std::optional<Position> local_position(const UlogMessage& message) {
  const auto at = vector_of(message, "x", "y", "z");
  const bool valid =
      message.flag("xy_valid").value_or(false) && message.flag("z_valid").value_or(false);
  if (!at || !valid) return std::nullopt;
  Position out{message.timestamp(), *at, {}, reference_of(message), {}, true};
  if (message.flag("v_xy_valid").value_or(false) && message.flag("v_z_valid").value_or(false)) {
    out.velocity = vector_of(message, "vx", "vy", "vz");
  }
  out.resets = {message.number("xy_reset_counter"), message.number("z_reset_counter")};
  return out;
}

// The place is its own reference.
std::optional<Position> global_position(const UlogMessage& message) {
  const auto at = vector_of(message, "lat", "lon", "alt");
  const bool valid = message.flag("lat_lon_valid").value_or(true) &&  // since PX4 1.15
                     message.flag("alt_valid").value_or(true);
  if (!at || !valid || !on_earth(at->x(), at->y())) return std::nullopt;
  Position out{
      message.timestamp(), Vec3::Zero(), {}, GeodeticPlace{at->x(), at->y(), at->z()}, {}, false};
  out.velocity = vector_of(message, "vel_n", "vel_e", "vel_d");  // to PX4 1.10
  out.resets = {message.number("lat_lon_reset_counter"), message.number("alt_reset_counter")};
  return out;
}

class Collector {
 public:
  explicit Collector(const Px4Options& options) : local_(options), global_(options) {}

  void take(const UlogMessage& message) {
    state_.take(message);
    last_heard_ = std::max(last_heard_, message.timestamp());
    if (message.topic() == "vehicle_local_position") {
      add(local_, local_position(message));
      note_largest(message.number("eph"), out_.deviation);
      note_largest(message.number("epv"), out_.vertical_deviation);
    } else if (message.topic() == "vehicle_global_position") {
      add(global_, global_position(message));
      note_sea_level(message.number("alt_ellipsoid"), message.number("alt"));
    } else if (message.topic() == "vehicle_land_detected") {
      note_takeoff(message);
    }
  }

  Px4Flight finish(UlogSummary summary) && {
    out_.summary = std::move(summary);
    const bool global =
        local_.empty() && global_.positions() > 0 && (!global_.empty() || local_.positions() == 0);
    out_.topic = global ? "vehicle_global_position" : "vehicle_local_position";
    Track& track = global ? global_ : local_;
    if (takeoff_ && !track.empty() && *takeoff_ >= track.first()) {
      out_.takeoff = seconds(*takeoff_ - track.first());
    }
    if (!track.empty()) {
      out_.begins_in_air = begins_in_air(track);
      out_.ends_silent = last_heard_ > track.last() + kSilent;
      out_.ends_in_air = knows_landed_ ? !stood_ && !touches_ : track.ends_moving();
      out_.tells_landed = knows_landed_;
    }
    std::move(track).give(out_);
    out_.log.cut = out_.summary.cut_at.has_value() || out_.left_out_at_end > 0 ||
                   out_.begins_in_air || out_.ends_silent || out_.ends_in_air ||
                   out_.corrected_in_air;
    return std::move(out_);
  }

 private:
  void add(Track& track, const std::optional<Position>& position) {
    position ? track.add(*position, state_, knows_landed_ && stood_) : track.skip();
  }

  static void note_largest(std::optional<double> value, std::optional<double>& largest) {
    if (value) largest = std::max(largest.value_or(0), *value);
  }

  void note_sea_level(std::optional<double> ellipsoid, std::optional<double> sea) {
    if (out_.sea_level || !ellipsoid || !sea || *ellipsoid == *sea || *ellipsoid == 0) return;
    out_.sea_level = *ellipsoid - *sea;
  }

  void note_takeoff(const UlogMessage& message) {
    const auto landed = message.flag("landed");
    if (!landed) return;
    if (!*landed && !in_air_) in_air_ = knows_landed_ ? message.timestamp() : 0;
    if (stood_ && !*landed && !takeoff_) takeoff_ = message.timestamp();
    stood_ = *landed;
    touches_ = message.flag("ground_contact").value_or(false) ||
               message.flag("maybe_landed").value_or(false);
    knows_landed_ = true;
  }

  // Where nothing says whether it flew, it may have done so where positions are left out, and it
  // did where it moves.
  bool begins_in_air(const Track& track) const {
    if (in_air_) return *in_air_ <= track.first();
    return !knows_landed_ && (track.left_out_at_begin() > 0 || track.begins_moving());
  }

  Px4State state_;
  Track local_;
  Track global_;
  std::uint64_t last_heard_ = 0;  // of any topic
  bool stood_ = false;
  bool touches_ = false;  // the ground, and is about to be held for landed
  bool knows_landed_ = false;
  std::optional<std::uint64_t> in_air_;  // since when at first, 0: since before the log
  std::optional<std::uint64_t> takeoff_;
  Px4Flight out_;
};

}  // namespace

Px4Flight read_px4_flight(std::istream& in, std::string_view source, const Px4Options& options) {
  Collector collector(options);
  UlogSummary summary =
      read_ulog(in, source, kTopics, [&](const UlogMessage& message) { collector.take(message); });
  return std::move(collector).finish(std::move(summary));
}

double take_off_from(double ground, Px4Flight& flight, std::string_view source) {
  std::vector<FlightSample>& samples = flight.log.samples;
  const auto after = std::find_if(samples.begin(), samples.end(), [&](const FlightSample& s) {
    return s.time > flight.takeoff.value_or(-1);
  });
  if (after == samples.begin()) {
    throw geom::InputError(
        source,
        {.expected =
             "a take-off after the first position, from whose ground the heights would count",
         .found = "none"});
  }
  // That it has taken off is noticed when it is in the air.
  double was = std::prev(after)->position.z();
  for (auto s = samples.begin(); s != after; ++s) {
    if (s->time >= *flight.takeoff - kStanding) was = std::min(was, s->position.z());
  }
  for (FlightSample& s : samples) {
    s.position.z() += ground - was;
    s.setpoint_position.z() += ground - was;  // NaN stays
  }
  return was;
}

bool begin_at(double begin, Px4Flight& flight) {
  std::vector<FlightSample>& samples = flight.log.samples;
  const auto left_out =
      std::erase_if(samples, [&](const FlightSample& s) { return s.time < begin; });
  const bool in_air = left_out > 0 && !(flight.takeoff && begin <= *flight.takeoff);
  flight.log.cut = flight.log.cut || in_air;
  for (FlightSample& s : samples) s.time -= begin;
  if (flight.takeoff) *flight.takeoff -= begin;
  if (flight.takeoff && *flight.takeoff < 0) flight.takeoff.reset();
  return in_air;
}

}  // namespace traj
