#pragma once
// The flow on the moved mesh, and a cable as a grid of its own.
#include <memory>
#include <string>

#include "hawser/assembly/assembler.hpp"
#include "hawser/output/field_writer.hpp"
#include "src/tow_report.hpp"

namespace hawser {

class FieldOutput {
 public:
  /// `tow` may be null. `keep_until`: steps of an earlier run that stay (a restart), else -1.
  FieldOutput(const Assembler& assembler, const TowReport* tow, const std::string& folder,
              int keep_until);

  /// Collective; OutputError on all ranks.
  void write(int step, const State& state);

 private:
  void write_flow(int step, const State& state);
  void write_cable(int step, const State& state);

  const Assembler& assembler_;
  const DofMap& dofs_;
  const TowReport* tow_;
  std::unique_ptr<FieldWriter> flow_, cable_;  // null where there is no body, no tow report
};

}  // namespace hawser
