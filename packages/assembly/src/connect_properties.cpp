#include "hawser/assembly/connect_properties.hpp"

#include <algorithm>
#include <set>
#include <string_view>

#include "hawser/base/error.hpp"
#include "src/cell_vertices.hpp"

namespace hawser {
namespace {

struct Supplier {
  const PhysicsModule* module;
  const Supply* supply;
};

std::string text_of(const Supplier& supplier) {
  return named(*supplier.module) + " (" + supplier.module->location.text() + ")";
}

class Connecting {
 public:
  Connecting(const Mesh& mesh, std::vector<PhysicsModule>& modules, Diagnostics& diagnostics)
      : mesh_(mesh), modules_(modules), diagnostics_(diagnostics) {
    for (const PhysicsModule& module : modules)
      for (const Supply& supply : module.supplies)
        suppliers_.push_back({&module, &supply});
  }

  void all() {
    for (PhysicsModule& module : modules_)
      for (const auto& kernel : module.kernels)
        for (std::size_t p = 0; p < kernel->properties().uses().size(); ++p)
          connect(module, *kernel, p);
  }

 private:
  void connect(const PhysicsModule& module, Kernel& kernel, std::size_t property) {
    const PropertyUse use = kernel.properties().uses()[property];
    const Region& region = mesh_.region(kernel.domain());
    const bool has_constant = kernel.properties().has_constant(property);
    const auto cells = static_cast<std::size_t>(region.size());
    std::vector<const Supplier*> first(cells, nullptr);  // that holds on a cell
    const Supplier* clash[2] = {nullptr, nullptr};
    bool clashes_with_constant = false;
    for (const Supplier& supplier : suppliers_) {
      const Supply& supply = *supplier.supply;
      if (std::string_view(supply.source->property().name) != use.name) continue;
      const std::vector<char> holds = cells_within(mesh_, region, supply.on);
      if (!mesh_.communicator.any(std::count(holds.begin(), holds.end(), 1) > 0)) continue;
      kernel.connect(property, supply);
      bool alone_twice = false;
      for (std::size_t cell = 0; cell < cells; ++cell) {
        if (holds[cell] == 0) continue;
        const Supplier* const other = first[cell];
        if (other != nullptr && !(other->supply->adds && supply.adds)) {
          alone_twice = true;
          clash[0] = other;
        }
        if (other == nullptr) first[cell] = &supplier;
      }
      if (mesh_.communicator.any(alone_twice)) clash[1] = &supplier;
      if (has_constant && !supply.adds) {
        clashes_with_constant = true;
        clash[1] = &supplier;
      }
    }
    if (clash[1] != nullptr) complain_of_two(module, use, clash, clashes_with_constant);
    const bool lacks = std::count(first.begin(), first.end(), nullptr) > 0;
    if (mesh_.communicator.any(lacks) && !has_constant && !use.otherwise)
      complain_of_none(module, kernel, use);
  }

  void complain_of_two(const PhysicsModule& module, const PropertyUse& use,
                       const Supplier* const (&clash)[2], bool with_constant) {
    const std::string other =
        with_constant || clash[0] == nullptr ? "its own attribute" : text_of(*clash[0]);
    diagnostics_.error(module.location, named(module) + " gets '" + use.name + "' from " + other +
                                            " and from " + text_of(*clash[1]) +
                                            " on the same cells, and not both of them add; leave "
                                            "one out, or give each cells of its own");
  }

  void complain_of_none(const PhysicsModule& module, const Kernel& kernel, const PropertyUse& use) {
    std::set<std::string> names;
    for (const Supplier& supplier : suppliers_)
      names.insert(supplier.supply->source->property().name);
    const std::vector<std::string> known(names.begin(), names.end());
    diagnostics_.error(
        module.location,
        named(module) + " needs '" + use.name + "' (" + use.unit + ") on all of '" +
            kernel.domain().text() +
            "', and nobody gives it there: neither an attribute of the module, nor <property>, "
            "nor another module" +
            (known.empty() ? ""
                           : "; supplied are " + listed(known) + did_you_mean(use.name, known)));
  }

  const Mesh& mesh_;
  std::vector<PhysicsModule>& modules_;
  Diagnostics& diagnostics_;
  std::vector<Supplier> suppliers_;
};

}  // namespace

std::vector<char> cells_within(const Mesh& mesh, const Region& region, const Domain& on) {
  const Region& body = mesh.region(on);
  std::vector<char> within(static_cast<std::size_t>(region.size()), 0);
  if (body.vertices_per_cell != region.vertices_per_cell) return within;
  std::set<Vertices> cells;
  insert_cells(body, cells);
  for (LocalIndex cell = 0; cell < region.size(); ++cell)
    within[static_cast<std::size_t>(cell)] = cells.count(sorted_vertices(region, cell)) > 0 ? 1 : 0;
  return within;
}

void connect_properties(const Mesh& mesh, std::vector<PhysicsModule>& modules,
                        Diagnostics& diagnostics) {
  Connecting(mesh, modules, diagnostics).all();
}

}  // namespace hawser
