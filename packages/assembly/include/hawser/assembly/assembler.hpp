#pragma once
// The element loop: from a state to the residual and the block system's matrix.
#include <memory>
#include <string>
#include <vector>

#include "hawser/algebra/block_system.hpp"
#include "hawser/assembly/cell_memory.hpp"
#include "hawser/assembly/governance.hpp"
#include "hawser/fields/state.hpp"

namespace hawser {

class Assembler {
 public:
  /// `dofs` and `modules` must outlive the assembler. Collective. PluginError or DeckError when a
  /// kernel does not fit the cells of its region or a field's basis.
  Assembler(const DofMap& dofs, const std::vector<PhysicsModule>& modules);
  ~Assembler();
  Assembler(Assembler&&) noexcept;
  Assembler& operator=(Assembler&&) = delete;

  const DofMap& dofs() const;
  BlockSystem& system();

  /// Local displacement rows (owned and ghost) that follow the velocity, and their velocity rows.
  struct KinematicPair {
    LocalIndex displacement;
    LocalIndex velocity;
  };
  const std::vector<KinematicPair>& kinematic_pairs() const;

  static constexpr int all_modules = -1;

  /// total[owned row] = sum of the kernels' contributions, before any condition. With a module's
  /// index: what that module alone adds, also to rows it does not govern. SolveError on all ranks
  /// when a cell is inverted or a contribution not finite.
  void residual(const State& state, std::vector<double>& total, int module = all_modules) const;

  /// Also the scale of each row, the sum of the cells' absolute contributions. A field that has a
  /// level (a pressure) enters the cells without its mean there; what the means contribute enters
  /// as one sum, together with what stands on facets: a pressure's gradient and the traction that
  /// holds it, however high both are.
  void residual(const State& state, std::vector<double>& total,
                std::vector<double>& magnitude) const;

  /// Laws that switch keep the branch of the accepted state in all cells, from now on.
  void hold_switches();
  /// The law itself from now on in the cells whose branch is not the one held; whether there are
  /// any. Collective.
  bool release_wrong_switches(const State& state);
  /// The law itself in all cells; whether a branch was held in any. Collective.
  bool release_switches();

  /// The tangent of all kernels in system().matrix, before any condition. Same errors.
  void tangent(const State& state);

  /// What the kernels on a region report for output, per local cell of that region.
  struct CellValues {
    std::string name;
    std::string unit;
    std::vector<double> values;
  };
  std::vector<CellValues> cell_quantities(const Region& region, const State& state) const;

  /// From here on, residuals read what the last accepted step left.
  void begin_step();
  /// What the cells will remember of `state`, in which a step was accepted; read from the next
  /// begin_step() on.
  void remember(const State& state);
  /// Of all kernels whose cells remember something; valid as long as the assembler.
  std::vector<CellMemory*> memories();
  /// Terms of the energy balance of all kernels; per term, what they come to: W at the instant of
  /// the equations (supplied ones negative), J at the state's own. Sums over the cells of all
  /// ranks; collective.
  const std::vector<EnergyTerm>& energy_terms() const;
  std::vector<double> powers(const State& state) const;
  std::vector<double> energies(const State& state) const;

  // Rows of the matrix, for conditions: local columns ascending.
  double* row_values(LocalIndex row);
  const LocalIndex* row_columns(LocalIndex row) const;
  int row_size(LocalIndex row) const;

  /// Copies owned values into `local` and fills its ghost entries from their owners. Collective.
  void spread(const TpetraVector& owned, std::vector<double>& local) const;
  void spread(std::vector<double>& local) const;  ///< the same from the owned entries of `local`

 private:
  void add_up(const State& state, int module, std::vector<double>& total,
              std::vector<double>* magnitude) const;

  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace hawser
