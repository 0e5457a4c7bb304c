// Draws docs/images/hard_cases.svg (gnuplot) from runs made here; with the word `check`, only says
// whether the committed figure shows what these runs give today.

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>

#include "02_spring_floor/exact.hpp"
#include "02_spring_floor/spring_floor.hpp"
#include "08_racket_game/racket_game.hpp"
#include "08_racket_game/run/contact_steps.hpp"
#include "physics/events/event_driven.hpp"
#include "physics/methods/stepping_methods.hpp"
#include "speed_vs_error/results.hpp"

using namespace bounce;

namespace {

std::string point(double x, double y) {
  char text[64];
  std::snprintf(text, sizeof text, "%.5f %.5f\n", x, y);
  return text;
}

/// Explicit Euler on the slides' ball, dt = 1 ms, and the exact movement.
std::string growing_bounce() {
  const SpringFloor scene;
  State<double> state = scene.start;
  EventDriven<SpringFloorExact> exact(SpringFloorExact(scene), 0, scene.start);
  std::string naive, right;
  for (int i = 0; i <= 5000; ++i) {
    if (i % 10 == 0) {
      naive += point(i * 1e-3, state.position);
      right += point(i * 1e-3, exact.at(i * 1e-3).position);
    }
    explicit_euler(scene, i * 1e-3, state, 1e-3);
  }
  return naive + "e\n" + right + "e\n";
}

/// A ball at 20 m/s and a disc at height 0; steps of 10 ms.
std::string thin_disc() {
  Racket scene;
  scene.gravity = 0;
  scene.damping = 0;
  scene.stiffness = 1e6;
  scene.disc.radius = 1;
  State<Eigen::Vector3d> ball{{0, 0.71, 0}, {0, -20, 0}}, looked_at = ball;
  Racket naive = scene;
  ContactSteps<Rk4> steps(scene);
  std::string through, back;
  for (int i = 0; i <= 8; ++i) {
    through += point(i * 10, looked_at.position.y());
    back += point(i * 10, ball.position.y());
    naive.side = looked_at.position.y() < 0 ? -1 : 1;
    semi_implicit_euler(naive, i * 0.01, looked_at, 0.01);
    steps(i * 0.01, ball, 0.01);
  }
  return through + "e\n" + back + "e\n";
}

/// A floor of 900 rad/s as it is, and as steps of 1/240 s see it.
std::string fast_floor() {
  std::string is, seen;
  for (int i = 0; i <= 1000; ++i) is += point(i * 0.05, std::sin(900 * i * 0.05e-3));
  for (int i = 0; i <= 12; ++i) seen += point(i / 0.24, std::sin(900 * i / 240.0));
  return is + "e\n" + seen + "e\n";
}

std::string script(const std::string& file) {
  std::ostringstream out;
  out << "set terminal svg size 1080,420 font 'DejaVu Sans,15' background '#ffffff'\n"
      << "set linetype 1 linecolor rgb '#d55e00'\nset linetype 2 linecolor rgb '#000000'\n"
      << "set output '" << file << "'\nset multiplot layout 1,3\nset grid linecolor '#dddddd'\n"
      << "set key top left samplen 0.7 width -3\n"
      << "set title 'a bounce that grows'\nset xlabel 'time [s]'\nset ylabel 'height [m]'\n"
      << "set yrange [-0.5:6.5]\n"
      << "plot '-' with lines linewidth 2 linetype 1 title 'explicit Euler, 1 ms', "
      << "'-' with lines linewidth 2 linetype 2 title 'exact'\n"
      << growing_bounce() << "set title 'a disc that is passed through'\nset xlabel 'time [ms]'\n"
      << "set yrange [-1:1.4]\nset arrow from 0,0 to 80,0 nohead linewidth 3 linecolor '#555555'\n"
      << "plot '-' with linespoints linewidth 2 linetype 1 pointtype 7 pointsize 0.5 title "
      << "'seen every 10 ms', '-' with linespoints linewidth 2 linetype 2 pointtype 7 "
      << "pointsize 0.5 title 'cut at the touch'\n"
      << thin_disc() << "unset arrow\n"
      << "set title 'a floor too fast for the step'\nset ylabel 'floor, in amplitudes'\n"
      << "set yrange [-1.2:1.9]\n"
      << "plot '-' with lines linecolor '#aaaaaa' title 'as it is, 900 rad/s', "
      << "'-' with linespoints linewidth 2 linetype 1 pointtype 7 pointsize 0.5 title "
      << "'seen every 1/240 s'\n"
      << fast_floor();
  return out.str();
}

}  // namespace

int main(int argc, char**) {
  const std::string file = BOUNCE_SOURCE_DIR "/docs/images/hard_cases.svg";
  const std::string mark = "<!-- drawn by hard_case_pictures with fingerprint " +
                           report::fingerprint(script("")) + " -->\n";
  if (argc > 1) {
    std::ifstream committed(file);
    const std::string text((std::istreambuf_iterator<char>(committed)), {});
    if (text.find(mark) != std::string::npos) return 0;
    std::cerr << "docs/images/hard_cases.svg is out of date: hard_case_pictures draws it again\n";
    return 1;
  }
  FILE* gnuplot = popen("gnuplot", "w");
  if (gnuplot == nullptr) throw std::runtime_error("gnuplot cannot be started");
  const std::string commands = script(file);
  std::fwrite(commands.data(), 1, commands.size(), gnuplot);
  if (pclose(gnuplot) != 0) throw std::runtime_error("gnuplot failed (is it installed?)");
  std::ofstream(file, std::ios::app) << mark;
}
