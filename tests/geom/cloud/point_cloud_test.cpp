#include "geom/cloud/point_cloud.h"

#include <gtest/gtest.h>
#include <liblzf/lzf.h>

#include <cstring>
#include <sstream>

#include "geom/base/error.h"
#include "geom/text/text_table.h"
#include "support/reading.h"

namespace geom {
namespace {

std::vector<Vec3> read_as_pcd(const std::string& bytes) {
  std::istringstream in(bytes);
  std::vector<Vec3> out;
  read_pcd(in, "test.pcd", [&](std::span<const CloudPoint> chunk) {
    for (const CloudPoint& p : chunk) out.push_back(p.position);
  });
  return out;
}

std::string header(const std::string& data, int points) {
  return "# .PCD v0.7\nVERSION 0.7\nFIELDS intensity x y z\nSIZE 2 8 8 8\nTYPE U F F F\nCOUNT 1 1 "
         "1 1\n"
         "WIDTH " +
         std::to_string(points) + "\nHEIGHT 1\nPOINTS " + std::to_string(points) + "\nDATA " +
         data + "\n";
}

void append(std::string& out, const auto& value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

// Points at UTM coordinates, a quarter of a millimetre apart: single precision would lose them.
Vec3 point(int i) { return {500000.1 + i * 0.00025, 5400000.2 - i * 0.00025, 100.5 + i}; }

TEST(Pcd, BinaryLosesNothing) {
  std::string bytes = header("binary", 50000);
  for (int i = 0; i < 50000; ++i) {
    append(bytes, static_cast<std::uint16_t>(i));
    for (int k = 0; k < 3; ++k) append(bytes, point(i)[k]);
  }
  const auto points = read_as_pcd(bytes);
  ASSERT_EQ(points.size(), 50000u);
  for (int i = 0; i < 50000; ++i) ASSERT_EQ(points[static_cast<std::size_t>(i)], point(i));
}

std::string compressed(int count) {
  std::string fields;
  for (int i = 0; i < count; ++i) append(fields, static_cast<std::uint16_t>(i));
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < count; ++i) append(fields, point(i)[k]);
  }
  std::string packed(2 * fields.size(), '\0');
  packed.resize(lzf_compress(fields.data(), static_cast<unsigned>(fields.size()), packed.data(),
                             static_cast<unsigned>(packed.size())));
  std::string bytes = header("binary_compressed", count);
  append(bytes, static_cast<std::uint32_t>(packed.size()));
  append(bytes, static_cast<std::uint32_t>(fields.size()));
  return bytes + packed;
}

TEST(Pcd, CompressedLosesNothing) {
  const auto points = read_as_pcd(compressed(1000));
  ASSERT_EQ(points.size(), 1000u);
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(points[static_cast<std::size_t>(i)], point(i));
}

TEST(Pcd, RefusesCompressedDataThatAreDamagedOrShort) {
  std::string bytes = compressed(1000);
  EXPECT_THROW(read_as_pcd(bytes.substr(0, bytes.size() - 5)), InputError);
  for (std::size_t i = bytes.size() - 200; i < bytes.size(); ++i) bytes[i] = '\xff';
  EXPECT_THROW(read_as_pcd(bytes), InputError);
}

// PCL maps a page and the data, or whole pages, and leaves zeros behind what it writes.
TEST(Pcd, PassesOverTheZerosOfPclsPages) {
  std::string binary = header("binary", 100);
  for (int i = 0; i < 100; ++i) {
    append(binary, static_cast<std::uint16_t>(i));
    for (int k = 0; k < 3; ++k) append(binary, point(i)[k]);
  }
  for (const std::string& bytes : {binary, compressed(1000)}) {
    const std::size_t head = bytes.find('\n', bytes.find("DATA")) + 1;
    const std::string page = bytes + std::string(4096 - head, '\0');
    const std::string to_page = bytes + std::string(4096 - bytes.size() % 4096, '\0');
    EXPECT_EQ(read_as_pcd(page).size(), read_as_pcd(bytes).size());
    EXPECT_EQ(read_as_pcd(to_page).size(), read_as_pcd(bytes).size());
    EXPECT_THROW(read_as_pcd(bytes + std::string(52, '\0')), InputError) << "two points at 0";
    std::string other = to_page;
    other.back() = 'x';
    EXPECT_THROW(read_as_pcd(other), InputError);
  }
}

TEST(Pcd, RefusesWhatItsHeaderSaysTwice) {
  const std::string rest = "\nSIZE 4 4 4 4\nTYPE F F F F\nWIDTH 1\nHEIGHT 1\nDATA ascii\n1 2 3 4\n";
  EXPECT_EQ(read_as_pcd("FIELDS x y z w" + rest)[0], Vec3(1, 2, 3));
  EXPECT_THROW(read_as_pcd("FIELDS x y z x" + rest), InputError);
  EXPECT_THROW(read_as_pcd("FIELDS x y z X" + rest), InputError);
  EXPECT_THROW(read_as_pcd("FIELDS x y z w\nFIELDS w x y z" + rest), InputError);
}

TEST(Pcd, RefusesARecordOfMegabytesBeforeTakingMemory) {
  EXPECT_THROW(read_as_pcd("FIELDS x y z pad\nSIZE 4 4 4 8\nTYPE F F F F\nCOUNT 1 1 1 1000000\n"
                           "WIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA binary\n"),
               InputError);
}

TEST(Ply, RefusesAListOfNotANumberEntries) {
  std::istringstream in(
      "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int v\nelement vertex 1\n"
      "property float x\nproperty float y\nproperty float z\nend_header\nnan\n1 2 3\n");
  EXPECT_THROW(read_ply(in, "test.ply", [](std::span<const CloudPoint>) {}), InputError);
}

std::string ply_refusal(const std::string& head, const std::string& rows) {
  return support::refusal_of([&] {
    std::istringstream in("ply\nformat ascii 1.0\nelement vertex 2\n" + head + "end_header\n" +
                          rows);
    read_ply(in, "test.ply", [](std::span<const CloudPoint>) {});
  });
}

// A number too many in one row and one too few in the next: all are there, and no point is where it
// should be.
TEST(Ply, RefusesRowsOfOtherLengthsThanTheirHeaderSays) {
  const std::string head = "property float x\nproperty float y\nproperty float z\n";
  EXPECT_EQ(ply_refusal(head, "1 2 3 \r\n\n4 5 6"), "");
  EXPECT_EQ(
      ply_refusal(head, "1 2 3 99\n5 6\n"),
      "test.ply:7: vertex 0: expected the line to end after 3 numbers, found \"99\" after it");
  EXPECT_NE(ply_refusal(head, "1 2\n3 4 5 6\n"), "");
}

TEST(Ply, RefusesAHeaderLineThatItDoesNotUnderstand) {
  const std::string head = "property float x\nproperty float y\n";
  EXPECT_NE(ply_refusal(head + "proprety float z\n", "1 2 3\n4 5 6\n"), "");
  EXPECT_NE(ply_refusal(head + "property float z metres\n", "1 2 3\n4 5 6\n"), "");
  EXPECT_NE(ply_refusal(head + "property float\n", "1 2 3\n4 5 6\n"), "");
  EXPECT_EQ(ply_refusal(head + "comment any words\nproperty float z\n", "1 2 3\n4 5 6\n"), "");
}

TEST(Pcd, RefusesARowOfMoreNumbersThanItsFields) {
  const auto refusal = [](const std::string& rows) {
    return support::refusal_of([&] {
      read_as_pcd("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nHEIGHT 1\nDATA ascii\n" + rows);
    });
  };
  EXPECT_EQ(refusal("1 2 3\n4 5 6\n"), "");
  EXPECT_EQ(refusal("1 2 3\n4 5 6 99\n"),
            "test.pcd:8: expected 3 numbers, found \"99\" after them");
  EXPECT_EQ(refusal("1 2\n4 5 6\n"), "test.pcd:7: expected 3 numbers, found fewer");
}

// Elements that join vertices make surfaces or lines, whatever they are called.
// Some programs leave the points in the frame of the sensor, others do not.
TEST(ReadPcd, RefusesAViewpointThatMayMoveThePoints) {
  const auto refusal = [](const std::string& viewpoint) {
    return support::refusal_of([&] {
      read_as_pcd("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nVIEWPOINT" + viewpoint +
                  "\nWIDTH 1\nHEIGHT 1\nDATA ascii\n1 2 3\n");
    });
  };
  for (const char* plain : {" 0 0 0 1 0 0 0", " 0.0 0 -0 1.0 0 0 0", " 0 0 0 0 0 0 0"}) {
    EXPECT_EQ(refusal(plain), "") << plain;
  }
  for (const char* other : {" 100 0 50 1 0 0 0", " 0 0 0 0.7 0 0 0.7", " 0 0 1e-3 1 0 0 0", "",
                            " 0 0 0", " 0 0 0 1 0 0 nan"}) {
    EXPECT_TRUE(support::says(refusal(other), "test.pcd:4: expected VIEWPOINT 0 0 0 1 0 0 0"));
  }
}

TEST(Ply, CountsElementsThatMayBeSurfaces) {
  const auto skipped = [](const std::string& element, const std::string& row) {
    std::istringstream in(
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
        "property float z\nelement " +
        element + "\nend_header\n1 2 3\n" + row);
    return read_ply(in, "test.ply", [](std::span<const CloudPoint>) {}).skipped.count();
  };
  EXPECT_EQ(skipped("polygon 1\nproperty list uchar int of", "3 0 0 0\n"), 1u);
  EXPECT_EQ(skipped("line 1\nproperty int a\nproperty int b", "0 0\n"), 1u);
  EXPECT_EQ(skipped("polygon 0\nproperty list uchar int of", ""), 0u);
  EXPECT_EQ(skipped("camera 1\nproperty float a\nproperty int w\nproperty int h", "1 2 3\n"), 0u);
  EXPECT_EQ(skipped("range_grid 1\nproperty list uchar int vertex_indices", "1 0\n"), 0u);
}

TEST(Ply, RefusesAPropertyTwice) {
  const std::string head = "property float x\nproperty float y\nproperty float z\n";
  EXPECT_NE(ply_refusal(head + "property float x\n", "1 2 3 4\n5 6 7 8\n"), "");
}

std::vector<Vec3> xyz(const std::string& text) {
  std::vector<Vec3> out;
  std::istringstream in(text);
  read_xyz(in, "test.xyz", [&](std::span<const CloudPoint> chunk) {
    for (const CloudPoint& p : chunk) out.push_back(p.position);
  });
  return out;
}
std::size_t points_of_xyz(const std::string& text) { return xyz(text).size(); }
std::string xyz_refusal(const std::string& text) {
  return support::refusal_of([&] { xyz(text); });
}

TEST(Xyz, TakesAFirstLineOfNamesOrACountForAHeader) {
  EXPECT_EQ(points_of_xyz("x y z\n1 2 3\n"), 1u);
  EXPECT_EQ(points_of_xyz("1\n1 2 3\n"), 1u);
  EXPECT_EQ(points_of_xyz("//X Y Z\n1\n1 2 3\n"), 1u);
}

TEST(Xyz, ObeysTheOrderThatAHeaderSays) {
  for (const char* text :
       {"Northing Easting Height\n2 1 3\n", "y x z\n2 1 3\n", "id x y z\n7 1 2 3\n",
        "//Y X Z R G B\n2 1 3 0 0 0\n", "# y,x,z\n2 1 3\n", "# columns: y x z\n2 1 3\n",
        "Point ID;Z;Y [m];X [m]\n7;3;2;1\n", "\"z\",\"x\",\"y\",\n3,1,2,\n",
        "lat\tlon\tx\ty\tz\n48\t11\t1\t2\t3\n", "x,y,z\n1, 2, 3\n", "x;y;z;name\n1;2;3;\n"}) {
    EXPECT_EQ(xyz(text), std::vector<Vec3>{Vec3(1, 2, 3)}) << text;
  }
}

TEST(Xyz, RefusesAHeaderThatDoesNotSayWhereXYAndZAre) {
  EXPECT_EQ(xyz_refusal("a b c\n1 2 3\n"),
            "test.xyz:1: expected the names of columns, one of them for x (as in \"x y z\" or \"id "
            "Easting Northing Height\"), found none in \"a b c\"");
  EXPECT_EQ(xyz_refusal("x y z\n1 2 3 4\n"),
            "test.xyz:1: expected a name for each of the 4 columns between blanks of the first "
            "point, found 3: \"x y z\"");
  EXPECT_EQ(xyz_refusal("latitude longitude z\n48 11 3\n"),
            "test.xyz:1: expected columns in metres, found \"longitude\", which is in degrees: "
            "project the points first, for example with `cs2cs`, and name the columns x, y and z");
  for (const char* text :
       {"# id x y z\n1 2 3\n", "x,y,z\n1 2 3\n", "x y depth\n1 2 3\n", "x[ft] y[ft] z[ft]\n1 2 3\n",
        "x y z\nx y z\n1 2 3\n", "x y z\n1 2 3\n# y x z\n1 2 3\n", "1 2 3\n//y x z\n1 2 3\n",
        "# x y z\n// y x z\n1 2 3\n", "x y\n1 2\n"}) {
    EXPECT_NE(xyz_refusal(text), "") << text;
  }
}

TEST(Xyz, TakesOneSeparatorAFile) {
  for (const char* text : {"1 2 3\n", "1\t2\t3 \n", "1,2,3\r\n", "1; 2; 3\n",
                           "1  2   3 wall, old\n", "1,2,3,\n", "1,2,3,7\n"}) {
    EXPECT_EQ(xyz(text).at(0), Vec3(1, 2, 3)) << text;
  }
  for (const char* text :
       {"1 2 3\n1,2,3\n", "1,2,3\n1;2;3\n", "1\t2\t3\n1 2 3\n", "10,5;20,5;3,0\n",
        "10,5 20,5 3,0\n", "10,5\t20,5\t3,0\n", "1,2,3,4\n1,2,3\n", "1\t\t3\t4\n", "1 2 3,5\n"}) {
    EXPECT_NE(xyz_refusal(text), "") << text;
  }
}

TEST(Xyz, RefusesCarriageReturnsThatEndLines) {
  EXPECT_EQ(xyz_refusal("1 2 3\r4 5 6\r"), "test.xyz:1: " + sentence(lone_return()));
}

TEST(Xyz, NamesPtxAndTheWayOut) {
  EXPECT_NE(xyz_refusal("2\n1\n0 0 0\n1 0 0\n").find("PTX"), std::string::npos);
}

TEST(Xyz, RefusesAFirstLineThatIsAPointWithAWordInIt) {
  EXPECT_THROW(points_of_xyz("1 two 3\n1 2 3\n"), InputError);
  EXPECT_THROW(points_of_xyz("1 2\n1 2 3\n"), InputError);
}

TEST(Ply, PassesOverAnElementWithoutPropertiesWhateverItsCount) {
  std::istringstream in(
      "ply\nformat ascii 1.0\nelement camera 133333333333333\nelement vertex 1\nproperty float x\n"
      "property float y\nproperty float z\nend_header\n1 2 3\n");
  EXPECT_EQ(read_ply(in, "test.ply", [](std::span<const CloudPoint>) {}).read, 1u);
}

TEST(Ply, CountsPointsThatItDoesNotRead) {
  const auto kinds = [](const std::string& more) {
    std::istringstream in(
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
        "property float z\n" +
        more);
    return read_ply(in, "test.ply", [](std::span<const CloudPoint>) {}).skipped.text();
  };
  EXPECT_EQ(kinds("end_header\n1 2 3\n"), "");
  EXPECT_EQ(kinds("element point 1\nproperty float x\nproperty float y\nproperty float z\n"
                  "end_header\n1 2 3\n4 5 6\n"),
            "1 x points of another element than \"vertex\" (element point 1)");
  EXPECT_EQ(kinds("property float scale_0\nproperty float rot_0\nend_header\n1 2 3 0 1\n"),
            "1 x splats, which reach beyond their points (element vertex 1)");
}

// LAS 1.4 of format 0 that says so many points.
std::string las(std::uint32_t count) {
  std::string bytes(375, '\0');
  std::memcpy(bytes.data(), "LASF", 4);
  bytes[24] = 1;
  bytes[25] = 4;
  const auto put = [&](std::size_t at, const auto& value) {
    std::memcpy(bytes.data() + at, &value, sizeof value);
  };
  put(94, std::uint16_t{375});
  put(96, std::uint32_t{375});
  put(105, std::uint16_t{20});
  put(107, count);
  put(247, std::uint64_t{count});
  for (const std::size_t i : {0, 1, 2}) put(131 + 8 * i, 0.01);
  return bytes;
}

std::uint64_t read_as_las(const std::string& bytes) {
  std::istringstream in(bytes);
  return read_las(in, "test.las", [](std::span<const CloudPoint>) {}).read;
}

TEST(Las, RefusesACountThatTheFileDoesNotHold) {
  const std::string points(60, '\0');
  EXPECT_EQ(read_as_las(las(3) + points), 3u);
  EXPECT_THROW(read_as_las(las(0xffffffff) + points), InputError);
  EXPECT_THROW(read_as_las(las(4) + points), InputError);
}

TEST(Las, RefusesPointsThatItsHeaderDoesNotCount) {
  const std::string points(60, '\0');
  EXPECT_THROW(read_as_las(las(2) + points), InputError);
  // An extended record after the points, which the header says where to find.
  std::string counted = las(3);
  const std::uint64_t later = counted.size() + points.size();
  std::memcpy(counted.data() + 235, &later, 8);
  counted[243] = 1;
  const std::string record(60, '\0');
  EXPECT_EQ(read_as_las(counted + points + record), 3u);
  const std::uint32_t fewer = 2;
  std::memcpy(counted.data() + 107, &fewer, 4);
  std::memcpy(counted.data() + 247, &fewer, 4);
  EXPECT_THROW(read_as_las(counted + points + record), InputError);
}

}  // namespace
}  // namespace geom
