#include "moving.h"

#include <array>

#include "cli/file/files.h"

namespace cli {

void Moving::add_to(CLI::App& app, const std::string& what) {
  app.add_option("--moving", file_, "obstacles that move, JSON Lines: " + what)->type_name("FILE");
}

traj::MovingObstacles Moving::read() const {
  InputFile file(file_);
  return {file.stream(), file.name()};
}

traj::MovingObstacles::LookAt look_at_boxes(const MetresOption& metres, const geom::Frame& frame) {
  return [metres, frame](const geom::Aabb& box, const std::string& source, std::size_t line) {
    metres.check_input(frame, std::array{box.min, box.max}, source, line);
  };
}

}  // namespace cli
