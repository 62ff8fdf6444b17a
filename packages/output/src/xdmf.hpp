#pragma once
// The XDMF text that tells ParaView what an HDF5 file holds.
#include <map>
#include <string>
#include <vector>

#include "hawser/output/field_writer.hpp"
#include "hawser/output/grid.hpp"

namespace hawser {

/// Vectors of two components are written with a third, zero, because that is what ParaView draws.
int written_components(int components);

/// How many rows a field's table has: of points or of cells.
inline GlobalIndex rows_of(const Grid& grid, const PointField& field) {
  return field.of_cells ? grid.cell_count : grid.point_count;
}

/// The <Grid> element of one output. `data` is the HDF5 file's name, in the same folder.
std::string xdmf_grid(const Grid& grid, const std::string& data,
                      const std::vector<PointField>& fields);

/// A file of one grid (without its time, of which meshio knows nothing), or of several as a series.
std::string xdmf_single(const std::string& grid);
std::string xdmf_series(const std::string& name, const std::map<int, SavedOutput>& outputs);

/// The <Grid> element within what xdmf_single made.
std::string xdmf_grid_of(const std::string& single);

}  // namespace hawser
