// read_pcl FILE: reads a PCD file by PCL alone, and says how many points it has: the peer of
// skyway-cloud in source_growth.py.

#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <iostream>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  pcl::PointCloud<pcl::PointXYZ> cloud;
  if (pcl::io::loadPCDFile(argv[1], cloud) != 0) return 3;
  std::cout << cloud.size() << '\n';
  return 0;
}
