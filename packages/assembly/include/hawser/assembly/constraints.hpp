#pragma once
// Rows that are not balances: prescribed values, and the time scheme's kinematics of structures.
#include <vector>

#include "hawser/assembly/assembler.hpp"
#include "hawser/fields/moved_position.hpp"

namespace hawser {

/// value[row] is prescribed. Where the prescription depends on the moved position, `slope` is its
/// derivative with respect to that, and `displacement` says what moves the node.
struct PrescribedRow {
  LocalIndex row;
  double value;
  NodeDisplacement displacement{};
  double slope[3] = {0, 0, 0};
};

/// d = known + factor v on every structure node that is not prescribed; at rest v = 0, or
/// the state's drift, instead, and
/// the balance of momentum, which then holds d, finds d.
struct Kinematics {
  bool at_rest = false;       ///< in a steady solve
  double factor = 0;          ///< s
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
  /// The same for the assembled tangent; the system's layout says from now on what was replaced.
  void apply(const Kinematics& kinematics);

 private:
  bool finds_displacement(const Assembler::KinematicPair& pair, const Kinematics& kinematics) const;

  Assembler& assembler_;
  std::vector<PrescribedRow> rows_;
  std::vector<int> prescribed_;  // per owned row: index in rows_, or -1
};

}  // namespace hawser
