#include "gmsh_session.hpp"

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <stdexcept>
#include <vector>

#include "hawser/mesh/triangle_quality.hpp"

namespace hawser::mesher {

GmshSession::GmshSession() {
  gmsh::initialize();
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::option::setNumber("General.NumThreads", 1);  // the same mesh on every machine
  gmsh::option::setNumber("Mesh.Algorithm", 6);      // frontal Delaunay; 8 crashes in Debian 12
  gmsh::option::setNumber("Mesh.MshFileVersion", 4.1);
}

GmshSession::~GmshSession() { gmsh::finalize(); }

void refine_and_write(int refinements, const std::string& path) {
  for (int k = 0; k < refinements; ++k)
    gmsh::model::mesh::refine();  // nested meshes
  // Under another name first: who finds the file finds all of it.
  const std::string partial = path + ".partial.msh";
  if (!std::ofstream(partial)) throw std::runtime_error("cannot write " + path);
  gmsh::write(partial);
  if (std::rename(partial.c_str(), path.c_str()) != 0)
    throw std::runtime_error("cannot write " + path);
}

MeshSummary measure() {
  MeshSummary summary;
  std::vector<std::size_t> nodes, elements, corners;
  std::vector<double> x, parametric;
  gmsh::model::mesh::getNodes(nodes, x, parametric);
  std::map<std::size_t, const double*> position;
  for (std::size_t k = 0; k < nodes.size(); ++k)
    position[nodes[k]] = &x[3 * k];
  summary.nodes = position.size();
  gmsh::model::mesh::getElementsByType(2, elements, corners);
  summary.triangles = elements.size();
  for (std::size_t k = 0; k < elements.size(); ++k) {
    const double quality = triangle_quality(position[corners[3 * k]], position[corners[3 * k + 1]],
                                            position[corners[3 * k + 2]]);
    // The orientation is put right by whoever reads the mesh.
    summary.least_quality = std::min(summary.least_quality, std::abs(quality));
    summary.mean_quality += std::abs(quality) / static_cast<double>(elements.size());
  }
  return summary;
}

}  // namespace hawser::mesher
