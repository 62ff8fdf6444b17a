#include "src/named_blocks.hpp"

#include <algorithm>

namespace hawser {

std::vector<Block> name_blocks(const DofMap& dofs, const Governance& governance,
                               const std::vector<PhysicsModule>& modules) {
  std::vector<Block> blocks;
  const auto find = [&](const std::string& name, const std::string& field) {
    return std::find_if(blocks.begin(), blocks.end(),
                        [&](const Block& b) { return b.name == name && b.field == field; });
  };
  for (const PhysicsModule& module : modules)
    for (const FieldDescription& field : dofs.fields())
      if (find(module.block, field.name) == blocks.end())
        blocks.push_back({module.block, field.name, field.residual_unit, {}});
  for (LocalIndex row = 0; row < dofs.owned(); ++row) {
    const int module = governance.block_of_row[static_cast<std::size_t>(row)];
    const int field = dofs.info(row).field;
    find(modules[static_cast<std::size_t>(module)].block,
         dofs.fields()[static_cast<std::size_t>(field)].name)
        ->rows.push_back(row);
  }
  const Communicator& communicator = dofs.mesh().communicator;
  blocks.erase(
      std::remove_if(blocks.begin(), blocks.end(),
                     [&](const Block& block) { return !communicator.any(!block.rows.empty()); }),
      blocks.end());
  return blocks;
}

}  // namespace hawser
