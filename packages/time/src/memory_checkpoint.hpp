#pragma once
#include "hawser/assembly/cell_memory.hpp"
#include "hawser/output/checkpoint.hpp"

namespace hawser {

/// What cells remember after the last accepted step: every cell once, by its owner.
NamedArray memory_array(const Mesh& mesh, const CellMemory& memory);

}  // namespace hawser
