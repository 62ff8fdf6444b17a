#pragma once
// What a kernel is given of one cell: plain arrays.

namespace hawser {

/// One field on one cell; every array is [node][component].
struct FieldOnCell {
  const double* value;
  const double* rate;
  const double* accepted;    ///< value at the last accepted step
  const double* rate_slope;  ///< d rate / d value at the same node and component
  const double*
      rate_partner;  ///< d rate / d velocity at the same node and component (structures: 1)
};

struct CellInput {
  double time = 0;                      ///< s, at which the equations are formed
  double step = 0;                      ///< s; infinite in a steady solve
  const double* coordinates = nullptr;  ///< reference coordinates [vertex][dimension], m
  const FieldOnCell* fields = nullptr;  ///< in the order of Kernel::fields()
  const double* memory = nullptr;       ///< what the cell remembers of the last accepted step
  /// s, from the instant of what is remembered, at which that step's equations were formed, to
  /// `time`; infinite in a steady solve.
  double elapsed = 0;
  /// Of the step at which the equations are formed: it ends at accepted + (value - accepted)/share.
  double share = 1;
  /// Forces must do at least the work over the step that their energy gains.
  bool bounds_energy = false;
  bool held = false;  ///< the branch of a law that switches (Kernel::switches)
  /// [connection of Kernel::properties()]: 1 where that source holds on this cell; null: all do.
  const char* supplied = nullptr;
};

}  // namespace hawser
