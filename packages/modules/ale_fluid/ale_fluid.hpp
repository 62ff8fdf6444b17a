#pragma once
// Module <ale-fluid>: incompressible flow on a moving mesh. See theory.md.

namespace hawser {
class ModuleRegistry;
void register_ale_fluid(ModuleRegistry& registry);
}  // namespace hawser
