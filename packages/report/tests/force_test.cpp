#include "hawser/report/force.hpp"

#include <gtest/gtest.h>

#include "report_sample.hpp"

namespace hawser {
namespace {

TEST(Force, AcrossIsToTheLeftOfTheAxisInThePlane) {
  const Force force = split_force({3, 4}, {0, 2});  // seen from +y, left is -x
  EXPECT_DOUBLE_EQ(force.magnitude, 5);
  EXPECT_DOUBLE_EQ(force.along, 4);
  EXPECT_DOUBLE_EQ(force.across, -3);
}

TEST(Force, AcrossIsTheMagnitudeOfTheRestInSpace) {
  const Force force = split_force({3, 4, 12}, {0, 0, 5});
  EXPECT_DOUBLE_EQ(force.magnitude, 13);
  EXPECT_DOUBLE_EQ(force.along, 12);
  EXPECT_DOUBLE_EQ(force.across, 5);
}

/// Along +x; the load of a module is minus its residual.
double along(const ReportSample& sample, const std::string& attributes) {
  ReportRegistry registry;
  register_reports(registry);
  Diagnostics faults;
  Reports reports = sample.reports(registry, "<force name='f' " + attributes + "/>", faults);
  EXPECT_EQ(faults.error_text(), "");
  reports.accepted(sample.step());
  return reports.all().back()->values()[1];
}

TEST(Force, OfAModuleIsTheSumOverAllOfItsName) {
  const ReportSample sample;
  // Four segments of two nodes, each 10 of the one cable and 100 of the other.
  EXPECT_DOUBLE_EQ(along(sample, "on='cable' module='cable'"), -880);
  EXPECT_DOUBLE_EQ(along(sample, "on='tail' module='cable'"), -110);
  EXPECT_DOUBLE_EQ(along(sample, "on='tail' module='cable' axis='-1 0'"), 110);
}

TEST(Force, OfAllModulesIsTheReaction) {
  ReportSample sample;
  sample.reactions.assign(sample.reactions.size(), 2);
  EXPECT_DOUBLE_EQ(along(sample, "on='cable'"), 10);  // five nodes
}

TEST(Force, OfAModuleThatIsNotThereNamesTheOthers) {
  const ReportSample sample;
  ReportRegistry registry;
  register_reports(registry);
  Diagnostics faults;
  sample.reports(registry, "<force name='f' on='tail' module='cabel'/>", faults);
  EXPECT_NE(faults.error_text().find("did you mean 'cable'?"), std::string::npos);
}

}  // namespace
}  // namespace hawser
