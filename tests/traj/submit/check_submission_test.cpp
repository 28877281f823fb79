// Folders that are none; those of skyway-submit are in tests/tools/submit/folder_test.py.

#include "traj/submit/check_submission.h"

#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <sstream>

#include "geom/base/error.h"
#include "geom/base/file_error.h"
#include "support/temporary_folder.h"
#include "traj/submit/manifest.h"

namespace traj {
namespace {

void write(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

TEST(CheckSubmission, WantsAManifest) {
  const support::TemporaryFolder folder;
  EXPECT_THROW(check_submission(folder.path()), geom::FileError);
}

TEST(CheckSubmission, RefusesAFileThatTheManifestDoesNotList) {
  const support::TemporaryFolder folder;
  const std::string manifest = to_json({}, "skyway");
  write(folder / "manifest.json", manifest);
  write(folder / "more.txt", "more");
  const SubmissionCheck check = check_submission(folder.path());
  ASSERT_FALSE(check.ok());
  EXPECT_EQ(check.refusal->file, "manifest.json");
  EXPECT_EQ(check.manifest, listed_file("manifest.json", manifest).sha256);
  EXPECT_TRUE(to_json_line(check).starts_with(R"({"type":"folder_report","ok":false,)"));
}

TEST(CheckSubmission, RefusesAFileWithOtherContents) {
  const support::TemporaryFolder folder;
  write(folder / "manifest.json", to_json({listed_file("summary.html", "<p>")}, "skyway"));
  write(folder / "summary.html", "<b>");
  EXPECT_FALSE(check_submission(folder.path()).ok());
}

TEST(CheckSubmission, WantsTheFilesOfAFolder) {
  const support::TemporaryFolder folder;
  write(folder / "manifest.json", to_json({listed_file("summary.html", "<p>")}, "skyway"));
  write(folder / "summary.html", "<p>");
  EXPECT_THROW(check_submission(folder.path()), geom::InputError);
}

TEST(CheckSubmission, OpensFilesAsItIsTold) {
  const support::TemporaryFolder folder;
  write(folder / "manifest.json", to_json({}, "skyway"));
  std::vector<std::string> opened;
  const auto open = [&](const std::string& path) {
    opened.push_back(path);
    return geom::open_file(path);
  };
  EXPECT_THROW(check_submission(folder.path(), {.open = open}), geom::InputError);
  EXPECT_EQ(opened, std::vector<std::string>{folder / "manifest.json"});
}

// A folder on a shared disk, say: what is looked at must be what the manifest lists.
TEST(CheckSubmission, RefusesAFileThatIsAnotherWhenItIsReadAgain) {
  const support::TemporaryFolder folder;
  std::vector<ListedFile> files;
  for (const char* name :
       {"claims.jsonl", "map.boxmap", "operation.json", "submission.json", "summary.html"}) {
    write(folder / name, "{}");
    files.push_back(listed_file(name, "{}"));
  }
  write(folder / "manifest.json", to_json(files, "skyway"));
  int opened = 0;
  const auto open = [&](const std::string& path) -> std::shared_ptr<std::istream> {
    const bool again = path == folder / "operation.json" && ++opened > 1;
    if (again) return std::make_shared<std::istringstream>("{ }");
    return geom::open_file(path);
  };
  try {
    check_submission(folder.path(), {.open = open});
    FAIL() << "it was accepted";
  } catch (const geom::InputError& error) {
    EXPECT_EQ(error.source(), folder / "operation.json");
    EXPECT_NE(std::string(error.what()).find("was changed while"), std::string::npos);
  }
}

}  // namespace
}  // namespace traj
