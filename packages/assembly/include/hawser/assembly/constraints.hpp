#pragma once
// Rows that are not balances: prescribed values, and the time scheme's kinematics of structures.
#include <vector>

#include "hawser/assembly/assembler.hpp"

namespace hawser {

/// value[row] is prescribed. Where the prescription depends on the moved position, `slope` is its
/// derivative with respect to that and `displacement` the node's first displacement row, else -1.
struct PrescribedRow {
  LocalIndex row;
  double value;
  LocalIndex displacement = -1;
  double slope[3] = {0, 0, 0};
};

/// d = known + factor v on every structure node that is not prescribed.
struct Kinematics {
  double factor = 0;          ///< s; 0 in a steady solve
  std::vector<double> known;  ///< per pair of Assembler::kinematic_pairs(), m
};

class Constraints {
 public:
  explicit Constraints(Assembler& assembler);

  /// Owned rows only; a row that is given twice keeps the last.
  void prescribe(std::vector<PrescribedRow> rows);
  const std::vector<PrescribedRow>& prescribed() const { return rows_; }

  /// Replaces the constrained rows of an assembled residual and its magnitude.
  void apply(const State& state, const Kinematics& kinematics, std::vector<double>& residual,
             std::vector<double>& magnitude) const;
  /// The same for the assembled tangent.
  void apply(const Kinematics& kinematics);

 private:
  Assembler& assembler_;
  std::vector<PrescribedRow> rows_;
  std::vector<int> prescribed_;  // per owned row: index in rows_, or -1
};

}  // namespace hawser
