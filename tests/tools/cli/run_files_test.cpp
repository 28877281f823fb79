#include "cli/file/run_files.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdio>
#include <memory>

namespace {

// An output that is interrupted just before it appears.
class Interrupted : public cli::Unpublished {
 public:
  explicit Interrupted(int signal) : signal_(signal) {}
  void prepare() override { std::raise(signal_); }
  void publish() override { std::fputs("published\n", stderr); }

 private:
  int signal_;
};

void publish_interrupted_by(int signal) {
  cli::RunFiles files;
  files.add(std::make_unique<Interrupted>(signal));
  files.publish();
}

TEST(RunFilesDeathTest, OutputsAppearBeforeASignalEndsTheRun) {
  for (const int signal : {SIGHUP, SIGINT, SIGTERM}) {
    EXPECT_EXIT(publish_interrupted_by(signal), testing::KilledBySignal(signal), "published");
  }
}

}  // namespace
