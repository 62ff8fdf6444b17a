#include "hawser/mesh/generate.hpp"

#include <array>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "hawser/base/child_process.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/installation.hpp"

namespace hawser {
namespace {

namespace fs = std::filesystem;

// The shortest text that is read back as the same number.
std::string text(double value) {
  std::array<char, 32> buffer;
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

template <class Box>
std::vector<std::string> common_arguments(const Box& b, const std::string& path) {
  return {"--box",           text(b.min[0]),
          text(b.min[1]),    text(b.max[0]),
          text(b.max[1]),    "--flow-direction=" + b.flow_direction,
          "--refinements",   std::to_string(b.refinements),
          "--output=" + path};
}

std::string find_mesher() {
  if (const char* named = std::getenv("HAWSER_MESHER")) return named;
  const fs::path installed = installation_folder() / "bin/hawser_mesher";
  std::error_code ignored;
  if (fs::exists(installed, ignored)) return installed.string();
  throw MeshError("there is no program " + installed.string() +
                  "; set the environment variable HAWSER_MESHER to its path");
}

// What matters of what a program wrote: the last line, without the line's end.
std::string last_line(std::string words) {
  while (!words.empty() && (words.back() == '\n' || words.back() == ' '))
    words.pop_back();
  const auto end = words.rfind('\n');
  return end == std::string::npos ? words : words.substr(end + 1);
}

std::string run_mesher(const Communicator& communicator,
                       const std::vector<std::string>& arguments) {
  std::string made;
  communicator.on_root([&] {
    const auto mesher = find_mesher();
    ChildResult result;
    try {
      result = run_child(mesher, arguments);
    } catch (const OutputError& error) {
      throw MeshError(error.what());
    }
    if (result.status < 0) {
      throw MeshError(mesher + " was ended by signal " + std::to_string(-result.status));
    }
    if (result.status != 0) {
      const auto sentence = last_line(result.errors);
      throw MeshError(sentence.empty() ? mesher + " failed without a word" : sentence);
    }
    made = last_line(result.output);
  });
  return communicator.broadcast(made);
}

}  // namespace

std::string generate_mesh(const Communicator& communicator, const TowBox& box,
                          const std::string& path) {
  auto arguments = common_arguments(box, path);
  arguments.insert(arguments.end(),
                   {"--cable", text(box.tow_point[0]), text(box.tow_point[1]), text(box.tail[0]),
                    text(box.tail[1]), "--cable-size", text(box.cable_size), "--far-size",
                    text(box.far_size), "--growth", text(box.growth)});
  if (box.end_size != 0) arguments.insert(arguments.end(), {"--end-size", text(box.end_size)});
  return run_mesher(communicator, arguments);
}

std::string generate_mesh(const Communicator& communicator, const WaterBox& box,
                          const std::string& path) {
  auto arguments = common_arguments(box, path);
  arguments.push_back("--no-cable");
  if (box.cells[0] != 0 || box.cells[1] != 0) {
    arguments.insert(arguments.end(),
                     {"--structured", std::to_string(static_cast<int>(box.cells[0])),
                      std::to_string(static_cast<int>(box.cells[1]))});
  } else {
    arguments.insert(arguments.end(), {"--far-size", text(box.size)});
  }
  return run_mesher(communicator, arguments);
}

std::string generate_mesh(const Communicator& communicator, const GeoMesh& geo,
                          const std::string& file, const std::string& path) {
  std::vector<std::string> arguments = {"--geo=" + file, "--refinements",
                                        std::to_string(geo.refinements), "--output=" + path};
  for (const GeoMesh::Number& number : geo.numbers)
    arguments.insert(arguments.end(), {"--number", number.name, text(number.value)});
  return run_mesher(communicator, arguments);
}

}  // namespace hawser
