#pragma once
// A series of outputs as one file of VTK's own format, VTKHDF 2.0, for ParaView from 5.12 on and
// pyvista: points that move, cells that stay, and the time of every step.
//
// The file holds no numbers of its own but the kinds of the cells: its datasets are virtual, made
// of those of the steps' files in the same folder. It is small, is written anew with every output,
// and can be moved with its folder.
// https://docs.vtk.org/en/latest/vtk_file_formats/vtkhdf_file_format/
#include <map>
#include <string>
#include <vector>

#include "hawser/output/field_writer.hpp"

namespace hawser {

/// Replaces `path`, complete or not at all. On one rank; OutputError.
void write_vtkhdf(const std::string& path, const Grid& grid, const std::vector<PointField>& fields,
                  const std::map<int, SavedOutput>& outputs);

}  // namespace hawser
