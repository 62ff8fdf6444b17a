#include "geo_mesh.hpp"

#include <gmsh.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "hawser/deck/diagnostics.hpp"

namespace hawser::mesher {
namespace {

/// Calls something of gmsh on the file; what it complains of becomes one sentence.
template <class Action>
void with_gmsh(const std::string& file, Action&& action) {
  // What gmsh 4.8 throws within its threads ends the program: it is to go on, and is asked then.
  gmsh::option::setNumber("General.AbortOnError", 0);
  gmsh::logger::start();
  std::string error;
  try {
    action();
    gmsh::logger::getLastError(error);
    if (error.empty()) return;
  } catch (const std::runtime_error& thrown) {
    error = thrown.what();
  } catch (const std::string& thrown) {  // as calls of gmsh 4.8 do
    error = thrown;
  }
  throw std::runtime_error(file + ": " + error);
}

void check_text(const std::string& file) {
  std::ifstream text(file, std::ios::binary | std::ios::ate);
  if (!text || !std::filesystem::is_regular_file(file))
    throw std::runtime_error("cannot read " + file);
  char last = '\n';
  if (text.tellg() > 0 && text.seekg(-1, std::ios::end)) text.get(last);
  if (last != '\n')
    throw std::runtime_error(file +
                             " ends without a line break, and gmsh overlooks the last "
                             "statement of such a file; end the line");
}

/// The constants that the file has by DefineConstant. Names with a path are gmsh's own.
std::vector<std::string> defined_in(const std::string& file) {
  const GmshSession gmsh;
  with_gmsh(file, [&] { gmsh::open(file); });
  std::vector<std::string> names;
  gmsh::onelab::getNames(names);
  names.erase(
      std::remove_if(names.begin(), names.end(),
                     [](const std::string& name) { return name.find('/') != std::string::npos; }),
      names.end());
  return names;
}

}  // namespace

MeshSummary mesh_geo(const GeoOptions& options) {
  check_text(options.file);
  const std::vector<std::string> names = defined_in(options.file);
  for (const auto& [name, value] : options.numbers)
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw std::runtime_error(options.file + " has no constant '" + name + "'; there are " +
                               listed(names) + did_you_mean(name, names));
  const GmshSession gmsh;
  with_gmsh(options.file, [&] {
    // DefineConstant takes what is known already.
    for (const auto& [name, value] : options.numbers)
      gmsh::onelab::setNumber(name, {value});
    gmsh::open(options.file);
    gmsh::model::mesh::generate(2);
    refine_and_write(options.refinements, options.output);
  });
  MeshSummary summary = measure();
  if (summary.triangles == 0)
    throw std::runtime_error(options.file + " makes no triangles; has it a surface?");
  return summary;
}

}  // namespace hawser::mesher
