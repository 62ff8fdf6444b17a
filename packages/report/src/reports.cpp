#include "hawser/report/reports.hpp"

#include <algorithm>
#include <set>

namespace hawser {
namespace {

/// Within a checkpoint, which knows the deck: the number of a report tells it from others.
std::string prefix(std::size_t report) { return "report" + std::to_string(report) + "."; }

}  // namespace

Reports::Reports(const std::vector<PlannedReport>& planned, const ReportContext& context,
                 Diagnostics& diagnostics)
    : communicator_(context.mesh().communicator) {
  auto steps = std::make_unique<StepReport>(context.dofs());
  steps_ = steps.get();
  all_.push_back(std::move(steps));
  std::set<std::string> names;
  const auto add_names = [&](const Report& report, const Location& where) {
    for (const Column& column : report.columns())
      if (!names.insert(quantity_name(column)).second)
        diagnostics.error(where, "another report has a column '" + quantity_name(column) +
                                     "', too; give one of them another name");
  };
  add_names(*steps_, {});
  for (const PlannedReport& plan : planned) {
    const std::size_t before = diagnostics.error_count();
    all_.push_back(plan.make(context, diagnostics));
    if (diagnostics.error_count() == before) add_names(*all_.back(), plan.location);
  }
  const std::vector<Column> history = columns();
  for (const auto& report : all_)
    report->know(history, diagnostics);
}

std::vector<Column> Reports::columns() const {
  std::vector<Column> columns;
  for (const auto& report : all_) {
    const std::vector<Column> own = report->columns();
    columns.insert(columns.end(), own.begin(), own.end());
  }
  return columns;
}

void Reports::look_ahead(const Outlook& outlook, Diagnostics& diagnostics) const {
  for (const auto& report : all_)
    report->look_ahead(outlook, diagnostics);
}

void Reports::start(const ReportStart& start) {
  history_ = std::make_unique<History>(communicator_, start.folder + "/history.csv", columns(),
                                       start.keep_until());
  for (const auto& report : all_)
    report->start(start);
}

void Reports::accepted(const Step& step) {
  for (const auto& report : all_)
    report->accepted(step);
  row_.clear();
  for (const auto& report : all_)
    row_.insert(row_.end(), report->values().begin(), report->values().end());
  for (const auto& report : all_)
    report->recorded(row_);
}

void Reports::write(const Step& step, bool history_due, bool fields_due) {
  if (history_due) history_->append(row_);
  for (const auto& report : all_)
    report->write(step, fields_due);
}

void Reports::save(CheckpointHeader& header) const {
  for (std::size_t i = 0; i < all_.size(); ++i) {
    CheckpointNotes notes;
    all_[i]->save(notes);
    header.add(prefix(i), notes);
  }
}

void Reports::resume(const CheckpointHeader& header) {
  for (std::size_t i = 0; i < all_.size(); ++i)
    all_[i]->resume(header.part(prefix(i)));
}

void Reports::summarise(const Step& last, Summary& summary) const {
  // What the deck asks for comes before how it came about.
  for (std::size_t i = 1; i < all_.size(); ++i)
    all_[i]->summarise(last, summary);
  steps_->summarise(last, summary);
}

std::string Reports::closing() const {
  std::string text;
  for (const auto& report : all_)
    text += report->closing();
  return text;
}

std::vector<std::string> Reports::quantities() const {
  std::vector<std::string> names;
  for (const auto& report : all_)
    for (const std::string& name : report->quantities())
      names.push_back(name);
  return names;
}

std::vector<std::string> Report::quantities() const {
  std::vector<std::string> names;
  for (const Column& column : columns())
    names.push_back(quantity_name(column));
  return names;
}

void Report::summarise(const Step& /*last*/, Summary& summary) const {
  const std::vector<Column> all = columns();
  for (std::size_t i = 0; i < all.size(); ++i)
    summary.set(quantity_name(all[i]), values_[i]);
}

}  // namespace hawser
