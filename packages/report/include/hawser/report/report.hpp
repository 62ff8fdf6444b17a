#pragma once
// A report is to results what a module is to equations: it looks at accepted steps and gives
// columns of history.csv, quantities of summary.json, files of its own and words at the end.
#include <optional>
#include <string>
#include <vector>

#include "hawser/assembly/assembler.hpp"
#include "hawser/conditions/conditions.hpp"
#include "hawser/output/checkpoint.hpp"
#include "hawser/output/grid.hpp"
#include "hawser/output/history.hpp"
#include "hawser/output/summary.hpp"
#include "hawser/time/energy_ledger.hpp"
#include "hawser/values/tracks.hpp"

namespace hawser {

class LineGeometry;

/// An accepted step. The states hold until the next one begins.
struct Step {
  int number = 0;     ///< from 1; goes on in a restarted run
  double length = 0;  ///< s
  bool last = false;
  std::optional<double> local_error;  ///< relative, of the time scheme; none in the first steps
  int newton_iterations = 0, linear_iterations = 0;
  const State& end;      ///< at the end of the step
  const State& balance;  ///< at the instant of the equations: pressures and forces stand here
  const std::vector<double>& reactions;  ///< per owned row, what supports must supply; at `balance`
  const EnergyAccount* energy = nullptr;  ///< at the end of the step; none where nobody looks at it
};

/// What is known of a run before its first step.
struct Outlook {
  RunSpan span;
  const State& state;  ///< at which it begins
  const Conditions& conditions;
};

/// What a report is made for, beside its parameters. All but the tracks outlives the report.
struct ReportContext {
  const Assembler& assembler;
  const std::vector<PhysicsModule>& modules;
  const std::vector<RateRule>& rate_rules;  ///< per field
  const Tracks& tracks;
  const DofMap& dofs() const { return assembler.dofs(); }
  const Mesh& mesh() const { return assembler.dofs().mesh(); }
};

/// Where a run begins.
struct ReportStart {
  std::string folder;  ///< of the results
  const State& state;
  bool goes_on = false;  ///< a restarted run: files are continued from the state's time on
  std::optional<double> keep_until() const {
    return goes_on ? std::optional<double>(state.time) : std::nullopt;
  }
};

/// All members are called on all ranks together, in the order know(), look_ahead(); start() or
/// resume() and start(); per step accepted(), recorded() and write(); at the end summarise() and
/// closing().
class Report {
 public:
  Report() = default;
  virtual ~Report() = default;
  Report(const Report&) = delete;
  Report& operator=(const Report&) = delete;

  /// Its columns of history.csv; quantity_name() of them are quantities of the summary, too.
  virtual std::vector<Column> columns() const { return {}; }
  /// Names of the numbers that summarise() sets; those of the columns unless it sets others, too.
  /// A deck that expects another quantity is refused before the run.
  virtual std::vector<std::string> quantities() const;
  /// What it is asked for that this run will not have: an error where the answer would be wrong or
  /// missing, a note where that may be meant.
  virtual void look_ahead(const Outlook& /*outlook*/, Diagnostics& /*diagnostics*/) const {}

  /// For a report on other reports: all columns of history.csv, known before look_ahead().
  virtual void know(const std::vector<Column>& /*history*/, Diagnostics& /*diagnostics*/) {}

  void accepted(const Step& step) { values_ = measure(step); }
  const std::vector<double>& values() const { return values_; }  ///< of the last step, per column

  /// The values of the columns that know() named, once all reports have looked at a step.
  virtual void recorded(const std::vector<double>& /*row*/) {}

  virtual void start(const ReportStart& /*start*/) {}
  /// Files of its own; `fields_due` when fields are written, too.
  virtual void write(const Step& /*step*/, bool /*fields_due*/) {}

  /// What a restarted run goes on with.
  virtual void save(CheckpointNotes& /*notes*/) const {}
  virtual void resume(const CheckpointNotes& /*notes*/) {}

  /// Quantities of the whole run; by default the columns as they were last.
  virtual void summarise(const Step& last, Summary& summary) const;
  /// Lines for a person at the end; empty when there is nothing to say.
  virtual std::string closing() const { return {}; }

  /// Whether Step::energy is to be kept for it, which costs an evaluation of all kernels per step.
  virtual bool looks_at_energy() const { return false; }
  /// A line that it has put in order; its grid is written in that order, with the arc length.
  virtual const LineGeometry* line() const { return nullptr; }
  /// Adds fields to the grid of a line region: a value per owned vertex of it, these ascending.
  virtual void add_fields(const Region& /*line*/, const State& /*state*/,
                          std::vector<PointField>& /*fields*/) const {}

 protected:
  /// One value per column, the same on all ranks.
  virtual std::vector<double> measure(const Step& /*step*/) { return {}; }

 private:
  std::vector<double> values_;
};

}  // namespace hawser
