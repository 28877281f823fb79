#pragma once

// Files that no tool reads as obstacles, missions or records, and what to do about them.
//
// Example:
//   const geom::Format* bag = geom::recognise("#ROSBAG V2.0", traj::files::foreign_formats());
//   assert(bag->what == "a ROS bag" && bag->readers.empty());
//   std::cout << bag->advice;

#include "geom/base/format.h"

namespace traj::files {

// More telling ones first: any XML and any ZIP archive come last.
geom::Formats foreign_formats();

extern const geom::Format kFenceText;  // fences or rally points in Mission Planner's words
extern const geom::Format kZip;        // a ZIP archive that nothing more is known of
extern const geom::Format kPx4Log;

}  // namespace traj::files
