#include <doctest/doctest.h>

#include <filesystem>

#include "run_program.hpp"

using namespace bounce;
using test::contains;
using test::Outcome;
using test::run_program;
using test::run_program_with;

namespace fs = std::filesystem;

namespace {

bool is_png(const std::string& path) { return test::read_file(path).substr(0, 4) == "\x89PNG"; }

}  // namespace

TEST_CASE(
    "no display, or a driver that fails: it says so, runs, and leaves a picture and a trace") {
  for (const std::string environment :
       {"SDL_VIDEODRIVER=dummy", "SDL_VIDEODRIVER=no_such_driver",
        "env -u SDL_VIDEODRIVER -u DISPLAY -u WAYLAND_DISPLAY SDL_VIDEODRIVER=x11"}) {
    if (test::on_windows && contains(environment, "env ")) continue;  // it has a screen
    for (const std::string stage : {"01_free_fall", "02_spring_floor", "03_damping"}) {
      const Outcome run = run_program_with(environment, stage + " --duration 1");
      CAPTURE(environment);
      CAPTURE(run.err);
      CHECK(run.code == 0);
      CHECK(contains(run.err, "no display"));
      CHECK(
          contains(run.err, "the trace is in " + stage + ".csv, the picture in " + stage + ".png"));
      CHECK(is_png(test::work_folder() + "/" + stage + ".png"));
      CHECK(contains(test::read_file(test::work_folder() + "/" + stage + ".csv"), "\n1,"));
    }
  }
}

TEST_CASE("no display, and a folder where nothing may be written: trace and picture go elsewhere" *
          doctest::skip(test::on_windows)) {
  if (!fs::exists("/proc/self")) return;  // in which nobody may write, not even root
  const std::string temporary = fs::temp_directory_path().string();
  const Outcome run =
      run_program_with("cd /proc && SDL_VIDEODRIVER=dummy", "01_free_fall --duration 1");
  CAPTURE(run.err);
  CHECK(run.code == 0);
  CHECK(contains(run.err, "the trace is in " + temporary + "/01_free_fall.csv, the picture in "));
  CHECK(is_png(temporary + "/01_free_fall.png"));
  for (const char* file : {"/01_free_fall.csv", "/01_free_fall.png"}) fs::remove(temporary + file);
}

TEST_CASE("--screenshot writes the same picture every time, and needs no display") {
  const std::string command = "03_damping --screenshot picture.png --duration 0.6";
  REQUIRE(run_program_with("SDL_VIDEODRIVER=", command).code == 0);
  const std::string first = test::read_file(test::work_folder() + "/picture.png");
  REQUIRE(run_program_with("SDL_VIDEODRIVER=dummy", command).code == 0);
  CHECK(first.size() > 20000);
  CHECK(first == test::read_file(test::work_folder() + "/picture.png"));
}

TEST_CASE("a picture or a clip that cannot be written: exit code 2, nothing left behind") {
  for (const std::string option :
       {"--screenshot /nowhere/a.png", "--screenshot .", "--record /nowhere/a.gif",
        "--record clip.avi", "--record clip"}) {
    const Outcome run = run_program("03_damping --duration 0.1 " + option);
    CAPTURE(option);
    CAPTURE(run.err);
    CHECK(run.code == 2);
    CHECK(contains(run.err, option.substr(option.find(' ') + 1)));
    CHECK(fs::is_empty(test::work_folder()));
  }
}

TEST_CASE("without ffmpeg, --record names it and ends with exit code 1; with it, there is a clip") {
  const Outcome without =
      run_program_with("PATH=/nowhere", "03_damping --duration 0.2 --record clip.gif");
  CHECK(without.code == 1);
  CHECK(contains(without.err, "ffmpeg"));
  CHECK(contains(without.err, "install"));
  CHECK(fs::is_empty(test::work_folder()));
  if (std::system(test::on_windows ? "ffmpeg -version > NUL 2>&1"
                                   : "ffmpeg -version > /dev/null 2>&1") != 0) {
    MESSAGE("ffmpeg is not here: the clip itself was not tested");
    return;
  }
  for (const std::string name : {"clip.gif", "clip.mp4"}) {
    CHECK(run_program("03_damping --duration 0.2 --record " + name).code == 0);
    CHECK(fs::file_size(test::work_folder() + "/" + name) > 3000);
    CHECK(std::distance(fs::directory_iterator(test::work_folder()), fs::directory_iterator()) ==
          1);
  }
}
