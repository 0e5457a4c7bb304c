// SUNDIALS CVODE on the same work: Adams methods of variable order under error control, with its
// own root finding at touch and lift-off, and a fresh start after each (its history is of no use
// there).

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include "speed_vs_error/subjects.hpp"

namespace bounce::report {
namespace {

struct Ball {  // m = 1, r = 0.1, g = 9.81, k = 1e4
  double c;
  bool touch;
  long long calls;
};

int rate(realtype /*t*/, N_Vector y, N_Vector out, void* data) {
  Ball& ball = *static_cast<Ball*>(data);
  ++ball.calls;
  const double height = NV_Ith_S(y, 0), v = NV_Ith_S(y, 1);
  NV_Ith_S(out, 0) = v;
  NV_Ith_S(out, 1) = -9.81 + (ball.touch ? 1e4 * (0.1 - height) - ball.c * v : 0);
  return 0;
}

int gap(realtype /*t*/, N_Vector y, realtype* out, void* /*data*/) {
  out[0] = NV_Ith_S(y, 0) - 0.1;
  return 0;
}

std::vector<Row> run(double c, double tolerance, const std::vector<double>& times,
                     long long* calls) {
  SUNContext context;
  SUNContext_Create(nullptr, &context);
  N_Vector y = N_VNew_Serial(2, context);
  NV_Ith_S(y, 0) = 1;
  NV_Ith_S(y, 1) = 0;
  Ball ball{c, false, 0};
  void* cvode = CVodeCreate(CV_ADAMS, context);
  CVodeInit(cvode, rate, 0, y);
  CVodeSStolerances(cvode, tolerance, tolerance);
  CVodeSetUserData(cvode, &ball);
  CVodeSetMaxNumSteps(cvode, 10000000);
  SUNNonlinearSolver solver = SUNNonlinSol_FixedPoint(y, 0, context);
  CVodeSetNonlinearSolver(cvode, solver);
  CVodeRootInit(cvode, 1, gap);
  int direction = -1;  // a flight ends when the gap falls through zero, a touch when it rises
  CVodeSetRootDirection(cvode, &direction);

  std::vector<Row> rows;
  realtype t = 0;
  bool good = true;
  for (const double until : times) {
    while (good && t < until) {
      const int flag = CVode(cvode, until, y, &t, CV_NORMAL);
      good = flag >= 0;
      if (flag == CV_ROOT_RETURN) {
        ball.touch = !ball.touch;
        direction = -direction;
        NV_Ith_S(y, 0) = 0.1;
        CVodeReInit(cvode, t, y);
        CVodeSetRootDirection(cvode, &direction);
      }
    }
    if (good) rows.push_back({NV_Ith_S(y, 0), NV_Ith_S(y, 1)});
  }
  *calls = ball.calls;
  CVodeFree(&cvode);
  SUNNonlinSolFree(solver);
  N_VDestroy(y);
  SUNContext_Free(&context);
  return rows;
}

}  // namespace

void add_cvode(Case& on, double damping) {
  for (const double tolerance : geometric(1e-4, 1e-12, 2)) {
    Subject subject{"CVODE Adams + events", "tolerance", tolerance, true, {}, {}};
    const double t_end = on.t_end;
    subject.sample = [=](const std::vector<double>& times) {
      long long calls = 0;
      return run(damping, tolerance, times, &calls);
    };
    subject.run = [=] {
      long long calls = 0;
      const std::vector<Row> rows = run(damping, tolerance, {t_end}, &calls);
      return rows.empty() ? 0.0 : rows.back()[0];
    };
    subject.evaluations = [=] {
      long long calls = 0;
      run(damping, tolerance, {t_end}, &calls);
      return calls;
    };
    on.subjects.push_back(subject);
  }
}

}  // namespace bounce::report
