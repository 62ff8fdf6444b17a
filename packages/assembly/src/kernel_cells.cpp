#include "src/kernel_cells.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "hawser/assembly/connect_properties.hpp"
#include "hawser/base/error.hpp"
#include "hawser/element/quadrature_degree.hpp"

namespace hawser {
namespace {

/// Point kernels have shape functions on cells that fill the space, and on facets those of the
/// cells behind them; others know their own.
void bind_shapes(const DofMap& dofs, const Region& region, const KernelCells& cells,
                 Kernel& kernel) {
  const bool on_facets = region.dimension < dofs.mesh().dimension;
  if (traits(region.shape).dimension < dofs.mesh().dimension) return kernel.bind({});
  std::vector<Basis> bases;
  std::vector<FieldInForm> form;
  for (std::size_t f = 0; f < cells.fields.size(); ++f) {
    const int field = cells.fields[f];
    const FieldUse& use = kernel.fields()[f];
    bases.push_back(field < 0 ? use.basis.value_or(Basis::p1)
                              : dofs.fields()[static_cast<std::size_t>(field)].basis);
    form.push_back({bases.back(), (use.needs & (need::value | need::rate)) != 0,
                    (use.needs & (need::gradient | need::accepted)) != 0, has_rows(use.role)});
  }
  const int degree = quadrature_degree(region.shape, form);
  kernel.bind(tabulate_cell(bases, on_facets ? facet_quadrature(region.shape, degree)
                                             : quadrature(region.shape, degree)));
}

void find_suppliers(const Mesh& mesh, const Region& region, const Kernel& kernel,
                    std::vector<char>& supplied) {
  const auto& connections = kernel.properties().connections();
  supplied.resize(static_cast<std::size_t>(region.size()) * connections.size());
  for (std::size_t k = 0; k < connections.size(); ++k) {
    const std::vector<char> holds = cells_within(mesh, region, connections[k].on);
    for (std::size_t cell = 0; cell < holds.size(); ++cell)
      supplied[cell * connections.size() + k] = holds[cell];
  }
}

}  // namespace

KernelCells resolve(const DofMap& dofs, const Governance& governance, const PhysicsModule& module,
                    Kernel& kernel, int module_index) {
  KernelCells cells;
  const Region& region = dofs.mesh().region(kernel.domain());
  cells.kernel = &kernel;
  cells.region = &region;
  cells.module = module_index;
  if (!module.plugin.empty()) cells.stranger = named(module);
  const std::string who = named(module) + " on '" + region.name + "'";
  const std::vector<CellShape> shapes = kernel.shapes();
  if (std::find(shapes.begin(), shapes.end(), region.shape) == shapes.end())
    throw PluginError(who + " is written for " + traits(shapes.front()).plural +
                      ", and that region is one of " + traits(region.shape).plural);
  for (const FieldUse& use : kernel.fields()) {
    cells.fields.push_back(dofs.find(use.name));
    const int field = cells.fields.back();
    if (field >= 0 && dofs.fields()[static_cast<std::size_t>(field)].has_level)
      cells.levels.push_back(static_cast<int>(cells.fields.size()) - 1);
  }
  bind_shapes(dofs, region, cells, kernel);
  find_suppliers(dofs.mesh(), region, kernel, cells.supplied);
  int unknowns = 0;
  for (std::size_t f = 0; f < cells.fields.size(); ++f) {
    const FieldUse& use = kernel.fields()[f];
    const int field = cells.fields[f];
    const int nodes = kernel.nodes(f);
    if (field >= 0 && dofs.nodes_per_cell(field, region) != nodes)
      throw DeckError(module.location.text() + ": " + who + " is written for " +
                      std::to_string(nodes) + " nodes of the field '" + use.name +
                      "' per cell, and in " +
                      to_string(dofs.fields()[static_cast<std::size_t>(field)].basis) + " it has " +
                      std::to_string(dofs.nodes_per_cell(field, region)));
    cells.first.push_back(unknowns);
    unknowns += use.components * nodes;
    if (use.follows != nullptr && (use.needs & need::rate) != 0 && kernel.rate_partner(f) < 0)
      throw PluginError(who + " looks at the rate of '" + use.name + "' and must list '" +
                        use.follows + "' too, which is that rate on structures");
  }
  cells.first.push_back(unknowns);
  if (kernel.switches()) cells.held.assign(static_cast<std::size_t>(region.size()), 0);

  std::vector<LocalIndex> first_rows;
  for (LocalIndex cell = 0; cell < region.size(); ++cell)
    for (std::size_t f = 0; f < cells.fields.size(); ++f) {
      const FieldUse& use = kernel.fields()[f];
      first_rows.clear();
      if (cells.fields[f] >= 0)
        dofs.append_cell_rows(cells.fields[f], region, cell, first_rows);
      else
        first_rows.assign(static_cast<std::size_t>(kernel.nodes(f)), -1);
      for (const LocalIndex first : first_rows)
        for (int c = 0; c < use.components; ++c) {
          const LocalIndex row = first < 0 ? -1 : first + c;
          const bool adds = row >= 0 && row < dofs.owned() && has_rows(use.role);
          bool writes = adds;
          if (adds) {
            const int governor = governance.governor[static_cast<std::size_t>(row)];
            writes = governor == Governance::shared || governor == module_index;
          }
          cells.rows.push_back(row);
          cells.adds.push_back(adds ? 1 : 0);
          cells.writes.push_back(writes ? 1 : 0);
        }
    }
  return cells;
}

void make_memory(KernelCells& cells, std::string name) {
  CellMemory& memory = cells.memory;
  memory.name = std::move(name);
  memory.region = cells.region;
  memory.per_cell = cells.kernel->memory_per_cell();
  memory.accepted.assign(cells.memory_of(cells.region->size()), 0);
  memory.next = memory.accepted;
}

CellGatherer::CellGatherer(const KernelCells& cells, const Mesh& mesh, const State& state)
    : cells_(cells), mesh_(mesh), state_(state) {
  const auto n = static_cast<std::size_t>(cells.unknowns());
  for (auto* array : {&value_, &rate_, &accepted_, &slope_, &partner_})
    array->resize(n);
  coordinates_.resize(static_cast<std::size_t>(cells.region->vertices_per_cell * mesh.dimension));
  for (std::size_t f = 0; f + 1 < cells.first.size(); ++f) {
    const auto first = static_cast<std::size_t>(cells.first[f]);
    fields_.push_back(
        {&value_[first], &rate_[first], &accepted_[first], &slope_[first], &partner_[first]});
  }
  input_ = {state.time,    state.step,  coordinates_.data(), fields_.data(), nullptr,
            state.elapsed, state.share, state.bounds_energy, false,          nullptr};
}

const CellInput& CellGatherer::gather(LocalIndex cell) {
  const std::size_t n = value_.size();
  if (!cells_.held.empty()) input_.held = cells_.held[static_cast<std::size_t>(cell)] != 0;
  if (!cells_.supplied.empty())
    input_.supplied = &cells_.supplied[static_cast<std::size_t>(cell) *
                                       cells_.kernel->properties().connections().size()];
  const LocalIndex* const rows = &cells_.rows[static_cast<std::size_t>(cell) * n];
  for (std::size_t i = 0; i < n; ++i) {
    if (rows[i] < 0) {
      value_[i] = rate_[i] = accepted_[i] = slope_[i] = partner_[i] = 0;
      continue;
    }
    const auto row = static_cast<std::size_t>(rows[i]);
    value_[i] = state_.value[row];
    rate_[i] = state_.rate[row];
    accepted_[i] = state_.accepted[row];
    slope_[i] = state_.rate_slope[row];
    partner_[i] = state_.rate_partner[row];
  }
  const auto per_cell = static_cast<std::size_t>(cells_.region->vertices_per_cell);
  const auto dimension = static_cast<std::size_t>(mesh_.dimension);
  for (std::size_t v = 0; v < per_cell; ++v) {
    const auto vertex = static_cast<std::size_t>(
        cells_.region->vertices[static_cast<std::size_t>(cell) * per_cell + v]);
    for (std::size_t j = 0; j < dimension; ++j)
      coordinates_[v * dimension + j] = mesh_.coordinates[vertex * dimension + j];
  }
  if (cells_.memory.per_cell > 0) input_.memory = &cells_.memory.accepted[cells_.memory_of(cell)];
  return input_;
}

const CellInput& CellGatherer::off_level() {
  for (const int field : cells_.levels) {
    const auto f = static_cast<std::size_t>(field);
    const auto components = static_cast<std::size_t>(cells_.kernel->fields()[f].components);
    const auto first = static_cast<std::size_t>(cells_.first[f]);
    const auto last = static_cast<std::size_t>(cells_.first[f + 1]);
    for (std::size_t c = 0; c < components; ++c) {
      double mean = 0;
      for (std::size_t i = first + c; i < last; i += components)
        mean += value_[i];
      mean *= static_cast<double>(components) / static_cast<double>(last - first);
      for (std::size_t i = first + c; i < last; i += components)
        value_[i] -= mean;
    }
  }
  return input_;
}

}  // namespace hawser
