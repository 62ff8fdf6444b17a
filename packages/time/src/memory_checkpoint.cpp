#include "src/memory_checkpoint.hpp"

#include <algorithm>

#include "hawser/base/error.hpp"
#include "hawser/time/state_checkpoint.hpp"

namespace hawser {
namespace {

/// Cells that fill the space are numbered in the body, of which a kernel may have a part only.
const Region& numbered_in(const Mesh& mesh, const Region& region) {
  return region.dimension == mesh.dimension ? mesh.body : region;
}

std::string array_name(const CellMemory& memory) { return "memory-" + memory.name; }

/// Numbers are 0, 1, ... over all ranks.
GlobalIndex cell_count(const Mesh& mesh, const Region& numbered) {
  const auto& ids = numbered.cell_ids;
  const double last = ids.empty() ? -1 : static_cast<double>(ids.back());
  return static_cast<GlobalIndex>(mesh.communicator.max(last)) + 1;
}

}  // namespace

/// 0 where the kernel has no cell.
NamedArray memory_array(const Mesh& mesh, const CellMemory& memory) {
  const Region& numbered = numbered_in(mesh, *memory.region);
  NamedArray array{array_name(memory), memory.per_cell, cell_count(mesh, numbered), {}, {}};
  const std::vector<GlobalIndex>& own = memory.region->cell_ids;
  const auto width = static_cast<std::size_t>(memory.per_cell);
  for (std::size_t cell = 0; cell < numbered.cell_ids.size(); ++cell) {
    if (numbered.cell_owners[cell] != mesh.communicator.rank()) continue;
    const GlobalIndex id = numbered.cell_ids[cell];
    array.ids.push_back(id);
    const auto place = std::lower_bound(own.begin(), own.end(), id);
    const bool known = place != own.end() && *place == id;
    const std::size_t first = static_cast<std::size_t>(place - own.begin()) * width;
    for (std::size_t i = 0; i < width; ++i)
      array.values.push_back(known ? memory.next[first + i] : 0);
  }
  return array;
}

void load_memories(const Mesh& mesh, const CheckpointReader& reader,
                   const std::vector<CellMemory*>& memories) {
  for (CellMemory* const memory : memories) {
    const std::string name = array_name(*memory);
    if (!reader.has(name) ||
        reader.global_count(name) != cell_count(mesh, numbered_in(mesh, *memory->region)))
      throw OutputError("the checkpoint does not fit this mesh and these modules: '" + name +
                        "' is missing or of another size");
    memory->next = reader.read(name, memory->region->cell_ids, memory->per_cell);
  }
}

}  // namespace hawser
