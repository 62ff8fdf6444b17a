#pragma once
// This rank's part of the elements, and their named parts of any dimension.
//
// Distribution: every vertex has one owning rank. A rank holds all cells that touch a vertex it
// owns, so the rows of owned vertices are assembled without communication and, because cells are
// kept in the order of their rank-independent numbers, with the same order of summation on any
// number of ranks.
#include <string>
#include <utility>
#include <vector>

#include "hawser/base/communicator.hpp"
#include "hawser/base/domain.hpp"
#include "hawser/base/types.hpp"
#include "hawser/element/cell_shape.hpp"
#include "hawser/mesh/triangle_quality.hpp"

namespace hawser {

/// Points of one kind (vertices, split vertices or edges) that this rank knows: owned ones first.
struct PointSet {
  LocalIndex owned = 0;          ///< points [0, owned) are this rank's
  GlobalIndex global_count = 0;  ///< over all ranks
  std::vector<GlobalIndex> ids;  ///< rank-independent numbers, in [0, global_count)
  std::vector<int> owners;       ///< owning rank of each local point
  LocalIndex size() const { return static_cast<LocalIndex>(ids.size()); }
};

struct Region {
  std::string name;
  int dimension = 0;
  CellShape shape = CellShape::point;
  int vertices_per_cell = 1;
  int edges_per_cell = 0;             ///< which vertices each joins, the shape's traits say
  std::vector<GlobalIndex> cell_ids;  ///< ascending; rank-independent, from 0 on; of cells of the
                                      ///< body their numbers there
  std::vector<int> cell_owners;       ///< the rank that counts this cell in sums over cells
  std::vector<LocalIndex> vertices;   ///< [cell][vertices_per_cell]
  /// The same in split numbering; cells of the body only, and facets.
  std::vector<LocalIndex> split_vertices;
  std::vector<LocalIndex> edges;  ///< [cell][edges_per_cell]
  LocalIndex size() const { return static_cast<LocalIndex>(cell_ids.size()); }
};

/// The cells of one dimension that are named together by a gmsh physical group are a region. Beside
/// them stand the domains that were asked for when the mesh was read. What exists does so on every
/// rank, if only without cells.
///
/// Cells of a patch have three vertices, a, b, c of consecutive segments a-b and b-c. Facets are
/// cells of the body turned so that their edge 0 -> 1 is on the boundary, with the body on its
/// left.
struct Mesh {
  Communicator communicator;
  int dimension = 2;  ///< of the space; in three the mesh has lines and points only
  PointSet vertices;
  PointSet split_vertices;  ///< vertices doubled along the slit lines, one per side; tips single
  PointSet edges;
  std::vector<double> coordinates;          ///< reference coordinates, [local vertex][dimension], m
  std::vector<LocalIndex> vertex_of_split;  ///< the vertex on which it sits
  std::vector<LocalIndex> edge_ends;        ///< [local edge][2]
  Region body;  ///< every cell that fills the space, once, however many regions name it
  std::vector<Region> regions;
  std::vector<std::pair<Domain, Region>> derived;
  std::vector<std::string> notes;  ///< on rank 0: what a user might not expect

  bool has_body() const { return body.dimension == dimension; }  ///< on all ranks alike
  /// What follows the unit of a force: "/m" where a body in the plane stands for one of any depth,
  /// else nothing.
  const char* per_depth() const;
  std::string force_unit() const { return std::string("N") + per_depth(); }
  /// Null when there is none, on all ranks alike.
  const Region* find(const Domain& domain) const;
  /// MeshError naming the regions there are.
  const Region& region(const Domain& domain) const;
};

/// Where each cell of `part` is among those of `whole`, a union of it and other regions; local
/// numbers.
std::vector<LocalIndex> places_in(const Region& whole, const Region& part);

struct MeshOptions {
  std::string file;                ///< MSH 2.2 or 4.1
  std::vector<std::string> slits;  ///< line regions across which split vertices are doubled
  int dimension = 2;               ///< 3: z is read too, and there may be no triangles
  std::vector<Domain> domains{};   ///< to be made beside the named regions, where there is any
  // What the audit (mesh_audit.hpp) would find, and what is meant:
  std::vector<std::string> apart{};  ///< regions that share no nodes with what is at their place
  bool open_boundary = false;        ///< boundary edges may be in no region
};

/// Reads on rank 0, finds edges, sides and domains there, audits the mesh, partitions with METIS
/// and scatters. Collective; MeshError on all ranks, with a line for each error that the audit
/// found.
Mesh read_mesh(const Communicator& communicator, const MeshOptions& options);

}  // namespace hawser
