// Stage 5 with many balls: what a step costs a ball, from the double loop to threads.
// usage: many_balls_speed measure   runs everything (four minutes), writes the CSV and the figure
//        many_balls_speed figure    draws the figure again from the CSV
//        many_balls_speed steps     a table of lesson 5: each step and what it brings
//        many_balls_speed scaling   a table of lesson 5: all methods, all numbers of balls
//        many_balls_speed lammps    of these, what is compared with LAMMPS
//        many_balls_speed machine   where it was measured

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "many_balls/lammps.hpp"
#include "physics/methods/stepping_methods.hpp"
#include "speed_vs_error/results.hpp"
#include "speed_vs_error/stopwatch.hpp"

using namespace bounce;

namespace {

const std::string root = std::string(BOUNCE_SOURCE_DIR) + "/";
const std::string csv_file = "docs/many_balls.csv", figure_file = "docs/images/many_balls.svg";
constexpr double dt = 1e-4;  // s

// ---- What was measured --------------------------------------------------------------------------

struct Row {
  std::string method;
  long balls;
  double ns;     // per ball and step
  double bytes;  // per ball, of the fast path's memory; 0 where it is another's
};

struct Results {
  std::vector<std::string> about;
  std::vector<Row> rows;

  const Row* find(const std::string& method, long balls) const {
    for (const Row& row : rows) {
      if (row.method == method && row.balls == balls) return &row;
    }
    return nullptr;
  }
  double ns(const std::string& method, long balls) const {  // 0: not measured
    const Row* const row = find(method, balls);
    return row != nullptr ? row->ns : 0;
  }
};

const std::vector<std::string> methods{
    "all pairs",         "grid",      "list", "list, vector units", "list, vector units, 2 threads",
    "LAMMPS gran/hooke", "list, SSE2"};
const std::vector<long> sizes{100, 1000, 10000, 100000, 1000000};

std::string text(const char* format, double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

// ---- Measuring ----------------------------------------------------------------------------------

/// Balls that lie in a heap: a drop at 35 % filling 1.5 s later, 2 s from 100,000 on (a minute's
/// work for a million).
test::Crowd heap(long count) {
  const int balls = static_cast<int>(count);
  const std::array<double, 2> tray{tray_for(balls), tray_for(balls)};
  test::Crowd crowd = test::crowd_of(drop(balls, 0.0143, tray, 1), 1e5, 100, tray);
  const double step = count < 100000 ? dt : 5 * dt, duration = count < 100000 ? 1.5 : 2;
  many::ManyBalls fast;
  Eigen::Matrix3Xd acceleration;
  fast.move(crowd.laws(), crowd.scene.mass, crowd.scene.radius, crowd.balls, acceleration,
            many::Stepping::velocity_verlet, std::lround(duration / step), step, 2);
  return crowd;
}

/// One method on one heap, which goes on from where the last measurement ended.
struct Subject {
  std::string method;
  std::function<double(long steps)> seconds;
  std::function<double()> bytes = [] { return 0.0; };
  long fewest = 50;  // steps at a time: a list must have been built, too
  double first = 0;  // s a step
  std::vector<double> times{};
};

double seconds_for(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

Subject plain(const std::string& method, test::Crowd crowd, Eigen::Index grid_from) {
  crowd.scene.grid_from = grid_from;
  Subject subject{method, [crowd, verlet = VelocityVerlet<Eigen::Matrix3Xd>{}](long steps) mutable {
                    return seconds_for([&] {
                      for (long i = 0; i < steps; ++i) verlet(crowd.scene, 0, crowd.balls, dt);
                    });
                  }};
  subject.fewest = 1;
  return subject;
}

Subject fast(const std::string& method, const test::Crowd& start, many::PassFunction pass,
             int threads) {
  struct Kept {
    test::Crowd crowd;
    many::ManyBalls balls{};
    Eigen::Matrix3Xd acceleration{};
  };
  const auto kept = std::make_shared<Kept>(Kept{start});
  kept->balls.use_pass(pass);
  const auto run = [kept, threads](long steps) {
    test::Crowd& crowd = kept->crowd;
    return seconds_for([&] {
      kept->balls.move(crowd.laws(), crowd.scene.mass, crowd.scene.radius, crowd.balls,
                       kept->acceleration, many::Stepping::velocity_verlet, steps, dt, threads);
    });
  };
  return {method, run, [kept] { return static_cast<double>(kept->balls.bytes()); }};
}

std::vector<Subject> subjects(long count, const test::Crowd& crowd) {
  std::vector<Subject> all;
  if (count <= 10000) all.push_back(plain(methods[0], crowd, 1 << 30));
  if (count <= 100000) all.push_back(plain(methods[1], crowd, 0));
  if (count <= 100000) all.push_back(fast(methods[2], crowd, many::pass_scalar, 1));
  all.push_back(fast(methods[3], crowd, many::fastest_pass(), 1));
  if (count >= 1000) all.push_back(fast(methods[4], crowd, many::fastest_pass(), 2));
  if (count <= 100000 && test::run_lammps(test::collapse(10), 1, dt)) {
    all.push_back(
        {methods[5], [crowd](long steps) { return test::run_lammps(crowd, steps, dt)->seconds; }});
  }
#if BOUNCE_WIDER_PASSES && !defined(__AVX__)  // else it is one of the above
  all.push_back(fast(methods[6], crowd, many::pass_vector, 1));
#endif
  return all;
}

/// The median of several rounds, in alternation, so that a slow moment of the machine hits all
/// alike.
void measure_size(long count, Results& results) {
  std::fprintf(stderr, "many_balls: %ld balls\n", count);
  const test::Crowd crowd = heap(count);
  std::vector<Subject> all = subjects(count, crowd);
  for (Subject& subject : all) subject.first = subject.seconds(2) / 2;
  const int rounds = count > 100000 ? 3 : 5;
  for (int round = 0; round < rounds; ++round) {
    for (Subject& subject : all) {
      const long steps = std::clamp(std::lround(0.3 / subject.first), subject.fewest, 20000L);
      subject.times.push_back(subject.seconds(steps) / static_cast<double>(steps));
    }
  }
  for (const Subject& subject : all) {
    const auto per_ball = [count](double number) { return number / static_cast<double>(count); };
    results.rows.push_back({subject.method, count, per_ball(report::median(subject.times)) * 1e9,
                            per_ball(subject.bytes())});
  }
  std::string& contacts =
      results.about.emplace_back("contacts a ball, of " + std::to_string(count));
  contacts += ": " + text("%.1f", 2.0 * test::contacts(crowd) / static_cast<double>(count));
}

std::string vector_units() {
#if BOUNCE_WIDER_PASSES
  if (many::fastest_pass() == many::pass_avx512) return "AVX-512";
  if (many::fastest_pass() == many::pass_avx2) return "AVX2";
#endif
  return "those of the build";
}

Results measure() {
  Results results;
  results.about = {"processor: " + report::processor(), "vector units: " + vector_units(),
                   "compiler: " + std::string(BOUNCE_COMPILER), "flags: " BOUNCE_FLAGS};
  for (const long count : sizes) measure_size(count, results);
  return results;
}

// ---- The CSV ------------------------------------------------------------------------------------

std::string to_csv(const Results& results) {
  std::string text;
  for (const std::string& line : results.about) text += "# " + line + "\n";
  text += "balls;method;ns_per_ball_and_step;bytes_per_ball\n";
  for (const Row& row : results.rows) {
    char numbers[64];
    std::snprintf(numbers, sizeof numbers, "%.4g;%.4g", row.ns, row.bytes);
    text += std::to_string(row.balls) + ";" + row.method + ";" + numbers + "\n";
  }
  return text;
}

std::string read_csv() {
  std::ostringstream text;
  text << std::ifstream(root + csv_file).rdbuf();
  return text.str();
}

Results from_csv(const std::string& text) {
  Results results;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("# ", 0) == 0) results.about.push_back(line.substr(2));
    if (line.empty() || line[0] < '0' || line[0] > '9') continue;
    std::istringstream cells(line);
    std::string balls, method, ns, bytes;
    std::getline(cells, balls, ';'), std::getline(cells, method, ';');
    std::getline(cells, ns, ';'), std::getline(cells, bytes, ';');
    results.rows.push_back({method, std::stol(balls), std::stod(ns), std::stod(bytes)});
  }
  if (results.rows.empty()) throw std::runtime_error("there are no rows in " + csv_file);
  return results;
}

// ---- The figure and the tables ------------------------------------------------------------------

void draw_figure(const std::string& csv) {
  const Results results = from_csv(csv);
  const char* const colours[] = {"#d55e00", "#e69f00", "#0072b2", "#009e73", "#000000", "#999999"};
  std::ostringstream script;
  script << "set terminal svg size 760,520 font 'DejaVu Sans,13' background '#ffffff'\n"
         << "set output '" << root + figure_file << "'\nset logscale xy\n"
         << "set xlabel 'balls'\nset ylabel 'time for a ball and a step [ns]'\n"
         << "set format x '10^{%T}'\nset xrange [70:1500000]\nset grid linecolor '#dddddd'\n"
         << "set key outside bottom center horizontal maxcols 3\n";
  std::string plots, points;
  for (std::size_t i = 0; i < 6; ++i) {  // six curves: SSE2 stands in the table
    std::string curve;
    for (const Row& row : results.rows) {
      if (row.method != methods[i]) continue;
      curve += std::to_string(row.balls) + " " + std::to_string(row.ns) + "\n";
    }
    if (curve.empty()) continue;
    plots += std::string(plots.empty() ? "plot" : ",") + " '-' with linespoints linewidth 2 " +
             "pointtype 7 pointsize 0.6 linecolor rgb '" + colours[i] + "'" +
             (i == 5 ? " dashtype 2" : "") + " title '" + methods[i] + "'";
    points += curve + "e\n";
  }
  script << plots << "\n" << points;
  FILE* gnuplot = popen("gnuplot", "w");
  if (gnuplot == nullptr) throw std::runtime_error("gnuplot cannot be started");
  std::fputs(script.str().c_str(), gnuplot);
  if (pclose(gnuplot) != 0) throw std::runtime_error("gnuplot failed (is it installed?)");
  std::ofstream(root + figure_file, std::ios::app)
      << "<!-- drawn from " << csv_file << " with fingerprint " << report::fingerprint(csv)
      << " -->\n";
}

std::string nanoseconds(double value) {
  return value == 0 ? "-" : text(value < 100 ? "%.1f" : "%.0f", value);
}

void print_steps(const Results& results) {
  std::printf(
      "| step | ns for a ball and a step, 1000 balls | 10,000 balls | times faster than the "
      "step before |\n|---|---|---|---|\n");
  double before = 0;
  for (std::size_t i = 0; i < 5; ++i) {
    const double ns = results.ns(methods[i], 10000);
    std::printf("| %s | %s | %s | %s |\n", methods[i].c_str(),
                nanoseconds(results.ns(methods[i], 1000)).c_str(), nanoseconds(ns).c_str(),
                before > 0 && ns > 0 ? text("%.1f", before / ns).c_str() : "");
    before = ns;
  }
}

void print_scaling(const Results& results) {
  std::printf("| method |");
  for (const long balls : sizes) std::printf(" %ld balls |", balls);
  std::printf("\n|---|---|---|---|---|---|\n");
  for (const std::string& method : methods) {
    std::printf("| %s |", method.c_str());
    for (const long balls : sizes)
      std::printf(" %s |", nanoseconds(results.ns(method, balls)).c_str());
    std::printf("\n");
  }
  std::printf("| LAMMPS against list, vector units |");
  for (const long balls : sizes) {
    const double lammps = results.ns(methods[5], balls), ours = results.ns(methods[3], balls);
    std::printf(" %s |", lammps > 0 ? (text("%.1f", lammps / ours) + " times").c_str() : "-");
  }
  std::printf("\n| list, vector units, against 1000 balls |");
  for (const long balls : sizes) {
    std::printf(" %s times |",
                text("%.1f", results.ns(methods[3], balls) / results.ns(methods[3], 1000)).c_str());
  }
  std::printf("\n| memory of the fast path, bytes a ball |");
  for (const long balls : sizes) {
    const Row* const row = results.find(methods[3], balls);
    std::printf(" %s |", row != nullptr ? text("%.0f", row->bytes).c_str() : "-");
  }
  std::printf("\n");
}

void print_lammps(const Results& results) {
  std::printf(
      "| balls | here, 1 thread | here, 2 threads | LAMMPS, 1 process |\n|---|---|---|---|\n");
  for (const long balls : {10000L, 100000L}) {
    std::printf("| %ld |", balls);
    for (const std::size_t method : {3u, 4u, 5u}) {
      std::printf(" %s |", nanoseconds(results.ns(methods[method], balls)).c_str());
    }
    std::printf("\n");
  }
}

void print_machine(const Results& results) {
  std::printf("| | |\n|---|---|\n");
  for (const std::string& line : results.about) {
    const std::size_t colon = line.find(": ");
    std::printf("| %s | %s |\n", line.substr(0, colon).c_str(), line.substr(colon + 2).c_str());
  }
}

int run(const std::string& what) {
  if (what == "measure") {
    const std::string csv = to_csv(measure());
    std::ofstream(root + csv_file) << csv;
    draw_figure(csv);
  } else if (what == "figure") {
    draw_figure(read_csv());
  } else if (what == "steps") {
    print_steps(from_csv(read_csv()));
  } else if (what == "scaling") {
    print_scaling(from_csv(read_csv()));
  } else if (what == "lammps") {
    print_lammps(from_csv(read_csv()));
  } else if (what == "machine") {
    print_machine(from_csv(read_csv()));
  } else {
    std::fprintf(stderr, "usage: many_balls_speed measure|figure|steps|scaling|lammps|machine\n");
    return 2;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc == 2 ? argv[1] : "");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "many_balls_speed: %s\n", error.what());
    return 1;
  }
}
