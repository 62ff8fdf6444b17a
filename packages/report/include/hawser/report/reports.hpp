#pragma once
// All reports of a run, driven together; history.csv is the columns of all, one after the other.
#include <memory>
#include <string>
#include <vector>

#include "hawser/report/report_registry.hpp"
#include "hawser/report/step_report.hpp"

namespace hawser {

class Reports {
 public:
  /// The figures of the steps first, then what the deck asks for. Names that the mesh or the
  /// modules do not know, and columns that two reports want, go to `diagnostics`. Collective.
  Reports(const std::vector<PlannedReport>& planned, const ReportContext& context,
          Diagnostics& diagnostics);

  /// As Report has them.
  void look_ahead(const Outlook& outlook, Diagnostics& diagnostics) const;
  void start(const ReportStart& start);
  void accepted(const Step& step);
  void write(const Step& step, bool history_due, bool fields_due);
  void save(CheckpointHeader& header) const;
  void resume(const CheckpointHeader& header);
  void summarise(const Step& last, Summary& summary) const;
  std::string closing() const;
  std::vector<std::string> quantities() const;  ///< that the summary will have
  void rejected() { steps_->rejected(); }

  const MeshFigures& mesh_figures() const { return steps_->mesh_figures(); }
  const std::vector<std::unique_ptr<Report>>& all() const { return all_; }

 private:
  std::vector<Column> columns() const;  ///< of history.csv

  Communicator communicator_;
  std::vector<std::unique_ptr<Report>> all_;
  StepReport* steps_;
  std::vector<double> row_;  // of history.csv, of the last step
  std::unique_ptr<History> history_;
};

}  // namespace hawser
