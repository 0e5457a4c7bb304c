// A stage in a page without its picture: the runs of small figures, whose curves are the page's own
// (docs/site/live/figure.js). It answers to the names of window_web.cpp that a figure calls, and a
// page loads half as much for it.
#include <emscripten.h>

#include "app/page_calls.hpp"

namespace bounce {
namespace {

struct Figure {
  Demo demo;
  std::unique_ptr<Simulation> run, fresh;  // as it is set, and with the defaults
  std::string answer;
  std::vector<double> rows;
} figure;

}  // namespace

int play_demo(int argc, const char* const* argv, const Demo& demo) {
  guard(figure.answer, [&] {
    figure.run = set_up(argc, argv, demo);
    figure.fresh = demo.make();
    figure.demo = demo;
  });
  return figure.answer.empty() ? exit_ok : exit_input;
}

}  // namespace bounce

using namespace bounce;

extern "C" {

EMSCRIPTEN_KEEPALIVE const char* page_refusal() { return figure.run ? "" : figure.answer.c_str(); }
EMSCRIPTEN_KEEPALIVE const char* page_about() {
  return (figure.answer = about_page(figure.demo, *figure.run, *figure.fresh)).c_str();
}
EMSCRIPTEN_KEEPALIVE const char* page_set(const char* name, const char* text) {
  return guard(figure.answer, [&] {
    if (is_dial(figure.demo, name)) {
      set_dial(figure.demo, *figure.run, name, text);
    } else {
      set_parameter(figure.demo, *figure.run, name, text);
    }
    figure.run->restart();
  });
}
EMSCRIPTEN_KEEPALIVE const char* page_method(const char* name, double dt) {
  return guard(figure.answer, [&] {
    figure.run->use_method(find_method(name, figure.run->methods()));
    figure.run->use_dt(dt);
    figure.run->restart();
  });
}
EMSCRIPTEN_KEEPALIVE int page_path(double seconds, int count, int with_exact) {
  guard(figure.answer,
        [&] { run_path(*figure.run, seconds, count, with_exact != 0, figure.rows); });
  return static_cast<int>(figure.rows.size());
}
EMSCRIPTEN_KEEPALIVE const double* page_rows() { return figure.rows.data(); }
EMSCRIPTEN_KEEPALIVE const char* page_answer() { return figure.answer.c_str(); }
}
