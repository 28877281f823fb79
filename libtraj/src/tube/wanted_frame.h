#pragma once

// Frames along a force: the body's, and the one that a controller's lift asks for.

#include "traj/flight/reference.h"
#include "tube/loop_state.h"

namespace traj {

// A frame whose z axis is along a force and whose x axis has a heading.
template <class S>
struct Frame {
  S size{};  // of the force
  Triple<S> x, y, z;
  Triple<S> left, ahead;  // of the heading, horizontal
  Triple<S> across;       // left x z
  S across_size{};
};

template <class S>
Frame<S> frame_along(const Triple<S>& force, const S& heading);

// The same along a vector of length 1.
template <class S>
Frame<S> frame_along_unit(const Triple<S>& z, const S& heading);

template <class S>
Triple<S> in_world(const Frame<S>& f, const Triple<S>& v) {
  return v.x * f.x + v.y * f.y + v.z * f.z;
}

// The lift, its frame, and the body rates that flatness gives for it.
template <class S>
struct Wanted {
  Triple<S> lift;
  Frame<S> frame;
  Triple<S> rates;
};

template <class S>
Wanted<S> wanted_at(const Triple<S>& lift, const Reference& reference);

// The same rates by fewer products: the frame's axes are at right angles.
template <class S>
Triple<S> rates_along(const Frame<S>& frame, const Reference& reference);

// The axes of the wanted frame of lift + change, seen from the wanted frame of lift, minus (1, 0,
// 0), (0, 1, 0) and (0, 0, 1).
template <class S>
struct FrameChange {
  Triple<S> x, y, z;
  Triple<S> lift;  // the change of the lift, seen from there
  S growth{};      // by how much its size grows
};

// All terms are small with `change`.
template <class S>
FrameChange<S> change_of(const Wanted<S>& wanted, const Triple<S>& change, double yaw,
                         double next_yaw);

}  // namespace traj
