#include "hawser/mesh/mesh.hpp"

#include <map>
#include <numeric>

#include "distribute.hpp"
#include "graph.hpp"
#include "hawser/base/error.hpp"
#include "hawser/mesh/mesh_audit.hpp"
#include "whole_mesh.hpp"

namespace hawser {

const char* Mesh::per_depth() const { return dimension == 2 && has_body() ? "/m" : ""; }

const Region* Mesh::find(const Domain& domain) const {
  for (const auto& region : regions) {
    if (domain.is_region() && region.name == domain.regions[0]) return &region;
  }
  for (const auto& [made, region] : derived) {
    if (made == domain) return &region;
  }
  return nullptr;
}

const Region& Mesh::region(const Domain& domain) const {
  if (const auto* found = find(domain)) return *found;
  std::string names;
  for (const auto& region : regions)
    names += (names.empty() ? "" : ", ") + region.name;
  throw MeshError("the mesh has no region '" + domain.text() + "'; it has " + names);
}

std::vector<LocalIndex> places_in(const Region& whole, const Region& part) {
  std::vector<LocalIndex> places(at(part.size()));
  std::iota(places.begin(), places.end(), 0);
  if (&part == &whole) return places;
  std::map<std::vector<LocalIndex>, LocalIndex> place_of;
  for (LocalIndex c = 0; c < whole.size(); ++c)
    place_of.emplace(sorted_vertices(whole, c), c);
  for (auto& place : places)
    place = place_of.at(sorted_vertices(part, place));
  return places;
}

namespace {

/// Errors together, as one; what remains goes to the mesh's notes.
void tell(const std::vector<MeshFinding>& findings, Mesh& mesh) {
  std::string errors;
  for (const auto& [weight, sentence] : findings)
    if (weight == MeshFinding::Weight::error)
      errors += (errors.empty() ? "" : "\n") + sentence;
    else
      mesh.notes.push_back(sentence);
  if (!errors.empty()) throw MeshError(errors);
}

}  // namespace

Mesh read_mesh(const Communicator& communicator, const MeshOptions& options) {
  Mesh whole;
  whole.communicator = communicator;
  std::vector<int> owner_of_vertex;
  communicator.on_root([&] {
    whole = check_and_number(read_msh(options.file), options.dimension);
    whole.communicator = communicator;
    add_topology(whole, options);
    tell(audit(whole, options), whole);
    const auto graph = make_graph(whole.vertices.size(), whole.edge_ends);
    owner_of_vertex = partition(graph, communicator.size());
  });
  return distribute(communicator, whole, owner_of_vertex);
}

}  // namespace hawser
