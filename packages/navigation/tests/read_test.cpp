// Files of navigation, as they are and as they should not be.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "hawser/navigation/navigation_line.hpp"

namespace hawser {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

NavigationLine read(const std::string& text, const NavigationOptions& options = {}) {
  Diagnostics diagnostics;
  NavigationLine line = read_navigation(text, "line", options, diagnostics);
  EXPECT_EQ(diagnostics.error_text(), "");
  return line;
}

std::string fault(const std::string& text, const NavigationOptions& options = {}) {
  Diagnostics diagnostics;
  read_navigation(text, "line", options, diagnostics);
  return diagnostics.error_text();
}

TEST(Csv, ColumnsStandInAnyOrderAndUnit) {
  const NavigationLine line =
      read("north_km,receiver,time_min,shot,easting_m\n0.2,3,1,7,10\n0.1,1,1,7,20\n.3,1,2,8,30\n");
  EXPECT_EQ(line.format, "CSV");
  EXPECT_THAT(line.receivers, ElementsAre(1, 3));
  ASSERT_EQ(line.shots.size(), 2U);
  EXPECT_EQ(line.shots[1].number, 8);
  EXPECT_EQ(line.shots[1].time, 120);
  EXPECT_EQ(line.shots[0].places[1], (Place{10, 200}));
  EXPECT_FALSE(is_known(line.shots[1].places[1]));
}

TEST(Csv, AnEmptyPlaceIsMissing) {
  const NavigationLine line =
      read("shot,receiver,east_m,north_m\n1,0,,\n1,8,2,3\n2,0,4,5\n2,8,6,7\n");
  EXPECT_FALSE(is_known(line.shots[0].places[0]));
  EXPECT_FALSE(line.has_times());
}

TEST(Csv, TellsWhatIsWrong) {
  EXPECT_THAT(fault("shot,receiver,east,north_m\n1,0,0,0\n"),
              HasSubstr("line:1:15: the column 'east' says no unit"));
  EXPECT_THAT(fault("shot,recever,east_m,north_m\n1,0,0,0\n"),
              HasSubstr("there is no column 'recever'"));
  EXPECT_THAT(fault("shot,receiver,east_m\n1,0,0\n"), HasSubstr("a column is missing: north_m"));
  EXPECT_THAT(fault("shot,receiver,east_m,x_m,north_m\n1,0,0,0,0\n"),
              HasSubstr("hold the same quantity"));
  EXPECT_THAT(fault("shot,receiver,east_m,north_m\n1,0,0,0\n1,0,0,0\n2,0,0,0\n"),
              HasSubstr("receiver 0 of shot 1 is given twice"));
  EXPECT_THAT(fault("shot,receiver,east_m,north_m\n1,0,0,0\n2,0,0,0\n1,8,0,0\n"),
              HasSubstr("line:4:1: shot 1 was there already"));
  EXPECT_THAT(fault("shot,receiver,east_m,north_m\n1.5,0,0,0\n2,0,0,0\n"),
              HasSubstr("the number of a shot is whole"));
  EXPECT_THAT(fault("shot,receiver,east_m,north_m,time_s\n1,0,0,0,5\n2,0,0,0,4\n"),
              HasSubstr("the time of shot 2 is not after that of shot 1"));
  EXPECT_THAT(fault("shot,receiver,east_m,north_m,time_s\n1,0,0,0,5\n1,8,0,0,6\n2,0,0,0,9\n"),
              HasSubstr("the time is another one"));
  EXPECT_THAT(fault("shot,receiver,east_m,north_m\n1,0,0,0\n1,8,0,0\n"),
              HasSubstr("two shots at least"));
  EXPECT_THAT(fault("shot,receiver,east_m,north_m\n1,0,abc,0\n2,0,0,0\n"),
              HasSubstr("line:2:5: 'abc' is no number"));
}

// Columns from 1:         S: 2-13 line, 20-25 point, 26-46 latitude and longitude, 47-55 easting,
// 56-64 northing, 71-79 time
const std::string header =
    "H0202TAPE VERSION                UKOOA P1/90\nH1500DATUM                       WGS84\n";
std::string source(int point, const std::string& clock) {
  char text[96];
  std::snprintf(text, sizeof text,
                "SSYNTHETIC01      1%6d000000.00N0000000.00E 500000.0 100000.0 100.0%9s ", point,
                clock.c_str());
  return std::string(text) + "\n";
}
std::string receivers(double east, char streamer) {
  char text[96];
  std::snprintf(text, sizeof text, "R%4d%9.1f%9.1f%4.1f%4d%9.1f%9.1f%4.1f%26s%c\n", 1, east,
                100000.0, 8.0, 2, east - 12.5, 100000.4, 8.2, "", streamer);
  return text;
}

TEST(P190, ReadsShotsTimesReceiversAndDepths) {
  const NavigationLine line = read(header + source(1001, "123235950") + receivers(500000, '1') +
                                   source(1002, "124000010") + receivers(500050, '1') + "EOF\n");
  EXPECT_EQ(line.format, "P1/90");
  EXPECT_THAT(line.receivers, ElementsAre(1, 2));
  ASSERT_EQ(line.shots.size(), 2U);
  EXPECT_EQ(line.shots[0].number, 1001);
  EXPECT_EQ(line.shots[1].time - line.shots[0].time, 20);  // over midnight
  EXPECT_EQ(line.shots[1].places[1], (Place{500037.5, 100000.4}));
  EXPECT_EQ(line.shots[0].depths[1], 8.2);
  EXPECT_THAT(line.header, ElementsAre(HasSubstr("WGS84")));
}

TEST(P190, GoesOnOverNewYear) {
  const NavigationLine line = read(header + source(1, "365235950") + receivers(0, '1') +
                                   source(2, "001000010") + receivers(50, '1'));
  EXPECT_EQ(line.shots[1].time - line.shots[0].time, 20);
}

TEST(P190, OneStreamerOfSeveral) {
  const std::string text = header + source(1, "001000000") + receivers(0, '1') +
                           receivers(1000, '2') + source(2, "001000020") + receivers(50, '1') +
                           receivers(1050, '2');
  EXPECT_THAT(fault(text),
              HasSubstr("line:5:80: there are several streamers, '1' and '2'; --streamer says"));
  NavigationOptions second;
  second.streamer = 2;
  EXPECT_EQ(read(text, second).shots[0].places[0][0], 1000);
}

TEST(P190, TellsWhatIsWrong) {
  EXPECT_THAT(fault(header + receivers(0, '1')), HasSubstr("before the first shot"));
  EXPECT_THAT(fault(header + "Y\n"), HasSubstr("line:3:1: there is no record 'Y' in P1/90"));
  std::string broken = receivers(0, '1');
  broken[8] = 'x';
  EXPECT_THAT(fault(header + source(1, "001000000") + broken),
              HasSubstr("the easting stands in columns 6 to 14"));
  EXPECT_THAT(
      fault(header + "H2001FACTOR TO METRE             .30480061\n" + source(1, "001000000")),
      HasSubstr("the grid is not in metres"));
  EXPECT_THAT(fault(header + source(1, "001000020") + receivers(0, '1') + source(2, "001000000") +
                    receivers(0, '1')),
              HasSubstr("the time of shot 2 is not after"));
  EXPECT_THAT(fault(header + source(1, "001000000") + std::string(90, 'R') + "\n"),
              HasSubstr("has 80 columns"));
}

}  // namespace
}  // namespace hawser
