// Loads a PLY file with PCL and says what is in it.

#include <pcl/PolygonMesh.h>
#include <pcl/io/ply_io.h>

#include <cstdio>

int main(int argc, char** argv) {
  pcl::PolygonMesh mesh;
  if (argc != 2 || pcl::io::loadPLYFile(argv[1], mesh) != 0) return 1;
  std::printf("%u vertices, %zu triangles\n", mesh.cloud.width * mesh.cloud.height,
              mesh.polygons.size());
}
