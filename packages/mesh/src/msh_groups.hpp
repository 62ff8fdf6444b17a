#pragma once
#include "msh_file.hpp"

namespace hawser {

/// Gives every group without a name its number as one; where that is another group's name or
/// number, too, with the dimension: "curve_7". MeshError when that is taken as well.
void name_groups(MshFile& file);

}  // namespace hawser
