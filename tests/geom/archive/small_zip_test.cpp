#include "geom/archive/small_zip.h"

#include <gtest/gtest.h>

#include <sstream>

#include "archive/crc.h"
#include "geom/archive/bytes.h"
#include "support/reading.h"

namespace geom {
namespace {

const SmallZip kZip{"a mission (.kmz)", {"b.txt", "a.txt"}, {}};

std::string written(const std::vector<SmallFile>& files) {
  std::ostringstream out;
  write_small_zip(out, files);
  return out.str();
}

std::string refusal(const std::string& archive, const SmallZip& zip = kZip) {
  return support::refusal_of([&] { files_of_zip(archive, "z", zip); });
}

// An entry as other programs write it; what is not said agrees with the content.
struct Entry {
  std::string name = "a.txt";
  std::string data = "abc";  // as stored
  std::uint16_t method = 0;
  std::uint16_t flags = 0;
  std::string content = "abc";
  std::optional<std::uint32_t> size;  // that it says
  std::string descriptor;
  std::optional<std::uint16_t> local_method;
};

void append_fields(std::string& out, const Entry& e, std::uint16_t method, bool sizes) {
  for (const std::uint16_t field :
       {std::uint16_t{20}, e.flags, method, std::uint16_t{0}, std::uint16_t{0x21}}) {
    append_bytes(out, field);
  }
  append_bytes(out, sizes ? crc32_of(std::as_bytes(std::span(e.content))) : std::uint32_t{0});
  append_bytes(out, static_cast<std::uint32_t>(sizes ? e.data.size() : 0));
  append_bytes(out, sizes ? e.size.value_or(static_cast<std::uint32_t>(e.content.size()))
                          : std::uint32_t{0});
  append_bytes(out, static_cast<std::uint16_t>(e.name.size()));
  append_bytes(out, std::uint16_t{0});
}

std::string zip_of(const std::vector<Entry>& entries, const std::string& between = "") {
  std::string out;
  std::string directory;
  for (const Entry& e : entries) {
    append_bytes(directory, std::uint32_t{0x02014b50});
    append_bytes(directory, std::uint16_t{20});
    append_fields(directory, e, e.method, true);
    directory.append(10, '\0');  // comment, disk, attributes
    append_bytes(directory, static_cast<std::uint32_t>(out.size()));
    directory += e.name;
    append_bytes(out, std::uint32_t{0x04034b50});
    append_fields(out, e, e.local_method.value_or(e.method), e.descriptor.empty());
    out += e.name + e.data + e.descriptor + between;
  }
  const auto start = static_cast<std::uint32_t>(out.size());
  out += directory;
  append_bytes(out, std::uint32_t{0x06054b50});
  append_bytes(out, std::uint32_t{0});
  append_bytes(out, static_cast<std::uint16_t>(entries.size()));
  append_bytes(out, static_cast<std::uint16_t>(entries.size()));
  append_bytes(out, static_cast<std::uint32_t>(directory.size()));
  append_bytes(out, start);
  append_bytes(out, std::uint16_t{0});
  return out;
}

Entry deflated() {
  Entry entry;
  entry.method = 8;
  entry.data = std::string("\x4b\x4c\x1c\x05\xa3\x60\x14\x0c\x77\x00\x00", 11);
  entry.content = std::string(1000, 'a');
  return entry;
}

TEST(Crc32, OfNothingIsThatOfWhatCameBefore) {
  const std::string text = "123456789";
  const auto bytes = std::as_bytes(std::span(text));
  EXPECT_EQ(crc32_of(bytes), 0xcbf43926u);  // the check value of the standard
  EXPECT_EQ(crc32_of({}, 0xcbf43926u), 0xcbf43926u);
  EXPECT_EQ(crc32_of(bytes.subspan(4), crc32_of(bytes.first(4))), 0xcbf43926u);
  EXPECT_EQ(crc32_joined(crc32_of(bytes.first(4)), crc32_of(bytes.subspan(4)), 5), 0xcbf43926u);
}

TEST(SmallZip, GivesTheWantedFilesThatAreThere) {
  const auto files = files_of_zip(
      written({{"a.txt", "one"}, {"other", "x"}, {"b.txt", ""}, {"folder/b.txt", "y"}}), "z", kZip);
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].name, "b.txt") << "in the order of the wish";
  EXPECT_EQ(files[0].content, "");
  EXPECT_EQ(files[1].content, "one");
  EXPECT_TRUE(files_of_zip(written({}), "z", kZip).empty());
}

TEST(SmallZip, IsWrittenWithoutCompressionAndTheSameEachTime) {
  const std::string text = written({{"a.txt", "some words"}});
  EXPECT_EQ(text, written({{"a.txt", "some words"}}));
  EXPECT_EQ(text.size(), 30 + 5 + 10 + 46 + 5 + 22) << "headers, names, words and no more";
  EXPECT_EQ(text.substr(35, 10), "some words");
}

TEST(SmallZip, DeflatedFilesAndDataDescriptorsAreRead) {
  EXPECT_EQ(files_of_zip(zip_of({deflated()}), "z", kZip).front().content, std::string(1000, 'a'));
  Entry streamed = deflated();
  streamed.flags = 8;
  streamed.descriptor = std::string("PK\7\10") + std::string(12, '\1');
  Entry next;
  next.name = "b.txt";
  EXPECT_EQ(files_of_zip(zip_of({streamed, next}), "z", kZip)[0].content, "abc");
}

TEST(SmallZip, WhatIsNoWholeZipIsRefused) {
  EXPECT_EQ(refusal(""), "z: expected a mission (.kmz) (a ZIP archive), found an empty file");
  EXPECT_EQ(refusal("<kml/>"),
            "z: expected a mission (.kmz) (a ZIP archive), found a file that "
            "begins with \"<kml/>\"");
  const std::string whole = zip_of({deflated(), Entry{"b.txt"}});
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_NE(refusal(whole.substr(0, size)), "") << size;
  }
}

TEST(SmallZip, WhatIsTooLargeIsRefused) {
  Entry bomb = deflated();
  bomb.size = 0xfffffff0;
  EXPECT_EQ(refusal(zip_of({bomb})),
            "z: a.txt: expected at most 67108864 bytes, found 4294967280 unpacked");
  bomb.size = 999;
  EXPECT_EQ(refusal(zip_of({bomb})),
            "z: a.txt: the file was damaged: it does not unpack to the "
            "999 bytes that it says");
  bomb.size = (1 << 20) + 1;
  EXPECT_EQ(refusal(zip_of({bomb})),
            "z: a.txt: expected a file that is packed at most 100 to 1, "
            "found 1048577 bytes in 11");
  bomb.size = 1 << 20;
  EXPECT_EQ(refusal(zip_of({bomb})),
            "z: a.txt: the file was damaged: it does not unpack to the "
            "1048576 bytes that it says");
  Entry small = deflated();
  EXPECT_EQ(refusal(zip_of({small}), {"a mission", {"a.txt"}, {}, 500}),
            "z: a.txt: expected at most 500 bytes, found 1000 unpacked");
  std::vector<Entry> many(1001);
  for (std::size_t i = 0; i < many.size(); ++i) many[i].name = std::to_string(i);
  EXPECT_EQ(refusal(zip_of(many)), "z: expected a ZIP of at most 1000 entries, found 1001");
}

TEST(SmallZip, NamesThatComeTwiceOrLeadOutAreRefused) {
  EXPECT_EQ(refusal(zip_of({Entry{}, Entry{}})),
            "z: a.txt: expected each entry once, found it "
            "twice");
  EXPECT_EQ(refusal(zip_of({Entry{"a.txt"}, Entry{"A.TXT"}})),
            "z: a.txt: expected each entry once, found it twice in other letters");
  for (const char* name : {"/a.txt", "../a.txt", "x/../a.txt", "x\\a.txt", "C:a.txt", "", ".."}) {
    EXPECT_TRUE(support::says(refusal(zip_of({Entry{name}})), "expected the name of a file inside"))
        << name;
  }
}

TEST(SmallZip, OthersLikeTheWantedAreRefused) {
  const SmallZip alone{"a mission", {"a.txt"}, {".txt"}};
  EXPECT_EQ(refusal(zip_of({Entry{"a.txt"}, Entry{"x/B.TXT"}}), alone),
            "z: x/B.TXT: expected no other file that ends in .txt than a.txt");
  EXPECT_EQ(refusal(zip_of({Entry{"a.txt"}, Entry{"x/txt"}}), alone), "");
}

TEST(SmallZip, DamageIsRefused) {
  Entry other;
  other.content = "abd";
  EXPECT_EQ(refusal(zip_of({other})), "z: a.txt: the file was damaged: its checksum differs");
  Entry encrypted;
  encrypted.flags = 1;
  EXPECT_EQ(refusal(zip_of({encrypted})),
            "z: a.txt: expected a plain entry, found an encrypted one");
  Entry method;
  method.method = 9;
  EXPECT_EQ(refusal(zip_of({method})),
            "z: a.txt: expected an entry stored or deflated, found "
            "method 9");
  Entry differs;
  differs.local_method = 8;
  EXPECT_EQ(refusal(zip_of({differs})), "z: a.txt: the local header and the directory differ");
}

TEST(SmallZip, BytesThatBelongToNoEntryAreRefused) {
  const std::string hidden = zip_of({Entry{"b.txt"}});
  EXPECT_EQ(refusal(zip_of({Entry{}}, hidden)),
            "z: expected entries one after the other, found bytes that belong to none");
  EXPECT_NE(refusal(hidden + zip_of({Entry{}})), "");
}

}  // namespace
}  // namespace geom
