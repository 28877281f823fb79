// skyway-query: hits, clearance and nearest boxes of points, segments and boxes.

#include <utility>

#include "cli/file/files.h"
#include "cli/option/degrees.h"
#include "cli/option/output_option.h"
#include "cli/option/scenes.h"
#include "cli/option/vehicle_option.h"
#include "cli/run.h"
#include "geom/base/error.h"
#include "geom/base/parallel.h"
#include "geom/record/scene_answers.h"
#include "grid.h"

namespace {

using geom::Vec3;

constexpr std::size_t kBatch = 4096;  // records answered at once, in order

using Line = std::pair<std::string, std::size_t>;  // and its number

// Throws where a batch looks like degrees: the two points of a record, or all single ones, of which
// one in a million is near enough by chance.
void require_metres(const std::vector<Line>& batch, const geom::Frame& frame,
                    const cli::MetresOption& metres, const std::string& source) {
  std::vector<Vec3> single;
  std::size_t first = 0;
  for (const auto& [text, line] : batch) {
    const std::vector<Vec3> points = geom::points_asked(text);
    if (points.size() > 1) metres.check_input(frame, points, source, line);
    if (points.size() != 1) continue;
    if (single.empty()) first = line;
    single.push_back(points[0]);
  }
  metres.check_input(frame, single, source, first);
}

// Lines of a stream and their answers, batch after batch.
class Stream {
 public:
  Stream(const geom::CollisionScene& scene, bool degrees, const cli::InputFile& file,
         cli::OutputFile& out, const geom::Execution& run)
      : answers_(scene, degrees), file_(file), out_(out), run_(run) {}

  const std::vector<Line>& batch() const { return batch_; }

  // Whether the batch is full.
  bool add(const std::string& line, std::size_t number) {
    batch_.emplace_back(line, number);
    return batch_.size() == kBatch;
  }

  // Of a malformed record, what stood before it is answered and the rest is not.
  void answer() {
    std::vector<std::string> lines(batch_.size());
    try {
      geom::parallel_for(batch_.size(), run_, [&](std::size_t i) {
        lines[i] = answers_.answer(batch_[i].first, file_.name(), batch_[i].second);
      });
    } catch (const geom::InputError&) {
      write(lines);
      out_.flush();
      throw;
    }
    write(lines);
    batch_.clear();
  }

 private:
  void write(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) {
      if (line.empty()) break;  // the malformed record
      out_.stream() << line;
    }
  }

  geom::SceneAnswers answers_;
  const cli::InputFile& file_;
  cli::OutputFile& out_;
  geom::Execution run_;
  std::vector<Line> batch_;
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Ask the collision structure of a box map (JSON Lines in, JSON Lines out).",
               "skyway-query"};
  cli::Common common(app, true);
  cli::VehicleOptions vehicle;
  std::string map_file;
  std::string input = "-";
  std::string output = "-";
  cli::MetresOption metres;
  bool degrees = false;
  app.add_option("map", map_file, "box map; - for stdin")->required();
  app.add_option(
      "file", input,
      "records with \"point\":[x,y,z] or \"60.1719N,24.9414E,30\" (\"k\":N nearest boxes), "
      "\"segment\":[[…],[…]] "
      "(\"planes\":REACH, \"empty_box\":REACH), \"box\":[[min],[max]] or "
      "\"sweep\":[[…],[…]] with \"half\":[x,y,z] (default: stdin)");
  cli::add_output(app, "-o,--output", output,
                  "answers, or the GeoTIFF of --grid (default: stdout)");
  metres.add_to(app);
  app.add_flag("--degrees", degrees, "answer points with their latitude and longitude");
  vehicle.add_to(app);
  vehicle.add_memory_to(app);
  querying::Grid grid;
  grid.add_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    grid.refuse_idle(app);
    if (!grid.asked()) cli::at_most_one_stdin({map_file, input});
    cli::Scenes scenes(cli::open_map(map_file, geom::Verified::extents, common.execution("verify")),
                       vehicle, cli::Scenes::Differences::refused);
    const geom::CollisionScene& scene = scenes.scene();
    if (grid.asked()) {
      grid.write(scene, output, common.execution("cells"));
      common.write_stats({{"collision", scenes.stats()}});
      return cli::Exit::yes;
    }
    cli::InputFile file(input);
    cli::OutputFile out(output, cli::OutputKind::text);
    Stream stream(scene, degrees, file, out, {common.execution("queries").threads, {}});
    const auto answer = [&] {
      require_metres(stream.batch(), scene.map().spec().frame, metres, file.name());
      stream.answer();
    };
    file.for_each_line([&](const std::string& line, std::size_t number) {
      if (stream.add(line, number)) answer();
    });
    answer();
    out.commit();
    common.write_stats({{"collision", scenes.stats()}});
    return cli::Exit::yes;
  });
}
