#pragma once

// Gazebo worlds: SDFormat 1.4 to 1.12 (sdformat.org), read from the text.
//
// Example:
//   std::istringstream in(R"(<sdf version="1.7"><world name="yard"><model name="crate">
//     <static>1</static><pose>0 0 1 0 0 0</pose><link name="body"><collision name="box">
//     <geometry><box><size>2 2 2</size></box></geometry>
//     </collision></link></model></world></sdf>)");
//   const geom::SdfWorld world = geom::read_sdf_world(in, "yard.sdf", {});
//   assert(world.table.boxes[0] == (geom::Aabb{{-1, -1, 0}, {1, 1, 2}}));

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "geom/base/skipped.h"
#include "geom/map/box_table.h"
#include "geom/map/frame.h"
#include "geom/model/model.h"

namespace geom {

struct SdfFile {
  std::string name;  // for messages, and what its own URIs are relative to
  std::string text;
};

// The file that a URI names, which stands in the file `from`: null where there is none. It must
// live as long as the reading.
using OpenSdfFile = std::function<const SdfFile*(const std::string& uri, const std::string& from)>;

// The triangles of a COLLADA file as its nodes place them, z up, in metres; what is not read is
// skipped. Throws InputError(file.name, …).
using ReadCollada = std::function<Model(const SdfFile& file)>;

struct SdfOptions {
  double slack = 0.1;             // metres that boxes may reach outside turned or round shapes
  bool visuals = true;            // <visual> shapes are obstacles too, like <collision> shapes
  std::set<std::string> without;  // names of models of the world that are left out
  OpenSdfFile open;               // the model of an <include>; empty: every one is missing
  OpenSdfFile open_mesh;          // the triangles of a <mesh>; empty: every one is missing
  ReadCollada read_collada;       // empty: COLLADA meshes are skipped
};

struct SdfWorld {
  BoxTable table;  // ids count the links from 0; labels: names of models, "a::b" nested
  Frame frame;     // ENU; the origin where there are <spherical_coordinates>
  std::optional<double> floor;  // the highest level plane that collides
  std::optional<Aabb> bounds;   // of a world that skyway-map wrote
  Skipped skipped;
  std::size_t flat = 0;            // boxes without extent along one or two axes: kept
  std::size_t movable = 0;         // models that are not static: taken where they stand
  std::set<std::string> left_out;  // of `without`, those that were there
};

// Of every link all <collision> and, unless they are off, all <visual>: box, cylinder, cone,
// sphere, ellipsoid, capsule, polyline. Where poses only move, and turn by quarters exactly
// (in degrees or quaternions), a box is the sum of its numbers rounded outward once; what else is
// turned or round is covered by boxes. What a link shows and collides with as the same boxes is
// there once. A level plane that collides and faces up is the floor; a visual plane is the
// rectangle that it is, and none where it lies on the floor or below. Where there is nothing else,
// the planes of the floor are flat boxes of their <size>.
//
// A <mesh> is an OBJ, STL or COLLADA file, by its ending. Numbers of OBJ and STL are metres with z
// up, as simulators take them. Of COLLADA those are read that all simulators show alike, in the
// file's own <unit>: its <up_axis> is Z_UP, nothing moves, and each node and geometry is placed in
// a way that none misreads (src/import/sdf/sdf_collada.h); the rest is skipped. All are scaled,
// turned and moved. Closed surfaces are solid, as a box is, and the rest is a shell; both are
// covered within the slack. Skipped are glTF, whose axes simulators turn in different ways, parts
// of meshes (<submesh>), and convex shapes made of them (`optimization`).
//
// Poses are relative as SDFormat says: to links, joints, frames, nested models, placement frames.
// No pose is no move. Lights, physics, plugins and materials are no obstacles. Skipped are actors,
// roads, populations, heightmaps, images, other meshes, other planes, files that are not found,
// models that a <state> has moved, and elements that are not known. Throws InputError(source, line,
// …) for what is not such a file, for two worlds in one, includes and frames that lead back to
// themselves, names that are not there, numbers that are none, more than 20 million boxes, and what
// read_obj(), read_stl() and `read_collada` refuse.
SdfWorld read_sdf_world(std::istream& in, std::string_view source, const SdfOptions& options);

struct BoxFormat;
extern const BoxFormat kGazeboWorld;  // of box_formats()

}  // namespace geom
