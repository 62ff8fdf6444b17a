#include "hawser/assembly/assembler.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Import.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <cmath>

#include "hawser/base/error.hpp"
#include "src/cell_failure.hpp"
#include "src/energy_sums.hpp"
#include "src/named_blocks.hpp"
#include "src/row_layout.hpp"
#include "src/sparsity.hpp"
#include "src/switches.hpp"

namespace hawser {
struct Assembler::Implementation {
  const DofMap* dofs;
  std::vector<KernelCells> kernels;
  Sparsity sparsity;
  BlockSystem system;
  Teuchos::RCP<const Tpetra::Import<>> ghosts;
  double* matrix_values = nullptr;
  std::vector<KinematicPair> pairs;
  EnergySums energy;

  Implementation(const DofMap& map, const std::vector<PhysicsModule>& modules)
      : dofs(&map), system{map.mesh().communicator, {}, {}, {}, {}, {}} {
    const Governance governance = find_governors(map, modules);
    for (int m = 0; m < static_cast<int>(modules.size()); ++m)
      for (const auto& kernel : modules[static_cast<std::size_t>(m)].kernels)
        kernels.push_back(
            resolve(map, governance, modules[static_cast<std::size_t>(m)], *kernel, m));
    make_maps();
    find_pairs(governance);
    std::vector<std::pair<LocalIndex, LocalIndex>> extra;
    for (const KinematicPair& pair : pairs)
      extra.emplace_back(pair.displacement, pair.velocity);
    sparsity = find_sparsity(map.owned(), kernels, extra);
    for (KernelCells& cells : kernels)
      find_positions(sparsity, cells);
    make_matrix();
    system.blocks = name_blocks(map, governance, kernels);
    system.layout = lay_out_rows(map, governance);
    for (const KinematicPair& pair : pairs)
      system.layout.followers.push_back({pair.displacement, pair.velocity});
    energy = EnergySums(kernels);
    for (std::size_t k = 0; k < kernels.size(); ++k)
      make_memory(kernels[k], modules[static_cast<std::size_t>(kernels[k].module)].name + "-" +
                                  std::to_string(k));
  }

  void make_maps() {
    using Map = TpetraMap;
    const auto comm = Teuchos::rcp(new Teuchos::MpiComm<int>(dofs->mesh().communicator.mpi()));
    const auto& global = dofs->global_rows();
    const auto unknown = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
    const Teuchos::ArrayView<const GlobalIndex> all(global.data(),
                                                    static_cast<Teuchos::Ordinal>(global.size()));
    system.rows = Teuchos::rcp(new Map(unknown, all.view(0, dofs->owned()), 0, comm));
    system.columns = Teuchos::rcp(new Map(unknown, all, 0, comm));
    ghosts = Teuchos::rcp(new Tpetra::Import<>(system.rows, system.columns));
  }

  // A ghost node may belong to a structure whose cells this rank does not hold: its owner knows.
  void find_pairs(const Governance& governance) {
    std::vector<double> driven(static_cast<std::size_t>(dofs->rows()), 0);
    for (std::size_t row = 0; row < governance.governor.size(); ++row)
      if (governance.governor[row] == Governance::kinematic) driven[row] = 1;
    spread(driven);
    for (LocalIndex row = 0; row < dofs->rows(); ++row) {
      if (driven[static_cast<std::size_t>(row)] == 0) continue;
      const RowInfo& info = dofs->info(row);
      const FieldDescription& field = dofs->fields()[static_cast<std::size_t>(info.field)];
      const int velocity = dofs->find(field.follows);
      const LocalIndex first = velocity < 0 ? -1 : dofs->first_row(velocity, info.kind, info.point);
      if (first < 0)
        throw DeckError("a structure's '" + field.name + "' needs the field '" + field.follows +
                        "' at the same nodes");
      pairs.push_back({row, first + info.component});
    }
  }

  void make_matrix() {
    using Matrix = TpetraMatrix;
    using Local = Matrix::local_matrix_device_type;
    typename Local::row_map_type::non_const_type row_begin("row_begin", sparsity.row_begin.size());
    typename Local::index_type columns("columns", sparsity.columns.size());
    typename Local::values_type values("values", sparsity.columns.size());
    std::copy(sparsity.row_begin.begin(), sparsity.row_begin.end(), row_begin.data());
    std::copy(sparsity.columns.begin(), sparsity.columns.end(), columns.data());
    system.matrix =
        Teuchos::rcp(new Matrix(system.rows, system.columns, row_begin, columns, values));
    system.matrix->expertStaticFillComplete(system.rows, system.rows, ghosts);
    const auto local = system.matrix->getLocalMatrixHost();
    matrix_values = local.values.data();
    // Positions were resolved for exactly this order.
    if (!std::equal(sparsity.columns.begin(), sparsity.columns.end(), local.graph.entries.data()))
      throw std::logic_error("Tpetra reordered the matrix's columns");
  }

  void spread(std::vector<double>& local) const {
    TpetraVector owned(system.rows);
    const auto view = owned.getDataNonConst();
    std::copy(local.begin(), local.begin() + dofs->owned(), view.begin());
    spread(owned, local);
  }

  void spread(const TpetraVector& owned, std::vector<double>& local) const {
    TpetraVector all(system.columns);
    all.doImport(owned, *ghosts, Tpetra::INSERT);
    const auto view = all.getData();
    local.assign(view.begin(), view.end());
  }
};

Assembler::Assembler(const DofMap& dofs, const std::vector<PhysicsModule>& modules)
    : implementation_(std::make_unique<Implementation>(dofs, modules)) {}
Assembler::~Assembler() = default;
Assembler::Assembler(Assembler&&) noexcept = default;

const DofMap& Assembler::dofs() const { return *implementation_->dofs; }
BlockSystem& Assembler::system() { return implementation_->system; }
const std::vector<Assembler::KinematicPair>& Assembler::kinematic_pairs() const {
  return implementation_->pairs;
}

void Assembler::residual(const State& state, std::vector<double>& total, int module) const {
  add_up(state, module, total, nullptr);
}

void Assembler::residual(const State& state, std::vector<double>& total,
                         std::vector<double>& magnitude) const {
  add_up(state, all_modules, total, &magnitude);
}

void Assembler::add_up(const State& state, int module, std::vector<double>& total,
                       std::vector<double>* magnitude) const {
  const DofMap& dofs = *implementation_->dofs;
  const auto owned = static_cast<std::size_t>(dofs.owned());
  total.assign(owned, 0);
  std::vector<double> levels;  // per row: what levels and facets contribute
  if (magnitude != nullptr) {
    magnitude->assign(owned, 0);
    levels.assign(owned, 0);
  }
  CellFailure failure;
  for (const KernelCells& cells : implementation_->kernels) {
    if (module != all_modules && cells.module != module) continue;
    const std::vector<char>& counts = module == all_modules ? cells.writes : cells.adds;
    const bool on_facets = cells.kernel->domain().kind == Domain::Kind::facets;
    const auto n = static_cast<std::size_t>(cells.unknowns());
    std::vector<double> local(n), scale(n);
    CellGatherer gatherer(cells, dofs.mesh(), state);
    for (LocalIndex cell = 0; cell < cells.region->size(); ++cell) {
      failure.note([&] { return cells.kernel->residual(gatherer.gather(cell), local.data()); },
                   cells, cell);
      const std::size_t begin = static_cast<std::size_t>(cell) * n;
      for (std::size_t i = 0; i < n; ++i)
        if (counts[begin + i] != 0)
          total[static_cast<std::size_t>(cells.rows[begin + i])] += local[i];
      if (magnitude == nullptr) continue;
      if (on_facets)
        std::fill(scale.begin(), scale.end(), 0);
      else if (cells.has_level())
        failure.note([&] { return cells.kernel->residual(gatherer.off_level(), scale.data()); },
                     cells, cell);
      else
        scale = local;
      for (std::size_t i = 0; i < n; ++i) {
        if (counts[begin + i] == 0) continue;
        const auto row = static_cast<std::size_t>(cells.rows[begin + i]);
        (*magnitude)[row] += std::abs(scale[i]);
        levels[row] += local[i] - scale[i];
      }
    }
  }
  for (std::size_t row = 0; row < levels.size(); ++row)
    (*magnitude)[row] += std::abs(levels[row]);
  failure.throw_together(dofs.mesh(), state);
}

void Assembler::hold_switches() { hawser::hold_switches(implementation_->kernels); }
bool Assembler::release_wrong_switches(const State& state) {
  return hawser::release_wrong_switches(implementation_->kernels, dofs().mesh(), state);
}
bool Assembler::release_switches() {
  return hawser::release_switches(implementation_->kernels, dofs().mesh().communicator);
}

void Assembler::tangent(const State& state) {
  const DofMap& dofs = *implementation_->dofs;
  double* const values = implementation_->matrix_values;
  std::fill(values, values + implementation_->sparsity.columns.size(), 0.0);
  CellFailure failure;
  for (const KernelCells& cells : implementation_->kernels) {
    const auto n = static_cast<std::size_t>(cells.unknowns());
    std::vector<double> local(n);
    std::vector<double> local_tangent(n * n);
    each_cell(cells, dofs.mesh(), state, [&](LocalIndex cell, const CellInput& input) {
      failure.note([&] { return cells.kernel->tangent(input, local.data(), local_tangent.data()); },
                   cells, cell);
      const int* const positions = &cells.positions[static_cast<std::size_t>(cell) * n * n];
      for (std::size_t k = 0; k < n * n; ++k)
        if (positions[k] >= 0) values[positions[k]] += local_tangent[k];
    });
  }
  failure.throw_together(dofs.mesh(), state);
  place_rows(dofs, state, system().layout);
}

std::vector<Assembler::CellValues> Assembler::cell_quantities(const Region& region,
                                                              const State& state) const {
  std::vector<CellValues> result;
  for (const KernelCells& cells : implementation_->kernels) {
    const Domain& domain = cells.kernel->domain();
    const auto& names = domain.regions;
    if (domain.kind != Domain::Kind::cells ||
        std::find(names.begin(), names.end(), region.name) == names.end())
      continue;
    const auto quantities = cells.kernel->quantities();
    if (quantities.empty()) continue;
    const std::size_t first = result.size();
    for (const auto& quantity : quantities)
      result.push_back({quantity.name,
                        quantity.unit + (quantity.per_depth ? dofs().mesh().per_depth() : ""),
                        {}});
    std::vector<double> values(quantities.size());
    CellGatherer gatherer(cells, dofs().mesh(), state);
    for (const LocalIndex cell : places_in(*cells.region, region)) {
      cells.kernel->evaluate(gatherer.gather(cell), values.data());
      for (std::size_t k = 0; k < values.size(); ++k)
        result[first + k].values.push_back(values[k]);
    }
  }
  return result;
}

void Assembler::begin_step() {
  for (CellMemory* const memory : memories())
    memory->accepted = memory->next;
}

void Assembler::remember(const State& state) {
  for (KernelCells& cells : implementation_->kernels) {
    if (cells.memory.per_cell == 0) continue;
    each_cell(cells, dofs().mesh(), state, [&](LocalIndex cell, const CellInput& input) {
      cells.kernel->advance_memory(input, &cells.memory.next[cells.memory_of(cell)]);
    });
  }
}

std::vector<CellMemory*> Assembler::memories() {
  std::vector<CellMemory*> result;
  for (KernelCells& cells : implementation_->kernels)
    if (cells.memory.per_cell > 0) result.push_back(&cells.memory);
  return result;
}

const std::vector<EnergyTerm>& Assembler::energy_terms() const {
  return implementation_->energy.terms();
}
std::vector<double> Assembler::powers(const State& state) const {
  return implementation_->energy.sum(implementation_->kernels, dofs().mesh(), state,
                                     &Kernel::powers);
}
std::vector<double> Assembler::energies(const State& state) const {
  return implementation_->energy.sum(implementation_->kernels, dofs().mesh(), state,
                                     &Kernel::energies);
}

double* Assembler::row_values(LocalIndex row) {
  return implementation_->matrix_values +
         implementation_->sparsity.row_begin[static_cast<std::size_t>(row)];
}
const LocalIndex* Assembler::row_columns(LocalIndex row) const {
  const Sparsity& sparsity = implementation_->sparsity;
  return sparsity.columns.data() + sparsity.row_begin[static_cast<std::size_t>(row)];
}
int Assembler::row_size(LocalIndex row) const {
  const auto& begin = implementation_->sparsity.row_begin;
  return static_cast<int>(begin[static_cast<std::size_t>(row) + 1] -
                          begin[static_cast<std::size_t>(row)]);
}

void Assembler::spread(const TpetraVector& owned, std::vector<double>& local) const {
  implementation_->spread(owned, local);
}
void Assembler::spread(std::vector<double>& local) const { implementation_->spread(local); }

}  // namespace hawser
