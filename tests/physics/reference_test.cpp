// The method `reference`: its integrator's order, and its error and cost across bounces.

#include "physics/events/reference_walk.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "03_damping/exact.hpp"
#include "physics/reference_values.hpp"
#include "run_program.hpp"
#include "run_with.hpp"
#include "stages/methods.hpp"
#include "stages/scene_simulations.hpp"

using namespace bounce;

namespace {

using DampedRun = OneBallRun<Damping, DampingExact>;

DampedRun run_of(double damping, const char* contact, double tolerance) {
  DampedRun run = test::run_with<DampedRun>({{"damping", to_text(damping)}, {"contact", contact}},
                                            methods::reference);
  run.use_tolerance(tolerance);
  return run;
}

// x'' = -sin x - 0.3 x': not linear, so that all order conditions count, not only those of
// quadrature.
struct Pendulum {
  double acceleration(double /*t*/, const State<double>& state) const {
    return -std::sin(state.position) - 0.3 * state.velocity;
  }
};

template <class Method>
State<double> swing(Method method, int steps) {
  State<double> state{2, 0};
  for (int i = 0; i < steps; ++i) {
    method.start_at(Pendulum{}, 0, state);
    state = method.step(Pendulum{}, 0, 4.0 / steps);
  }
  return state;
}

/// A Runge-Kutta method's numbers: where it looks, how it weighs what it saw, and the result's
/// weights.
template <std::size_t stages>
struct Tableau {
  std::array<std::array<double, stages>, stages> a{};
  std::array<double, stages> b{}, c{};
};

/// The numbers as they are in the code, seen from outside: an acceleration that is 1 in one stage
/// and 0 in all others makes the velocity of each later stage that stage's number.
template <class Method, std::size_t stages>
Tableau<stages> tableau_of() {
  Tableau<stages> table;
  for (std::size_t one = 0; one < stages; ++one) {
    struct Probe {
      double acceleration(double t, const State<double>& state) const {
        table.a[at][one] = state.velocity;
        table.c[at] = t;
        return at++ == one ? 1 : 0;
      }
      Tableau<stages>& table;
      std::size_t one;
      mutable std::size_t at = 0;
    };
    const Probe probe{table, one};
    Method method;
    method.start_at(probe, 0, {0, 0});
    table.b[one] = method.step(probe, 0, 1).velocity;
    REQUIRE(probe.at == stages);
  }
  return table;
}

/// A rooted tree: the trees that hang on its root, by number in a list of all smaller trees.
struct Tree {
  std::vector<std::size_t> branches;
  int order = 1;  // how many nodes
};

/// All trees with up to `most` nodes, each once: branches in falling order of their numbers.
std::vector<Tree> trees_up_to(int most) {
  std::vector<Tree> all{{{}, 1}};
  for (int order = 2; order <= most; ++order) {
    const std::size_t smaller = all.size();
    const std::function<void(Tree, std::size_t)> grow = [&](const Tree& tree, std::size_t largest) {
      if (tree.order == order) all.push_back(tree);
      for (std::size_t next = 0; next <= largest && next < smaller; ++next) {
        if (tree.order + all[next].order > order) continue;
        Tree taller = tree;
        taller.branches.push_back(next);
        taller.order += all[next].order;
        grow(taller, next);
      }
    };
    grow(Tree{}, smaller - 1);
  }
  return all;
}

template <std::size_t stages>
void check_order(const Tableau<stages>& table, int order, std::size_t conditions) {
  // Butcher: a method is of order p if, for each rooted tree with up to p nodes, the sum over the
  // stages of b_i phi_i is 1 / gamma. A node's phi is the product over its branches of the sum over
  // j of a_ij phi_j, its gamma the tree's order times the branches' gammas. (Hairer, Norsett and
  // Wanner, theorem II.2.13)
  const std::vector<Tree> trees = trees_up_to(order);
  CHECK(trees.size() == conditions);
  std::vector<std::array<double, stages>> phi(trees.size());
  std::vector<double> gamma(trees.size());
  for (std::size_t n = 0; n < trees.size(); ++n) {
    gamma[n] = trees[n].order;
    phi[n].fill(1);
    for (const std::size_t branch : trees[n].branches) {
      gamma[n] *= gamma[branch];
      for (std::size_t i = 0; i < stages; ++i) {
        double sum = 0;
        for (std::size_t j = 0; j < i; ++j) sum += table.a[i][j] * phi[branch][j];
        phi[n][i] *= sum;
      }
    }
    double left = 0, size = 0;
    for (std::size_t i = 0; i < stages; ++i) {
      left += table.b[i] * phi[n][i];
      size += std::abs(table.b[i] * phi[n][i]);
    }
    CAPTURE(n);
    CAPTURE(trees[n].order);
    // Numbers of up to 43 cancel in stages 9 to 12, so that those are right to some 1e-14.
    CHECK(std::abs(left - 1 / gamma[n]) < 1e-13 * (1 + size));
  }
  for (std::size_t i = 0; i < stages; ++i) {  // each stage looks where its weights lead
    double sum = 0;
    for (std::size_t j = 0; j < i; ++j) sum += table.a[i][j];
    CHECK(std::abs(sum - table.c[i]) < 1e-14);
  }
}

}  // namespace

TEST_CASE("the numbers behind `reference` fulfil the 200 order conditions up to order 8") {
  check_order(tableau_of<Dop853<double>, 12>(), 8, 200);
}

TEST_CASE("the numbers of its short steps fulfil the 17 order conditions up to order 5") {
  check_order(tableau_of<Dopri5<double>, 7>(), 5, 17);
}

TEST_CASE("the integrators' estimates of their errors fall as they should, with h^8 and h^5") {
  const auto check = [](auto method, double right) {
    std::vector<double> steps, errors;
    for (int i = 0; i < 20; ++i) {
      const double h = std::pow(0.9, i);
      method.start_at(Pendulum{}, 0, {2, 0.5});
      method.step(Pendulum{}, 0, h);
      steps.push_back(h);
      errors.push_back(method.error(h, 1e-6));  // in units of what is allowed: 1e-6 times a speed
    }
    const double order = test::fitted_slope(steps, errors);
    INFO("measured order ", order);
    CHECK(order > right - 1);
    CHECK(order < right + 1);
  };
  check(Dop853<double>(), 8);
  check(Dopri5<double>(), 5);
}

TEST_CASE("the integrators behind `reference` are of order 8 and 5") {
  const auto check = [](auto method, double right) {
    const State<double> exact = swing(method, 1000);
    std::vector<double> dts, errors;
    for (int steps = 4; steps <= 20; ++steps) {  // below 1e-13 rounding counts
      dts.push_back(4.0 / steps);
      errors.push_back(std::abs(swing(method, steps).position - exact.position));
    }
    const double order = test::fitted_slope(dts, errors);
    INFO("measured order ", order);
    CHECK(order > right - 0.5);
  };
  check(Dop853<double>(), 8);
  check(Dopri5<double>(), 5);
}

TEST_CASE("reference stays within 1e-11 m of the exact solution, with dampers and without") {
  for (const char* contact : {"may-pull", "push-only"}) {
    for (const double damping : {0.0, 5.0, 40.0, 150.0, 199.9, 450.0}) {
      DampedRun run = run_of(damping, contact, 1e-12);
      for (int i = 1; i <= 50; ++i) {
        run.advance_to(0.1 * i);
        CAPTURE(contact);
        CAPTURE(damping);
        CAPTURE(run.time());
        CHECK(run.error()->position < 1e-11);
        CHECK(run.error()->velocity < 1e-10);
      }
    }
  }
}

TEST_CASE("the tolerance rules the error") {
  double before = 1;
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
    DampedRun run = run_of(5, "may-pull", tolerance);
    run.advance_to(5);
    const double error = run.error()->position;
    INFO("tolerance ", tolerance, ", error ", error);
    CHECK(error < 10 * tolerance);  // seven bounces, each of which doubles what it is given
    CHECK(error < before / 5);
    before = error;
  }
}

TEST_CASE("reference on the command line: rows at exactly the times that are asked for") {
  const std::vector<std::string> stages{"02_spring_floor", "03_damping", "04_three_dimensions",
                                        "06_oscillating_floor", "07_tilted_plane"};
  for (const std::string& stage : stages) {
    CAPTURE(stage);
    const std::string words = stage + " --csv - --at 0,0.3,0.37,1.5 --duration 2 --method ";
    const test::Outcome got = test::run_program(words + "reference");
    const test::Outcome right = test::run_program(words + "exact");
    REQUIRE(got.code == 0);
    CHECK(got.err.find("method=reference tolerance=1e-12 simulated_s=2") != std::string::npos);
    std::istringstream got_rows(got.out), right_rows(right.out);
    std::string got_row, right_row;
    std::getline(got_rows, got_row);
    std::getline(right_rows, right_row);
    CHECK(got_row == right_row);  // the columns
    for (const double t : {0.0, 0.3, 0.37, 1.5}) {
      REQUIRE(std::getline(got_rows, got_row));
      REQUIRE(std::getline(right_rows, right_row));
      std::istringstream got_cells(got_row), right_cells(right_row);
      std::string cell, right_cell;
      for (int column = 0; std::getline(got_cells, cell, ','); ++column) {
        REQUIRE(std::getline(right_cells, right_cell, ','));
        if (column == 0) CHECK(std::stod(cell) == t);
        CHECK(std::abs(std::stod(cell) - std::stod(right_cell)) < 1e-10);
      }
    }
    CHECK_FALSE(std::getline(got_rows, got_row));
  }
}

TEST_CASE("who looks at a reference run does not change it") {
  DampedRun whole = run_of(5, "push-only", 1e-9), looked_at = whole;
  whole.advance_to(3);
  for (int i = 1; i <= 700; ++i) looked_at.advance_to(3.0 * i / 700);
  CHECK(whole.values() == looked_at.values());
}
