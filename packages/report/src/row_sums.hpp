#pragma once
// Sums over the rows of a field on a region: the reaction of what supports it there, or the load of
// one module.
#include "hawser/report/report.hpp"

namespace hawser {

/// What a deck says: of which module, where several have its name.
struct LoadDeck {
  std::string name;                             ///< of the report
  std::string kind;                             ///< its tag
  Located<std::vector<std::string>> on;         ///< regions; a node of several counts once
  Located<std::string> field;                   ///< by name
  Located<std::string> module{"all", {}};       ///< all: the reaction
  Located<std::vector<std::string>> module_on;  ///< all when empty
};

class RowSums {
 public:
  RowSums(LoadDeck deck, const ReportContext& context, Diagnostics& diagnostics);

  /// -1 where there is none.
  int field() const { return field_; }
  const std::vector<LocalIndex>& rows() const { return rows_; }  ///< first components, owned
  bool of_reaction() const { return modules_.empty(); }
  /// What comes to the region's nodes: the reaction, or the modules' load, which is minus their
  /// residual. Per component, on all ranks. Collective.
  std::vector<double> sum(const Step& step) const;

 private:
  void choose_modules(const std::vector<PhysicsModule>& modules, Diagnostics& diagnostics);
  void note_a_sum(const std::vector<PhysicsModule>& modules,
                  const std::vector<LocalIndex>& vertices, Diagnostics& diagnostics) const;

  const Assembler& assembler_;
  LoadDeck deck_;
  int field_ = -1;
  std::vector<int> modules_;      // none: the reaction
  std::vector<LocalIndex> rows_;  // of the first component, owned
};

}  // namespace hawser
