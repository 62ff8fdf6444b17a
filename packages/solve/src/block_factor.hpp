#pragma once
// Block lower Gauss-Seidel over the groups of rows that the system's layout declares: prescribed
// rows are known; each group is solved with its followers taken out (u = factor * leader + known),
// in the layout's order; followers follow. Of a fluid, a structure in it and the mesh's motion it
// drops only what the mesh's place does to the flow.
#include <memory>
#include <vector>

#include "group_solver.hpp"
#include "hawser/solve/factor.hpp"

namespace hawser {

class BlockFactor : public Factor {
 public:
  /// Both must outlive this.
  BlockFactor(const BlockSystem& system, const RowScaling& scaling, const LinearOptions& options);
  ~BlockFactor() override;

  void symbolic(const Teuchos::RCP<const TpetraMatrix>& matrix) override;
  void numeric() override;
  void adapt() override;
  bool fall_back() override;
  void start_over() override;
  std::vector<std::string> take_notes() override;
  void solve(const TpetraMultiVector& b, TpetraMultiVector& x) const override;

 private:
  void build();
  void take();
  void solve_known(const TpetraVector& b, TpetraVector& x) const;
  void follow(const TpetraVector& b, TpetraVector& x) const;

  const BlockSystem& system_;
  const RowScaling& scaling_;
  const LinearOptions wanted_;
  LinearOptions options_;
  bool as_one_ = false;  ///< one complete factor of all rows
  Teuchos::RCP<const TpetraMatrix> matrix_;
  std::vector<std::unique_ptr<GroupSolver>> groups_;
  std::vector<char> prescribed_;  ///< RowLayout::prescribed that the groups were built for
  std::vector<LocalIndex> known_, following_;  ///< owned rows
  std::vector<double> unscale_;                ///< per owned row
  Teuchos::RCP<TpetraVector> all_;             ///< with ghosts
  std::string told_;                           ///< the last note
  std::vector<std::string> notes_;
};

}  // namespace hawser
