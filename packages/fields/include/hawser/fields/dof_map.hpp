#pragma once
// From a field and a point of the mesh to a row of the global system.
//
// A rank's local rows are the owned ones (in vertex order, all fields of a vertex together), then
// ghosts. Global rows are contiguous per rank.
#include <string>
#include <vector>

#include "hawser/element/basis.hpp"
#include "hawser/mesh/mesh.hpp"

namespace hawser {

struct FieldDescription {
  std::string name;
  std::string unit;
  std::string residual_unit;
  int components = 1;
  Basis basis = Basis::p1;
  Numbering numbering = Numbering::continuous;
  std::vector<Domain> domains{};  ///< the field lives on their union
  /// Field whose value this one's rate equals on structures, or empty.
  std::string follows{};
  bool has_level = false;     ///< only its differences count, as a pressure's
  bool places_nodes = false;  ///< judged against the size of the cells
};

enum class PointKind { vertex, split_vertex, edge };

/// What one local row stands for.
struct RowInfo {
  int field;
  int component;
  PointKind kind;
  LocalIndex point;  ///< local index in the mesh's point set of that kind
};

class DofMap {
 public:
  /// Rows of one vertex are ordered as `fields` are. Collective. The mesh must outlive the map.
  /// DeckError when a field's basis has nodes that the mesh cannot number.
  DofMap(const Mesh& mesh, std::vector<FieldDescription> fields);

  const Mesh& mesh() const { return *mesh_; }
  const std::vector<FieldDescription>& fields() const { return fields_; }
  int find(const std::string& field) const;  ///< index in fields(); -1 when there is none

  LocalIndex owned() const { return owned_; }
  LocalIndex rows() const { return static_cast<LocalIndex>(info_.size()); }
  GlobalIndex global_count() const { return global_count_; }
  const std::vector<GlobalIndex>& global_rows() const { return global_rows_; }
  const RowInfo& info(LocalIndex row) const { return info_[static_cast<std::size_t>(row)]; }

  /// First of the field's consecutive rows at a point; -1 where the field does not live.
  LocalIndex first_row(int field, PointKind kind, LocalIndex point) const;

  int nodes_per_cell(int field, const Region& region) const;
  /// Appends the first row of each of the field's nodes on one cell: vertices, then edges.
  void append_cell_rows(int field, const Region& region, LocalIndex cell,
                        std::vector<LocalIndex>& first_rows) const;

  /// Local rows of the field's first component on a region, ascending, owned and ghost.
  std::vector<LocalIndex> region_rows(int field, const Region& region) const;

  /// Reference position of a row's point, `mesh().dimension` numbers.
  void position(LocalIndex row, double* coordinates) const;
  /// Rank-independent number of the row's point within its kind.
  GlobalIndex point_id(LocalIndex row) const;

 private:
  const PointSet& points(PointKind kind) const;
  void check_nodes() const;
  void mark_presence();
  void number_points(bool owned);
  void number_globally();

  const Mesh* mesh_;
  std::vector<FieldDescription> fields_;
  std::vector<RowInfo> info_;
  std::vector<LocalIndex> first_row_[3];  // per kind: [point][field]
  std::vector<GlobalIndex> global_rows_;
  LocalIndex owned_ = 0;
  GlobalIndex global_count_ = 0;
};

}  // namespace hawser
