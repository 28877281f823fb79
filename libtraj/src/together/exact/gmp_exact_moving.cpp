#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include "geom/base/error.h"
#include "gmp_line.h"
#include "together/judgeable.h"
#include "together/place_at.h"
#include "traj/together/exact/exact_moving.h"

namespace traj {
namespace {

using exact::Line;
using exact::Point;
using exact::Polynomial;
using exact::Scaled;
using exact::Whole;
using exact::whole;

constexpr unsigned kDeepest = 60;
constexpr std::size_t kMostPieces = 1u << 18;  // of a flight and a box

// How far the flight is beyond each of the six faces, grown by its room (in the order of
// kSides). Coefficients up to a positive factor; all > 0 is beyond.
using Beyond = std::array<Polynomial, 6>;

constexpr std::array<FaceSide, 6> kSides{
    {{0, true}, {0, false}, {1, true}, {1, false}, {2, true}, {2, false}}};

double seconds(const Whole& time) {
  long exponent = 0;
  const double mantissa = mpz_get_d_2exp(&exponent, time.get_mpz_t());
  return std::ldexp(mantissa, static_cast<int>(exponent) - static_cast<int>(exact::kUnit));
}

// A box that moves, in units of 2^-1074 of m, m/s and s.
struct Course {
  explicit Course(const MovingBox& b)
      : min(whole(b.box.min)),
        max(whole(b.box.max)),
        velocity(whole(b.velocity)),
        growth(whole(b.growth)),
        from(whole(b.from)),
        until(whole(b.until)) {}

  // The control points of a face from `begin` to `end`, times 2^1074 and times face_factor().
  Polynomial face(const FaceSide& side, const Whole& begin, const Whole& end) const {
    const auto axis = static_cast<std::size_t>(side.axis);
    const Whole speed =
        side.above ? Whole(velocity[axis] + growth[axis]) : Whole(velocity[axis] - growth[axis]);
    const Whole place = (side.above ? max[axis] : min[axis]) * face_factor();
    Polynomial out;
    for (unsigned i = 0; i < kPoints; ++i) {
      out.push_back(place + speed * (kDegree * (begin - from) + i * (end - begin)));
    }
    return out;
  }
  static Whole face_factor() { return Whole(kDegree) << exact::kUnit; }

  Point min;
  Point max;
  Point velocity;
  Point growth;
  Whole from;
  Whole until;
};

// A trailing zero bit that all coefficients have is worth nothing.
void shorten(Polynomial& q) {
  mp_bitcnt_t zeros = ~mp_bitcnt_t{0};
  for (const Whole& c : q) {
    if (c != 0) zeros = std::min(zeros, mpz_scan1(c.get_mpz_t(), 0));
  }
  for (Whole& c : q) {
    if (c != 0) c >>= zeros;
  }
}

struct Span {
  Whole begin;
  Whole end;
};

// The time in which both are there, cut at the flight's joints.
std::vector<Span> spans_of(const Line& line, const Course& course, Parked parked) {
  Whole first = course.from;
  Whole last = course.until;
  if (parked == Parked::gone) {
    first = std::max(first, line.joint.front());
    last = std::min(last, line.joint.back());
  }
  if (first > last) return {};
  if (first == last) return {{first, last}};
  std::vector<Span> out;
  Whole begin = first;
  for (const Whole& joint : line.joint) {
    if (joint <= first || joint >= last) continue;
    out.push_back({begin, joint});
    begin = joint;
  }
  out.push_back({begin, last});
  return out;
}

class MovingProof {
 public:
  MovingProof(const TimedFlight& flight, const MovingBox& box)
      : flight_(flight), line_(flight), course_(box), room_(whole(flight.room)) {}

  ExactMoving of(Parked parked) {
    for (const Span& span : spans_of(line_, course_, parked)) {
      result_.stretches.emplace_back();
      if (!fill(beyond(span), 0, seconds(span.begin), seconds(span.end))) {
        result_.place = place_at(flight_, result_.time);
        return result_;
      }
    }
    result_.clear = true;
    return result_;
  }

 private:
  Beyond beyond(const Span& span) const {
    const Scaled flown = exact::between(line_, span.begin, span.end);
    const Whole unit = Course::face_factor();
    Beyond out;
    for (std::size_t i = 0; i < kSides.size(); ++i) {
      const auto axis = static_cast<std::size_t>(kSides[i].axis);
      const Polynomial face = course_.face(kSides[i], span.begin, span.end);
      const Whole reach = (room_[axis] + line_.gap) * unit * flown.factor;
      for (std::size_t k = 0; k < kPoints; ++k) {
        const Whole off = flown.axes[axis][k] * unit - face[k] * flown.factor;
        out[i].push_back((kSides[i].above ? off : Whole(-off)) - reach);
      }
      shorten(out[i]);
    }
    return out;
  }

  static std::optional<FaceSide> side_of(const Beyond& beyond) {
    for (std::size_t i = 0; i < beyond.size(); ++i) {
      const auto above_zero = [](const Whole& c) { return c > 0; };
      if (std::all_of(beyond[i].begin(), beyond[i].end(), above_zero)) return kSides[i];
    }
    return std::nullopt;
  }

  // At an instant, whose coefficients these are, beyond no face.
  static bool touches(const Beyond& beyond, bool at_end) {
    return std::none_of(beyond.begin(), beyond.end(),
                        [&](const Polynomial& q) { return (at_end ? q.back() : q.front()) > 0; });
  }

  bool fill(const Beyond& beyond, unsigned depth, double begin, double end) {
    ++result_.pieces;
    MovingCover& cover = result_.stretches.back();
    if (const auto side = side_of(beyond)) {
      cover.pieces.push_back(static_cast<std::uint8_t>(depth));
      cover.sides.push_back(*side);
      return true;
    }
    const bool at_begin = touches(beyond, false);
    const bool touching = at_begin || touches(beyond, true);
    if (touching || depth == kDeepest || result_.pieces >= kMostPieces) {
      result_.undecided = !touching;
      result_.time = at_begin || !touching ? begin : end;
      return false;
    }
    Beyond left;
    Beyond right;
    for (std::size_t i = 0; i < beyond.size(); ++i) {
      std::tie(left[i], right[i]) = exact::halves(beyond[i]);
    }
    const double middle = begin + (end - begin) / 2;
    return fill(left, depth + 1, begin, middle) && fill(right, depth + 1, middle, end);
  }

  const TimedFlight& flight_;
  Line line_;
  Course course_;
  Point room_;
  ExactMoving result_;
};

}  // namespace

ExactMoving check_moving_exactly(const TimedFlight& flight, const MovingBox& box, Parked parked) {
  if (auto fault = moving_box_fault(box)) throw geom::InputError("obstacle", *std::move(fault));
  require_judgeable(flight);
  return MovingProof(flight, box).of(parked);
}

}  // namespace traj
