#include "hawser/values/table.hpp"

#include <gmock/gmock.h>

#include "hawser/base/error.hpp"

namespace hawser {
namespace {

using testing::HasSubstr;

SpaceTime at(double t, double x = 0, double y = 0) {
  SpaceTime point;
  point.t = t, point.x = x, point.y = y;
  return point;
}

std::string fault(const std::string& text) {
  try {
    Table(text, "current.csv");
  } catch (const DeckError& error) {
    return error.what();
  }
  return "";
}

TEST(Table, InterpolatesLinearlyInTime) {
  const Table table("t_s,u,v\n# tide\n0,0,-0.5\n\n100,1,-0.4\n300,0,0\n", "current.csv");
  double values[2];
  table.value(at(50), values);
  EXPECT_DOUBLE_EQ(values[0], 0.5);
  EXPECT_DOUBLE_EQ(values[1], -0.45);
  table.value(at(200), values);
  EXPECT_DOUBLE_EQ(values[0], 0.5);
  table.value(at(300), values);
  EXPECT_DOUBLE_EQ(values[1], 0);
  table.time_derivative(at(200), values);
  EXPECT_DOUBLE_EQ(values[0], -0.005);
  EXPECT_DOUBLE_EQ(values[1], 0.002);
  EXPECT_FALSE(table.depends_on_moved_position());
}

// A bilinear function of time and place comes out exactly, with its slopes; rows in any order.
TEST(Table, IsExactForProductsOfLinearFunctions) {
  const auto f = [](double t, double x, double y) { return (1 + 2 * t) * (3 - x) * (2 + 0.5 * y); };
  std::string text = "y_m,t,w,x_m\n";
  for (const double x : {4.0, -1.0, 1.5})
    for (const double t : {0.0, 10.0})
      for (const double y : {2.0, -2.0, 0.0})
        text += std::to_string(y) + "," + std::to_string(t) + "," + std::to_string(f(t, x, y)) +
                "," + std::to_string(x) + "\n";
  const Table table(text, "current.csv");
  ASSERT_EQ(table.components(), 1);
  EXPECT_TRUE(table.depends_on_moved_position());
  for (const double t : {0.0, 3.0, 10.0})
    for (const double x : {-1.0, 0.2, 4.0})
      for (const double y : {-2.0, 1.7, 2.0}) {
        double value = 0, rate = 0, slope[3];
        table.value(at(t, x, y), &value);
        EXPECT_NEAR(value, f(t, x, y), 1e-12);
        table.time_derivative(at(t, x, y), &rate);
        EXPECT_NEAR(rate, 2 * (3 - x) * (2 + 0.5 * y), 1e-12);
        table.gradient(at(t, x, y), 0, slope);
        EXPECT_NEAR(slope[0], -(1 + 2 * t) * (2 + 0.5 * y), 1e-11);
        EXPECT_NEAR(slope[1], 0.5 * (1 + 2 * t) * (3 - x), 1e-11);
        EXPECT_EQ(slope[2], 0);
      }
}

// The derivatives are those of the pieces: at a knot of the later one, at the last knot of the
// last.
TEST(Table, DerivativesAtAKnotAreThoseOfTheLaterPiece) {
  const Table table("t,x,v\n0,0,1\n10,0,2\n30,0,0\n0,4,1\n10,4,2\n30,4,0\n0,5,3\n10,5,4\n30,5,2\n",
                    "current.csv");
  double rate = 0, slope[3];
  for (const auto& [t, expected] : {std::pair(9.99, 0.1), {10.0, -0.1}, {30.0, -0.1}}) {
    table.time_derivative(at(t, 0), &rate);
    EXPECT_DOUBLE_EQ(rate, expected) << t;
  }
  for (const auto& [x, expected] : {std::pair(3.99, 0.0), {4.0, 2.0}, {5.0, 2.0}}) {
    table.gradient(at(0, x), 0, slope);
    EXPECT_NEAR(slope[0], expected, 1e-14) << x;
  }
}

TEST(Table, HasNoValueOutside) {
  const Table table("t,x,v\n0,0,1\n10,0,2\n0,5,3\n10,5,4\n", "current.csv");
  double value = 0;
  table.value(at(10 * (1 + 1e-12), 5), &value);
  EXPECT_DOUBLE_EQ(value, 4);
  EXPECT_THROW(table.value(at(10.1, 0), &value), DeckError);
  try {
    table.value(at(3, -1), &value);
    FAIL();
  } catch (const DeckError& error) {
    EXPECT_STREQ(error.what(), "current.csv: no value at x = -1 m; the table reaches from 0 to 5");
  }
}

TEST(Table, SaysWhatIsWrong) {
  EXPECT_EQ(fault("t,v\n"),
            "current.csv: a table needs a line with the columns' names and at least one row");
  EXPECT_THAT(fault("t,t_s,v\n0,0,1\n"),
              HasSubstr("current.csv:1: the column 't_s' is given twice"));
  EXPECT_THAT(fault("t,x\n0,0\n"), HasSubstr("no column holds a component"));
  EXPECT_THAT(fault("time,v\n0,0\n"), HasSubstr("there is no column t, x or y, but time, v"));
  EXPECT_EQ(fault("t,v\n0,1\n10\n"), "current.csv:3: 1 values, but 2 columns");
  EXPECT_EQ(fault("t,v\n0,1\n10,fast\n"), "current.csv:3: 'fast' is no number");
  EXPECT_EQ(fault("t,v\n0,1\n0,2\n"), "current.csv:3: time and place are those of line 2");
  EXPECT_THAT(fault("t,x,v\n0,0,1\n0,1,1\n10,0,1\n"), HasSubstr("none for t = 10, x = 1"));
}

}  // namespace
}  // namespace hawser
