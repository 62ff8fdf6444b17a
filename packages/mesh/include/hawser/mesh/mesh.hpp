#pragma once
// This rank's part of the elements, and their named parts of any dimension.
//
// Distribution: every vertex has one owning rank. A rank holds all cells that touch a vertex it
// owns, so the rows of owned vertices are assembled without communication and, because cells are
// kept in the order of their rank-independent numbers, with the same order of summation on any
// number of ranks.
#include <string>
#include <vector>

#include "hawser/base/communicator.hpp"
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
  std::vector<GlobalIndex> cell_ids;  ///< ascending; rank-independent, in [0, cells of the region)
  std::vector<int> cell_owners;       ///< the rank that counts this cell in sums over cells
  std::vector<LocalIndex> vertices;   ///< [cell][vertices_per_cell]
  /// The same in split numbering; triangles and facets only.
  std::vector<LocalIndex> split_vertices;
  std::vector<LocalIndex> edges;  ///< [cell][edges_per_cell]
  LocalIndex size() const { return static_cast<LocalIndex>(cell_ids.size()); }
};

/// Regions are named by the gmsh physical groups. Of every line region inside the body (a cable),
/// or of a mesh without a body, there is also "<name>/patches", and for every point region that it
/// touches "<name>/<point>": its cells there, turned so that they begin at the point. Of every line
/// region on the body's boundary there is "<name>/facets". Every region exists on every rank, if
/// only without cells.
struct Mesh {
  Communicator communicator;
  int dimension = 2;  ///< of the space; in three the mesh has lines and points only
  PointSet vertices;
  PointSet split_vertices;  ///< vertices doubled along the slit lines, one per side; tips single
  PointSet edges;
  std::vector<double> coordinates;          ///< reference coordinates, [local vertex][dimension], m
  std::vector<LocalIndex> vertex_of_split;  ///< the vertex on which it sits
  std::vector<LocalIndex> edge_ends;        ///< [local edge][2]
  std::vector<Region> regions;

  bool has_body() const;  ///< some region is of triangles, on all ranks alike
  /// What follows the unit of a force: "/m" where a body in the plane stands for one of any depth,
  /// else nothing.
  const char* per_depth() const;
  std::string force_unit() const { return std::string("N") + per_depth(); }
  /// Null when there is none, on all ranks alike.
  const Region* find(const std::string& name) const;
  /// MeshError naming the regions there are.
  const Region& region(const std::string& name) const;
};

struct MeshOptions {
  std::string file;                ///< MSH 2.2 or 4.1, ASCII
  std::vector<std::string> slits;  ///< line regions across which split vertices are doubled
  int dimension = 2;               ///< 3: z is read too, and there may be no triangles
};

/// Reads on rank 0, finds sides, edges, patches and facets there, partitions with METIS and
/// scatters. Collective; MeshError on all ranks.
Mesh read_mesh(const Communicator& communicator, const MeshOptions& options);

}  // namespace hawser
