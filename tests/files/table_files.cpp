// Tables of motions and couplings in files of their own.

#include <gtest/gtest.h>

#include <boost/multiprecision/float128.hpp>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/files/common.h"
#include "tests/started.h"

namespace desmo::table_files_test {
namespace {

using Wide = boost::multiprecision::float128;

constexpr double exact = 1e-30;

class TableFile : public InFolder {
 protected:
  /// Reads the scene with a table of these rows, or says why not.
  std::string read(const std::string& rows, Scene* scene = nullptr) {
    write("t.csv", rows);
    return refusal<InputError>([&] {
      const Scene s = parse_scene(text_, "s.json", folder_);
      if (scene) *scene = s;
    });
  }

  /// The angle moves by a table in a file.
  std::string text_ =
      scene_of(drawn("angle"), R"("motion": {"angle": {"type": "table", "file": "t.csv"}},
                                  "time": {"end": 2, "step": 1})");
};

TEST_F(TableFile, HasRowsOfTimesAndValues) {
  const double degree = std::acos(-1.0) / 180;
  for (const char* rows :
       {"0,0\n1,10\n2,40\n", "0 0\r\n\r\n1\t10\r\n2 40", "time,deflection\n0,0\n1,10\n2,40\n",
        "angle [deg],flag,t [s]\n0,,0\n10,,1\n40,,2\n", "\"t\",\"angle\"\n0,0\n1,+1e1\n2,40\n",
        "\xEF\xBB\xBF"
        "0,0\n1,10\n2,40\n",
        "\xEF\xBB\xBF"
        "angle,flag,t\n0,,0\n10,,1\n40,,2\n"}) {
    Scene scene;
    ASSERT_EQ(read(rows, &scene), "accepted") << rows;
    EXPECT_EQ(sample(scene.motions[0], 1.0).position, 10 * degree) << rows;
    EXPECT_NEAR(sample(scene.motions[0], 2.0).position, 40 * degree, 1e-15) << rows;
  }
  for (const char* heading : {"t [s],angle [rad]", "Time (s),Motor (rad)"}) {
    Scene scene;
    ASSERT_EQ(read(heading + std::string("\n0,0\n1,10\n2,40\n"), &scene), "accepted");
    EXPECT_EQ(sample(scene.motions[0], 1.0).position, 10) << heading;
  }
}

TEST_F(TableFile, WhatIsWrongIsNamedWithItsLine) {
  const std::pair<const char*, const char*> faults[] = {
      {"", "has 0 rows; a table needs 2 or more"},
      {"t,angle\n0,0\n", "has 1 rows"},
      {"0,0,0\n1,1,1\n", "line 1: has 3 columns and no heading; give two, 't' and 'angle'"},
      {"t,angel,s\n0,0,0\n", "line 1: no column is called 'angle'; did you mean 'angel'?"},
      {"angle,t2\n0,0\n1,1\n", "line 1: column 1 is called 'angle', where 't' is expected"},
      {"x,t\n0,0\n1,1\n", "line 1: column 2 is called 't', where 'angle' is expected"},
      {"t,turn [rad]\n0,0\n1,1\n", "line 1: column 2 is called 'turn', where 'angle' is expected"},
      {"deflection,time\n0,0\n1,1\n",
       "line 1: column 2 is called 'time', where 'angle' is expected"},
      {"t,angle,angle\n0,0,0\n1,1,1\n", "line 1: two columns are called 'angle'; leave one out"},
      {"angle [deg],t,t\n0,0,0\n1,1,1\n", "line 1: two columns are called 't'; leave one out"},
      {"O,100\n1,1\n2,2\n", "line 1: column 1: 'O' is not a number, and column 2, '100', is not a"},
      {"t,100\n1,1\n2,2\n", "line 1: column 1: 't' is not a number, and column 2, '100', is not a"},
      {"t [ms],angle\n0,0\n1,1\n",
       "line 1: 't' is in 'ms', no unit that it can have; give it in 's'"},
      {"t,z (mm)\n0,0\n1,1\n",
       "line 1: 'angle' is in 'mm', no unit that it can have; give it in 'deg'"},
      {"t,angle\n0,0\n\n1,x\n", "line 4: column 2: 'x' is not a number up to 1e100; give one"},
      {"0,0\n1,nan\n", "line 2: column 2: 'nan' is not a number"},
      {"0,0\n1,+-5\n", "line 2: column 2: '+-5' is not a number"},
      {"0,0\n1,1e101\n", "line 2: column 2: '1e101' is not a number up to 1e100"},
      {"0,0\n1\n", "line 2: has 1 columns, where 2 are expected; give as many"},
      {"t;angle\n0;0\n", "line 1: no column is called 't'; separate columns by commas, tabs or bl"},
      {"t [s];angle [deg]\n0;0\n",
       "line 1: no column is called 'angle'; separate columns by commas, tabs or bl"},
      {"0,5;0\n1,0;1\n",
       "line 1: column 2: '5;0' is not a number up to 1e100; separate columns by commas"},
      {"0,0\n1,1\n1,2\n", "line 3: its 't' is not above the one before"},
  };
  const std::string start = "s.json: /motion/angle/file: the table file '" + file("t.csv") + "': ";
  for (const auto& [rows, message] : faults) expect_start(read(rows), start + message);
  expect_start(read("0,0\n1,1\n"),
               "s.json: /time: the table of 'angle' reaches only from 0 s to 1 s");
}

/// A driver has the name of the time.
TEST_F(TableFile, MustTellTimesFromValues) {
  text_ = replaced_everywhere(replaced(text_, "\"angle\": {\"angle\"", "\"t\": {\"angle\""),
                              "\"angle\": {\"type\"", "\"t\": {\"type\"");
  text_ = replaced(text_, R"(["angle"])", R"(["t"])");
  EXPECT_EQ(read("0,0\n2,1\n"), "accepted");
  for (const char* heading : {"t,t\n", "t [s],t [deg]\n", "t,deflection\n", "flag,t,t\n"})
    EXPECT_CONTAINS(read(heading + std::string("0,0,0\n2,1,1\n")),
                    ", 't', would be arguments and values; rename the coordinate");
}

/// The height follows the angle by a table in a file.
class CouplingFile : public TableFile {
 protected:
  CouplingFile() {
    text_ = scene_of(replaced(drawn("turn"), "\"drivers\"",
                              R"("couplings": {"c": {"coordinate": "height", "of": "angle",
                                                    "file": "t.csv"}}, "drivers")"),
                     R"("motion": {"turn": {"type": "constant", "value": 0}}, "time": {"at": 0})");
  }
};

/// Numbers stay those of the file, whose units count exactly.
TEST_F(CouplingFile, HasRowsOfArgumentsAndValues) {
  const Wide degree = acos(Wide(-1)) / 180;
  const std::tuple<const char*, Wide, Wide> files[] = {
      {"-30,5\n60,7\n110,6.5\n", degree, 1},
      {"a,h\r\n\r\n-30,5\r\n60,7\r\n110,6.5", degree, 1},
      {"height [mm],flag,angle [deg]\n5,,-30\n7,,60\n6.5,,110\n", degree, 1e-3},
      {"angle [rad]\theight [in]\n-30\t5\n60\t7\n110\t6.5\n", 1, 0.0254},
  };
  for (const auto& [rows, of_arguments, of_values] : files) {
    Scene scene;
    ASSERT_EQ(read(rows, &scene), "accepted") << rows;
    const Mechanism::Coupling& c = scene.mechanism.couplings[0];
    EXPECT_EQ(c.table->arguments, (std::vector<double>{-30, 60, 110})) << rows;
    EXPECT_EQ(c.table->values, (std::vector<double>{5, 7, 6.5})) << rows;
    EXPECT_NEAR(double(as<Wide>(c.terms[0].factor) * of_values - 1), 0, exact) << rows;
    EXPECT_NEAR(double(as<Wide>(c.terms[1].factor) * of_arguments - 1), 0, exact) << rows;
  }
}

TEST_F(CouplingFile, WhatIsWrongIsNamedWithItsLine) {
  const std::pair<const char*, const char*> faults[] = {
      {"0,0,0\n1,1,1\n", "line 1: has 3 columns and no heading; give two, 'angle' and 'height'"},
      {"t,height,s\n0,0,0\n", "line 1: no column is called 'angle'; there are 't', 'height', 's'"},
      {"angle [mm],height\n0,0\n1,1\n", "line 1: 'angle' is in 'mm', no unit that it can have"},
      {"angle,height [1]\n0,0\n1,1\n",
       "line 1: 'height' is in '1', no unit that it can have; give it in 'm'"},
      {"0,0\nnan,1\n", "line 2: column 1: 'nan' is not a number"},
      {"0,0\n2,1\n1,1\n", "line 3: its 'angle' is not above the one before; give ascending ones"},
  };
  const std::string start = "s.json: /mechanism/couplings/c/file: the table file '" + file("t.csv");
  for (const auto& [rows, message] : faults) expect_start(read(rows), start + "': " + message);
}

}  // namespace
}  // namespace desmo::table_files_test
