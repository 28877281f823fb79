// skyway: runs skyway-VERB, and lists the verbs.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "cli/file/standard_streams.h"
#include "cli/option/completion.h"
#include "cli/run.h"
#include "geom/text/nearest_word.h"

namespace {

constexpr std::pair<const char*, const char*> kVerbs[] = {
    {"synth", "make up a city"},
    {"import", "city tables, block texts, voxels and octrees to box maps"},
    {"import-flight", "a PX4 log (ULog) to a flight log"},
    {"import-trajectory", "drone files and missions to trajectories and paths"},
    {"footprints", "building footprints, city and height models to box maps"},
    {"cloud", "point clouds to box maps"},
    {"mesh", "models of triangles and 3D Tiles to box maps"},
    {"map", "look at, join, merge, patch and convert box maps"},
    {"query", "hits, clearance, nearest boxes, planes, room"},
    {"lattice", "build a lattice graph of a map"},
    {"roadmap", "build a taut visibility roadmap of a map"},
    {"plan", "plan collision-free paths"},
    {"replan", "paths of an older map, kept or mended on a newer one"},
    {"traj", "minimum-snap trajectories along paths"},
    {"fleet", "departures of many flights that keep apart"},
    {"check", "prove trajectories and paths"},
    {"fly", "fly trajectories with a simulated quadrotor"},
    {"join", "join the shards of a run"},
    {"export", "write drone files"},
    {"submit", "a folder for an authority: flights, volumes and proofs"},
    {"bench", "compare planners, each path proved"},
    {"render", "draw what the vehicle sees, and pictures of maps"},
    {"plot", "draw maps, motion, ways home and benchmarks as SVG"},
    {"view", "show anything in one page for a browser"},
    {"info", "say what is in a file"},
};

constexpr const char* kTopics[] = {"certificates", "cities",  "clouds",  "exact",    "maps",
                                   "missions",     "models",  "motion",  "pictures", "running",
                                   "search",       "sources", "together", "ways-home"};

std::string usage() {
  std::string text = "Usage: skyway VERB [ARGUMENT ...]\n\nVerbs (skyway VERB --help says more):\n";
  for (const auto& [verb, what] : kVerbs) text += fmt::format("  {:<17} {}\n", verb, what);
  return text + fmt::format(
                    "\nTopics (skyway help TOPIC):\n  {}\n\nExample:\n  skyway import "
                    "data/downtown.csv -o downtown.boxmap\n",
                    fmt::join(kTopics, " "));
}

int answer(std::string_view text) {
  try {
    cli::print(text);
    return 0;
  } catch (const std::system_error& error) {
    cli::complain("skyway", error.what());
    return 4;
  }
}

// The package of a tool that a build may leave out, as its libraries are large; empty for others.
std::string package_of(const std::string& program) {
  for (const char* tool : {"skyway-footprints", "skyway-cloud", "skyway-mesh"}) {
    if (program == tool) return program;
  }
  return program == "man" ? "man-db" : "";
}

// Only returns where the program cannot be run.
int cannot_run(const std::string& program) {
  const std::string package = errno == ENOENT ? package_of(program) : "";
  const std::string reason = std::strerror(errno);
  if (package.empty()) {
    cli::complain("skyway", fmt::format("cannot run {}: {}", program, reason));
  } else {
    cli::complain("skyway",
                  fmt::format("{} is not installed: apt install {}{}", program, package,
                              program == "man" ? "" : ", or build all tools (./bootstrap all)"));
  }
  return 4;
}

int unknown(const std::string& word, const char* what, std::vector<std::string> words) {
  cli::complain("skyway",
                fmt::format("unknown {} \"{}\"{}", what, word, geom::did_you_mean(word, words)));
  cli::say("Try 'skyway help', which lists the verbs.\n");
  return 2;
}

std::vector<std::string> verbs() {
  std::vector<std::string> out;
  for (const auto& [verb, what] : kVerbs) out.emplace_back(verb);
  return out;
}

bool contains(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// Opens the manual page of a verb or topic.
int open_page(const std::string& word) {
  const std::vector<std::string> topics(std::begin(kTopics), std::end(kTopics));
  const bool is_topic = contains(topics, word);
  std::vector<std::string> known = verbs();
  if (!is_topic && !contains(known, word)) {
    known.insert(known.end(), topics.begin(), topics.end());
    return unknown(word, "verb or topic", std::move(known));
  }
  execlp("man", "man", is_topic ? "7" : "1", ("skyway-" + word).c_str(), nullptr);
  return cannot_run("man");
}

// Runs the tool beside this program, else the one on the PATH.
int run_verb(const std::string& verb, int argc, char** argv) {
  std::string tool = "skyway-" + verb;
  std::error_code error;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::string beside = (self.parent_path() / tool).string();
  std::vector<char*> arguments(argv + 1, argv + argc);
  arguments[0] = tool.data();
  arguments.push_back(nullptr);
  if (!error) execv(beside.c_str(), arguments.data());
  execvp(tool.c_str(), arguments.data());
  return cannot_run(tool);
}

}  // namespace

int main(int argc, char** argv) {
  cli::prepare_standard_streams();
  const std::string verb = argc > 1 ? argv[1] : "";
  if (verb == "help" && argc == 3) return open_page(argv[2]);
  if (verb == "help" || verb == "--help" || verb == "-h") return answer(usage());
  if (verb == "--version") return answer("skyway " SKYWAY_VERSION "\n");
  if (const auto shell =
          verb == "--completion" && argc == 3 ? cli::shell_from(argv[2]) : std::nullopt) {
    return answer(cli::completion("skyway", kVerbs, *shell));
  }
  if (verb.empty()) {
    cli::say(usage());
    return 2;
  }
  return contains(verbs(), verb) ? run_verb(verb, argc, argv) : unknown(verb, "verb", verbs());
}
