#include "app/window.hpp"

#include <iostream>
#include <limits>

#include "app/drawing.hpp"
#include "app/layout.hpp"
#include "app/palette.hpp"
#include "app/survey.hpp"

namespace bounce {

constexpr double chart_budget = 0.004;  // s of computing in one frame

Video::Video(bool seen) {
  if (!seen) {
    SDL_setenv("SDL_VIDEODRIVER", "dummy", 1);
    SDL_SetHint(SDL_HINT_RENDER_DRIVER, "software");
  }
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");  // Ctrl-C ends the program
  SDL_SetMainReady();                             // main is ours (SDL_MAIN_HANDLED)
  if (SDL_Init(SDL_INIT_VIDEO) != 0) {
    throw MachineFailure(std::string("no display: ") + SDL_GetError());
  }
  const std::string driver = SDL_GetCurrentVideoDriver();
  if (seen && (driver == "dummy" || driver == "offscreen")) {
    SDL_Quit();
    throw MachineFailure("no display: the video driver '" + driver + "' shows nothing");
  }
}

Video::~Video() { SDL_Quit(); }

Window::Window(const Demo& demo, std::unique_ptr<Simulation> simulation, const Options& options,
               bool seen)
    : demo_(demo), seen_(seen), video_(seen), playback_(std::move(simulation)) {
  const std::string title = "Bounce " + demo.title;
  window_.reset(SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                                 layout::width, layout::height, SDL_WINDOW_RESIZABLE));
  if (window_) {
    renderer_.reset(SDL_CreateRenderer(window_.get(), -1, seen ? SDL_RENDERER_PRESENTVSYNC : 0));
    if (!renderer_) renderer_.reset(SDL_CreateRenderer(window_.get(), -1, SDL_RENDERER_SOFTWARE));
  }
  if (!renderer_) throw MachineFailure(std::string("no window: ") + SDL_GetError());
  SDL_RenderSetLogicalSize(renderer_.get(), layout::width, layout::height);
  backend_ = std::make_unique<ImGuiBackend>(renderer_.get());
  canvas_.load_fonts();
  backend_->upload_fonts();
  panel_ = std::make_unique<Panel>(demo_, seen);
  view_.trail = !options.calm;
  view_.calm = options.calm;
  if (is_game(demo_) && seen) begin_game();
  read_keyboard_layout();
  view_.from_above = options.from_above && demo_.in_space;
  if (!seen) playback_.budget = std::numeric_limits<double>::infinity();
  if (seen && demo_.knock) sound_ = std::make_unique<Sound>();
}

bool Window::tick(double real_seconds) {
  clock_ += real_seconds;
  for (SDL_Event event; SDL_PollEvent(&event) != 0;) handle(event);
  const ImVec2 at = ImGui::GetIO().MousePos;
  held_.follow(demo_, playback_, view_, clock_, {at.x, at.y});
  if (is_game(demo_) && seen_) play_game(real_seconds);
  const double begin = Playback::wall_clock();
  if (!held_.is_held()) playback_.frame(real_seconds);
  const double moved = Playback::wall_clock();
  if (sound_) sound();
  if (seen_ && demo_.is_over && demo_.is_over(playback_)) playback_.restart();
  if ((SDL_GetWindowFlags(window_.get()) & SDL_WINDOW_MINIMIZED) != 0) return !closed_;
  const double drawing = Playback::wall_clock();
  draw();
  panel_->frame_cost.note(moved - begin, Playback::wall_clock() - drawing);
  SDL_RenderPresent(renderer_.get());  // waits for the screen, which costs nothing
  return !closed_;
}

void Window::sound() {
  const Knock knock = demo_.knock(playback_);
  if (knock.count > knocks_ && !view_.muted) sound_->knock(knock.speed);
  knocks_ = knock.count;
}

void Window::draw() {
  canvas_.dark = view_.dark;
  const Colour paper = view_.dark ? palette::darkened(palette::paper) : palette::paper;
  SDL_SetRenderDrawColor(renderer_.get(), paper.red, paper.green, paper.blue, 255);
  SDL_RenderClear(renderer_.get());
  SDL_SetRenderDrawBlendMode(renderer_.get(), SDL_BLENDMODE_BLEND);
  backend_->begin_frame(layout::width, layout::height);
  demo_.picture(playback_, view_, canvas_);
  if (!demo_.bare) {
    draw_energy_column(canvas_, layout::energy, playback_.trace().back());
    draw_plots();
    if (view_.chart) draw_chart();
    if (view_.help) draw_help();
    panel_->draw(playback_, view_);
  }
  backend_->end_frame();
  if (keep_pixels || !screenshot_.empty()) read_pixels();
  if (!screenshot_.empty()) {
    try {
      write_png(screenshot_, pixels_);
      std::cerr << demo_.stage.name << ": the picture is in " << screenshot_ << "\n";
    } catch (const std::exception& error) {
      std::cerr << demo_.stage.name << ": " << error.what() << "\n";
    }
    screenshot_.clear();
  }
  SDL_RenderFlush(renderer_.get());  // now, and not when it is presented: so it can be timed
}

/// Or the survey, and the section, in their place. It computes like the chart.
void Window::draw_plots() {
  const bool survey = shows_survey(demo_, view_), section = shows_section(demo_, view_);
  for (std::size_t i = 0; i < demo_.plots.size() && i < 2 && !(survey && !section); ++i) {
    if ((i == 0 && survey) || (i == 1 && section)) continue;
    plots_[i].draw(canvas_, layout::plots[i], demo_.plots[i], playback_);
  }
  if (section) demo_.survey.section(canvas_, layout::plots[1], playback_);
  if (!survey) return;
  demo_.survey.work(playback_.simulation(), seen_ ? chart_budget : 1e9);
  demo_.survey.draw(canvas_, survey_area(demo_, view_), playback_.simulation());
}

/// The chart computes a little in every frame. Unseen, all at once: then every picture is whole.
void Window::draw_chart() {
  const Simulation& simulation = playback_.simulation();
  chart_.follow(simulation, seen_ ? 15 : 0);
  chart_.work(seen_ ? chart_budget : 1e9);
  draw_error_chart(canvas_, layout::chart, chart_, simulation.method(), simulation.dt());
}

void Window::draw_help() {
  std::vector<Key> keys = keys_of(demo_);
  keys.push_back({"F12", "save a picture"});
  keys.push_back({"Esc", "quit"});
  const Rect area{150, 110, 490, 30 + 27 * static_cast<float>(keys.size())};
  draw_rect(canvas_, area, palette::paper.faded(0.95));
  draw_frame(canvas_, area, palette::ink, 1);
  float y = area.y + 16;
  for (const Key& key : keys) {
    canvas_.text({area.x + 24, y}, key.key, palette::ink, Align::left, TextSize::normal);
    canvas_.text({area.x + 150, y}, key.meaning, palette::ink, Align::left, TextSize::normal);
    y += 27;
  }
}

void Window::read_pixels() {
  int width = 0, height = 0;
  SDL_GetRendererOutputSize(renderer_.get(), &width, &height);
  pixels_.width = width;
  pixels_.height = height;
  pixels_.rgb.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
  SDL_RenderReadPixels(renderer_.get(), nullptr, SDL_PIXELFORMAT_RGB24, pixels_.rgb.data(),
                       3 * width);
}

}  // namespace bounce
