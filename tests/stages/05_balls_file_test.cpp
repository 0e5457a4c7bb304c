#include "05_ball_collision/files/balls_file.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <string>
#include <vector>

#include "temporary_folder.hpp"

// The file that --balls reads: what is a table of balls, and what is said of the rest.
using namespace bounce;

namespace {

Arrangement read(const std::string& text) {
  const test::TemporaryFolder folder;
  const std::string path = (folder.path() / "balls.csv").string();
  std::ofstream(path, std::ios::binary) << text;
  return BallsFile(path).read();
}

std::string answer_to(const std::string& text) {
  try {
    read(text);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "accepted";
}

struct BadTable {
  std::string text;
  std::vector<std::string> says;
};

void check_refusal(const BadTable& bad) {
  const std::string message = answer_to(bad.text);
  INFO(message);
  for (const std::string& part : bad.says) CHECK(message.find(part) != std::string::npos);
}

}  // namespace

TEST_CASE("stage 5: a balls file is refused with its line and column") {
  const std::string header = "mass,radius,x,y,z,vx,vy,vz\n", good = "1,0.1,0,0,0,0,0,0\n";
  CHECK(answer_to(header + good) == "accepted");
  CHECK(answer_to(header + good + good) == "accepted");  // coincident: deep overlap is allowed
  CHECK(answer_to("radius, mass ,x,y,z,vx,vy,vz\r\n0.1,1,0,0,0,0,0,0\r\n\r\n") == "accepted");
  for (const BadTable& bad : {
           BadTable{"", {"empty", "line 1"}},
           BadTable{header, {"no ball", "line 2"}},
           BadTable{good, {"line 1", "column mass"}},
           BadTable{"mass,radius,x,y,z,vx,vy\n1,0.1,0,0,0,0,0\n", {"line 1", "column vz"}},
           BadTable{"mass,radius,x,y,z,vx,vy,vz,spin\n", {"line 1", "9 columns"}},
           BadTable{header + good + "1,0.1,0,zero,0,0,0,0\n", {"line 3", "column y", "'zero'"}},
           BadTable{header + "1,0.1,0,0,0,0,0,nan\n", {"line 2", "column vz", "'nan'"}},
           BadTable{header + "1,0.1,0,inf,0,0,0,0\n", {"line 2", "column y", "'inf'"}},
           BadTable{header + "-1,0.1,0,0,0,0,0,0\n", {"line 2", "column mass", "'-1'"}},
           BadTable{header + "1,0,0,0,0,0,0,0\n", {"line 2", "column radius", "'0'"}},
           BadTable{header + good + "\n1,0.1,0,0,0,0,0\n", {"line 4", "column vz", "missing"}},
           BadTable{header + "1,0.1,0,0,0,0,0,0,0\n", {"line 2", "9 values"}},
           BadTable{header + "1,0.1,0,,0,0,0,0\n", {"line 2", "column y", "''"}},
       }) {
    check_refusal(bad);
  }
  CHECK_THROWS_AS(BallsFile("/no/such/file.csv").read(), BadInput);
  CHECK_THROWS_AS(BallsFile("/").read(), BadInput);
}

TEST_CASE("stage 5: a table from a spreadsheet is read, or the cause is named") {
  for (const std::string same :
       {"mass;radius;x;y;z;vx;vy;vz\n2;0.1;3;4;5;6;7;8\n",
        "mass\tradius\tx\ty\tz\tvx\tvy\tvz\n2\t0.1\t3\t4\t5\t6\t7\t8\n",
        "\"Mass\",\"Radius\",\"X\",\"Y\",\"Z\",\"vX\",\"vY\",\"vZ\"\n2,0.1,3,4,5,6,7,8\n",
        "# one ball\nmass,radius,x,y,z,vx,vy,vz\n2,0.1,3,4,5,6,7,8\n",
        "\xEF\xBB\xBFmass,radius,x,y,z,vx,vy,vz,,\n2,0.1,3,4,5,6,7,8,,\n",
        "mass,radius,x,y,z,vx,vy,vz\n,,,,,,,\n#1,2\n2,0.1,3,4,5,6,7,8\n\n,,,,,,,\n"}) {
    INFO(same);
    const Arrangement one = read(same);
    REQUIRE(one.mass.size() == 1);
    CHECK(one.mass[0] == 2);
    CHECK(one.radius[0] == 0.1);
    CHECK(one.balls.position == Eigen::Vector3d(3, 4, 5));
    CHECK(one.balls.velocity == Eigen::Vector3d(6, 7, 8));
  }
  check_refusal({"mass;radius;x;y;z;vx;vy;vz\n1;0,1;0;0;0;0;0;0\n",
                 {"line 2", "column radius", "'0,1'", "a point in place of the comma"}});
  check_refusal({std::string("\xFF\xFEm\0a\0", 6), {"UTF-16", "UTF-8"}});
}
