// Reports of a kind of their own, registered, driven, saved and resumed.
#include "hawser/report/reports.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "hawser/base/error.hpp"
#include "report_sample.hpp"

namespace hawser {
namespace {

/// Counts steps; a column, a note for restarts and a word at the end.
class Counter : public Report {
 public:
  struct Parameters {
    std::string name;
    static Spec<Parameters> spec() {
      return Spec<Parameters>("counter", "Counts steps.")
          .attribute("name", &Parameters::name, required(), "Start of its column.");
    }
  };
  Counter(const Parameters& deck, const ReportContext& /*context*/, Diagnostics& /*faults*/)
      : name_(deck.name) {}
  std::vector<Column> columns() const override { return {{name_ + "_count", "1"}}; }
  void save(CheckpointNotes& notes) const override { notes.numbers["count"] = count_; }
  void resume(const CheckpointNotes& notes) override { count_ = notes.numbers.at("count"); }
  std::string closing() const override { return name_ + "\n"; }

 private:
  std::vector<double> measure(const Step& /*step*/) override { return {++count_}; }
  std::string name_;
  double count_ = 0;
};

class Silent : public Report {
 public:
  struct Parameters {
    int unused = 0;
    static Spec<Parameters> spec() { return Spec<Parameters>("silent", "Nothing."); }
  };
  Silent(const Parameters& /*deck*/, const ReportContext& /*context*/, Diagnostics& /*faults*/) {}
};

ReportRegistry registry() {
  ReportRegistry result;
  result.add<Silent>();
  result.add<Counter>();
  return result;
}

std::string text_of(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(ReportRegistry, ReadsInTheOrderOfRegistrationAndThenOfTheDeck) {
  const ReportSample sample;
  Diagnostics faults;
  Reports reports =
      sample.reports(registry(), "<counter name='a'/><silent/><counter name='b'/>", faults);
  EXPECT_EQ(faults.error_text(), "");
  ASSERT_EQ(reports.all().size(), 4U);  // the figures of the steps are the first
  EXPECT_EQ(reports.all()[1]->columns().size(), 0U);
  EXPECT_EQ(reports.closing(), "a\nb\n");
}

TEST(ReportRegistry, RefusesATagTwiceAndReportsAnUnknownOne) {
  ReportRegistry twice = registry();
  EXPECT_THROW(twice.add<Counter>(), PluginError);
  const ReportSample sample;
  Diagnostics faults;
  sample.reports(registry(), "<countr name='a'/>", faults);
  EXPECT_NE(faults.error_text().find("did you mean 'counter'?"), std::string::npos);
}

TEST(Reports, TwoMustNotWantOneColumn) {
  const ReportSample sample;
  Diagnostics faults;
  sample.reports(registry(), "<counter name='a'/>\n<counter name='a'/>", faults);
  EXPECT_EQ(faults.error_text(),
            "d.xml:2:2: another report has a column 'a_count', too; give one of them another name");
}

TEST(Reports, WriteOneHistoryAndSummariseTheLastRow) {
  const ReportSample sample;
  Diagnostics faults;
  Reports reports = sample.reports(registry(), "<counter name='a'/><counter name='b'/>", faults);
  reports.start({".", sample.state, false});
  for (const int number : {1, 2}) {
    reports.accepted(sample.step(number));
    reports.write(sample.step(number), number == 2, false);
  }
  // Right-angled triangles: 4 sqrt(3) A / (sum of squared edges) = sqrt(3)/2.
  EXPECT_EQ(text_of("history.csv"),
            "t_s,t_balance_s,step_s,local_error,newton_iterations,linear_iterations,"
            "mesh_quality_min,courant_max,a_count,b_count\n"
            "0,0,0.5,0.25,3,7,0.866025403784,0,2,2\n");
  Summary summary;
  reports.summarise(sample.step(2), summary);
  EXPECT_EQ(summary.number("b_count"), 2);
  EXPECT_EQ(summary.number("steps"), 2);
  EXPECT_EQ(summary.number("newton_iterations"), 6);
  EXPECT_EQ(summary.number("linear_iterations_mean"), 14.0 / 6);
}

TEST(Reports, EachResumesWithItsOwnNotes) {
  const ReportSample sample;
  Diagnostics faults;
  const std::string deck = "<counter name='a'/><counter name='b'/>";
  Reports first = sample.reports(registry(), deck, faults);
  first.accepted(sample.step(1));
  first.all()[2]->accepted(sample.step(1));  // b is one ahead
  CheckpointHeader header;
  first.save(header);
  Reports second = sample.reports(registry(), deck, faults);
  second.resume(header);
  second.accepted(sample.step(2));
  EXPECT_EQ(second.all()[1]->values(), std::vector<double>{2});
  EXPECT_EQ(second.all()[2]->values(), std::vector<double>{3});
  Summary summary;
  second.summarise(sample.step(2), summary);
  EXPECT_EQ(summary.number("steps"), 2);
}

}  // namespace
}  // namespace hawser
