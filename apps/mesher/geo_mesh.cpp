#include "geo_mesh.hpp"

#include <gmsh.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace hawser::mesher {
namespace {

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names)
    text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "none" : text;
}

/// Calls something of gmsh on the file; what it throws becomes one sentence.
template <class Action>
void with_gmsh(const std::string& file, Action&& action) {
  std::string error;
  try {
    gmsh::logger::start();
    action();
    return;
  } catch (const std::runtime_error& thrown) {
    error = thrown.what();
  } catch (const std::string& thrown) {  // as gmsh 4.8 does
    error = thrown;
  } catch (...) {
    gmsh::logger::getLastError(error);
  }
  throw std::runtime_error(file + ": " + (error.empty() ? "gmsh failed without a word" : error));
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

std::pair<std::string, double> read_number(const std::string& text) {
  const auto equals = text.find('=');
  std::size_t used = 0;
  double value = 0;
  try {
    if (equals != std::string::npos) value = std::stod(text.substr(equals + 1), &used);
  } catch (const std::exception&) {
    used = 0;
  }
  if (equals == 0 || equals == std::string::npos || equals + 1 + used != text.size())
    throw std::invalid_argument("'" + text + "' is no NAME=NUMBER");
  return {text.substr(0, equals), value};
}

MeshSummary mesh_geo(const GeoOptions& options) {
  if (!std::ifstream(options.file)) throw std::runtime_error("cannot read " + options.file);
  const std::vector<std::string> names = defined_in(options.file);
  for (const auto& [name, value] : options.numbers)
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw std::runtime_error(options.file + " has no constant '" + name + "'; there are " +
                               listed(names));
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
