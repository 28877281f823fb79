#include "cli/shard/sharding.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "support/temporary_folder.h"

namespace cli {
namespace {

// What the arguments of a tool with some options, in a folder of its own, make of it.
class ShardingTest : public testing::Test {
 protected:
  void SetUp() override { write("map", "boxes"); }

  std::string path(const std::string& name) const { return folder_ / name; }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(path(name)) << text;
  }

  // The exit code of what is there already, else it is written.
  std::optional<Exit> run(const std::string& arguments, Exit exit = Exit::yes) {
    CLI::App app("", "tool");
    Common common(app, true);
    Sharding sharding;
    std::string map = path("map");
    std::string vehicle, size, output = path("shard");
    app.add_option("-o,--output", output, "");
    app.add_option("--vehicle", vehicle, "");
    app.add_option("--size", size, "");
    sharding.add_to(app);
    app.parse(arguments + " -q");
    sharding.begin(app, {{"map", map}, {"other", ""}}, {{"output", output}});
    const auto done = sharding.finished(common);
    const std::vector<std::uint8_t> bytes = {1, 2, 3};
    const geom::NamedArray array = geom::named_array<std::uint8_t>("text", bytes);
    if (!done) sharding.write(output, "output", "records", {"{}", {array}, {}}, exit);
    return done;
  }

  support::TemporaryFolder folder_;
};

TEST_F(ShardingTest, KnowsWhatIsDoneAndHowItEnded) {
  EXPECT_EQ(run("--shard 1/2 --size 5", Exit::no), std::nullopt);
  EXPECT_EQ(run("--shard 1/2 --size 5"), Exit::no);
  EXPECT_EQ(run("--shard 1/2 --size 5 --threads 3 --stats " + path("s")), Exit::no);
}

TEST_F(ShardingTest, KnowsEveryThingThatCanChangeAByte) {
  write("craft.json", "{}");
  const std::string craft = " --vehicle " + path("craft.json");
  for (const std::string& other :
       {std::string("--shard 2/2"), std::string("--shard 1/3"), std::string("--shard 1/2 --size 5"),
        std::string("--shard 1/2 --size 6"), "--shard 1/2" + craft}) {
    EXPECT_EQ(run("--shard 1/2"), std::nullopt);
    EXPECT_EQ(run("--shard 1/2"), Exit::yes);
    EXPECT_EQ(run(other), std::nullopt) << other;
    EXPECT_EQ(run(other), Exit::yes) << other;
  }
  write("craft.json", "{\"name\":\"x\"}");
  EXPECT_EQ(run("--shard 1/2" + craft), std::nullopt);
  write("map", "others");
  EXPECT_EQ(run("--shard 1/2" + craft), std::nullopt);
  EXPECT_EQ(run("--shard 1/2" + craft), Exit::yes);
}

TEST_F(ShardingTest, NamesNoPath) {
  write("craft.json", "{}");
  run("--shard 1/2 --size 5 --vehicle " + path("craft.json"));
  const geom::ArrayArchive archive = open_archive(path("shard"));
  EXPECT_EQ(archive.meta().find("sharding_test"), std::string_view::npos) << archive.meta();
  const geom::ShardFile shard = geom::read_shard(archive);
  EXPECT_EQ(shard.work.options, R"({"size":["5"]})");
  EXPECT_TRUE(shard.work.inputs.find("\"vehicle\":") != std::string::npos);
  EXPECT_EQ(shard.shard, (geom::Shard{0, 2}));
}

TEST_F(ShardingTest, WritesAnewWhatIsDamagedOrIsSomethingElse) {
  EXPECT_EQ(run("--shard 1/2"), std::nullopt);
  std::filesystem::resize_file(path("shard"), std::filesystem::file_size(path("shard")) - 1);
  EXPECT_EQ(run("--shard 1/2"), std::nullopt);
  write("shard", "something else");
  EXPECT_EQ(run("--shard 1/2"), std::nullopt);
  EXPECT_EQ(run("--shard 1/2"), Exit::yes);
}

TEST_F(ShardingTest, AKilledProcessLeavesNothing) {
  const pid_t child = ::fork();
  if (child == 0) {
    OutputFile out(path("half"), OutputKind::text);
    out.stream() << std::string(1 << 20, 'x');
    out.flush();
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status));
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
    files += entry.path().filename().string().starts_with("half");
  }
  const int unnamed = ::open(folder_.path().c_str(), O_WRONLY | O_TMPFILE, 0600);
  EXPECT_EQ(files, unnamed >= 0 ? 0u : 1u);  // where the file system knows files without a name
  if (unnamed >= 0) ::close(unnamed);
}

}  // namespace
}  // namespace cli
