#include "mission/airspace/window.h"

#include <gtest/gtest.h>

#include "curve/curve_piece.h"

namespace traj {
namespace {

// 8 m/s along x from 100, and back.
Trajectory there_and_back() {
  Trajectory out;
  for (const double from : {100.0, 116.0}) {
    Segment s;
    s.duration = 2;
    for (int i = 0; i < kPoints; ++i) {
      s.point[static_cast<std::size_t>(i)] = {from + (from > 110 ? -16.0 : 16.0) * i / kDegree, 0,
                                              5};
    }
    out.segments.push_back(s);
  }
  return out;
}

TEST(Window, HoldsWhatIsFlownInIt) {
  const Trajectory flight = there_and_back();
  const Timeline line(TimedFlight{&flight, 10, Vec3::Zero()});
  const Window window = window_of(line, 11, 12.5);
  ASSERT_EQ(window.stretches.size(), 2u);
  const auto& first = window.stretches[0].curve.q;
  EXPECT_NEAR((window.from + first.front()).x(), 108, 1e-12);
  EXPECT_NEAR((window.from + first.back()).x(), 116, 1e-12);
  EXPECT_NEAR((window.from + window.stretches[1].curve.q.back()).x(), 112, 1e-12);
  for (const Window::Stretch& stretch : window.stretches) EXPECT_LT(stretch.off, 1e-10);
}

TEST(Window, EndsWithTheFlight) {
  const Trajectory flight = there_and_back();
  const Timeline line(TimedFlight{&flight, 0, Vec3::Zero()});
  EXPECT_EQ(window_of(line, -5, -1).stretches.size(), 0u);
  EXPECT_EQ(window_of(line, -5, 1).stretches.size(), 1u);
  EXPECT_EQ(window_of(line, 3, 1e6).stretches.size(), 1u);
  // At an instant alone it is there, too.
  EXPECT_EQ(window_of(line, 4, 5).stretches.size(), 1u);
  EXPECT_EQ(window_of(line, -1e-10, 1e-10).stretches.size(), 1u);
}

}  // namespace
}  // namespace traj
