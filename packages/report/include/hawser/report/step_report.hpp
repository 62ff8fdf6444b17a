#pragma once
// How each step came about: Newton's method, the mesh; and what that was over the whole run.
#include "hawser/report/mesh_monitor.hpp"
#include "hawser/report/report.hpp"

namespace hawser {

class StepReport : public Report {
 public:
  explicit StepReport(const DofMap& dofs) : dofs_(dofs) {}

  void rejected() { ++rejected_; }
  const MeshFigures& mesh_figures() const { return mesh_; }  ///< of the last accepted step

  std::vector<Column> columns() const override;
  void save(CheckpointNotes& notes) const override;
  void resume(const CheckpointNotes& notes) override;
  std::vector<std::string> quantities() const override;
  void summarise(const Step& last, Summary& summary) const override;

 private:
  std::vector<double> measure(const Step& step) override;

  const DofMap& dofs_;
  MeshFigures mesh_;
  long long steps_ = 0, rejected_ = 0, newton_ = 0, linear_ = 0;
  double least_quality_ = 1, courant_ = 0;
};

}  // namespace hawser
