#include "app/window.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>

#include "app/drawing.hpp"
#include "app/layout.hpp"
#include "app/palette.hpp"
#include "run/interrupt.hpp"
#include "run/save_load.hpp"

namespace bounce {

constexpr double chart_budget = 0.004;  // s of computing in one frame

Video::Video(bool seen) {
  if (!seen) {
    SDL_setenv("SDL_VIDEODRIVER", "dummy", 1);
    SDL_SetHint(SDL_HINT_RENDER_DRIVER, "software");
  }
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");  // Ctrl-C ends the program
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
    : demo_(demo), seen_(seen), video_(seen), player_(std::move(simulation)) {
  const std::string title = "Bounce " + demo.title;
  window_ = SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                             layout::width, layout::height, SDL_WINDOW_RESIZABLE);
  if (window_ != nullptr) {
    renderer_ = SDL_CreateRenderer(window_, -1, seen ? SDL_RENDERER_PRESENTVSYNC : 0);
    if (renderer_ == nullptr) renderer_ = SDL_CreateRenderer(window_, -1, SDL_RENDERER_SOFTWARE);
  }
  if (renderer_ == nullptr) {
    const std::string why = SDL_GetError();
    if (window_ != nullptr) SDL_DestroyWindow(window_);
    throw MachineFailure("no window: " + why);
  }
  SDL_RenderSetLogicalSize(renderer_, layout::width, layout::height);
  backend_ = std::make_unique<ImGuiBackend>(renderer_);
  canvas_.load_fonts();
  backend_->upload_fonts();
  panel_ = std::make_unique<Panel>(demo_, seen);
  view_.trail = !options.calm;
  view_.calm = options.calm;
  if (!seen) player_.budget = std::numeric_limits<double>::infinity();
  if (seen && demo_.knock) sound_ = std::make_unique<Sound>();
}

Window::~Window() {
  sound_.reset();
  panel_.reset();
  backend_.reset();
  SDL_DestroyRenderer(renderer_);
  SDL_DestroyWindow(window_);
}

bool Window::tick(double real_seconds) {
  clock_ += real_seconds;
  for (SDL_Event event; SDL_PollEvent(&event) != 0;) handle(event);
  drag();
  if (is_game() && seen_) play_game(real_seconds);
  const Uint64 begin = SDL_GetPerformanceCounter();
  if (!holding_) player_.frame(real_seconds);
  const Uint64 moved = SDL_GetPerformanceCounter();
  if (sound_) sound();
  if (seen_ && demo_.is_over && demo_.is_over(player_)) player_.restart();
  if ((SDL_GetWindowFlags(window_) & SDL_WINDOW_MINIMIZED) != 0) return !closed_;
  const Uint64 drawing = SDL_GetPerformanceCounter();
  draw();
  const auto seconds = [](Uint64 count) {
    return static_cast<double>(count) / static_cast<double>(SDL_GetPerformanceFrequency());
  };
  panel_->frame_cost.note(seconds(moved - begin), seconds(SDL_GetPerformanceCounter() - drawing));
  SDL_RenderPresent(renderer_);  // waits for the screen, which costs nothing
  return !closed_;
}

void Window::handle(const SDL_Event& event) {
  backend_->event(event);
  if (event.type == SDL_QUIT) closed_ = true;
  if (event.type == SDL_KEYDOWN) key(event.key.keysym.sym);
  if (event.type == SDL_MOUSEMOTION) controls_.mouse_moved = true;
  if (event.type == SDL_MOUSEBUTTONDOWN && event.button.button == SDL_BUTTON_LEFT) {
    const Point at{static_cast<float>(event.button.x), static_cast<float>(event.button.y)};
    holding_ = !choose_from_chart(at) && demo_.is_on_ball && demo_.is_on_ball(player_, view_, at);
    mouse_.clear();
  }
  if (event.type == SDL_MOUSEBUTTONUP) holding_ = false;
}

/// A click on a dot of the chart takes its method and its time step. Returns whether the click was
/// the chart's.
bool Window::choose_from_chart(Point at) {
  const Rect area = layout::chart;
  const bool inside =
      at.x >= area.x && at.x <= area.right() && at.y >= area.y && at.y <= area.bottom();
  if (!view_.chart || demo_.bare || !inside) return false;
  if (const std::optional<ChartChoice> choice = error_chart_choice(area, chart_, at)) {
    player_.change([&choice](Simulation& simulation) {
      simulation.use_method(choice->method);
      if (choice->dt > 0) simulation.use_dt(choice->dt);
    });
  }
  return true;
}

/// What the keys and the mouse are doing now goes to the game.
void Window::play_game(double real_seconds) {
  const Uint8* keys = SDL_GetKeyboardState(nullptr);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  controls_.mouse = {mouse.x, mouse.y};
  controls_.button = (SDL_GetMouseState(nullptr, nullptr) & SDL_BUTTON_LMASK) != 0;
  controls_.space = keys[SDL_SCANCODE_SPACE] != 0;
  controls_.left = keys[SDL_SCANCODE_LEFT] != 0;
  controls_.right = keys[SDL_SCANCODE_RIGHT] != 0;
  controls_.up = keys[SDL_SCANCODE_UP] != 0;
  controls_.down = keys[SDL_SCANCODE_DOWN] != 0;
  controls_.a = keys[SDL_SCANCODE_A] != 0;
  controls_.d = keys[SDL_SCANCODE_D] != 0;
  controls_.w = keys[SDL_SCANCODE_W] != 0;
  controls_.s = keys[SDL_SCANCODE_S] != 0;
  controls_.seconds = real_seconds;
  demo_.control(player_, view_, controls_);
  controls_.mouse_moved = controls_.less = controls_.more = false;
}

void Window::sound() {
  const Knock knock = demo_.knock(player_);
  if (knock.count > knocks_ && !view_.muted) sound_->knock(knock.speed);
  knocks_ = knock.count;
}

void Window::key(SDL_Keycode key) {
  const bool is_for_the_game = key == SDLK_SPACE || key == SDLK_LEFT || key == SDLK_RIGHT;
  if (is_game() && is_for_the_game) return;
  switch (key) {
    case SDLK_ESCAPE:
      closed_ = true;
      break;
    case SDLK_p:
    case SDLK_SPACE:
      player_.paused = !player_.paused;
      break;
    case SDLK_PERIOD:
    case SDLK_RIGHT:
      player_.step_forward();
      break;
    case SDLK_COMMA:
    case SDLK_LEFT:
      player_.step_back();
      break;
    case SDLK_r:
      player_.restart();
      break;
    case SDLK_o:
      player_.rate = player_.rate < 1 ? 1 : 0.1;
      break;
    case SDLK_l:
      player_.contact_lens = !player_.contact_lens;
      break;
    case SDLK_t:
      view_.from_above = demo_.in_space && !view_.from_above;
      break;
    case SDLK_e:
      view_.chart = !view_.chart;
      break;
    case SDLK_m:
      view_.muted = !view_.muted;
      break;
    case SDLK_MINUS:
    case SDLK_KP_MINUS:
      controls_.less = true;
      break;
    case SDLK_PLUS:
    case SDLK_EQUALS:
    case SDLK_KP_PLUS:
      controls_.more = true;
      break;
    case SDLK_F1:
      view_.help = !view_.help;
      break;
    case SDLK_F12:
      screenshot_ = demo_.stage.name + ".png";
      break;
    default:
      break;
  }
}

/// The held ball follows the mouse, and leaves with the mouse's mean velocity over the last 80 ms
/// (a single movement of a mouse is too jumpy).
void Window::drag() {
  if (!holding_) return;
  const ImVec2 at = ImGui::GetIO().MousePos;
  mouse_.push_back({clock_, {at.x, at.y}});
  while (mouse_.size() > 2 && mouse_.front().t < clock_ - 0.08) mouse_.pop_front();
  const MouseSample &first = mouse_.front(), &last = mouse_.back();
  const auto span = static_cast<float>(last.t - first.t);
  Point velocity{0, 0};
  if (span > 0) velocity = {(last.at.x - first.at.x) / span, (last.at.y - first.at.y) / span};
  demo_.drag(player_, view_, last.at, velocity);
}

void Window::draw() {
  SDL_SetRenderDrawColor(renderer_, palette::paper.red, palette::paper.green, palette::paper.blue,
                         255);
  SDL_RenderClear(renderer_);
  SDL_SetRenderDrawBlendMode(renderer_, SDL_BLENDMODE_BLEND);
  backend_->begin_frame(layout::width, layout::height);
  demo_.picture(player_, view_, canvas_);
  if (!demo_.bare) {
    draw_energy_column(canvas_, layout::energy, player_.trace().back());
    for (std::size_t i = 0; i < demo_.plots.size() && i < 2; ++i) {
      plots_[i].draw(canvas_, layout::plots[i], demo_.plots[i], player_);
    }
    if (view_.chart) draw_chart();
    if (view_.help) draw_help();
    panel_->draw(player_, view_);
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
  SDL_RenderFlush(renderer_);  // now, and not when it is presented: so it can be timed
}

/// The chart computes a little in every frame. Unseen, all at once: then every picture is whole.
void Window::draw_chart() {
  const Simulation& simulation = player_.simulation();
  chart_.follow(simulation, seen_ ? 15 : 0);
  chart_.work(seen_ ? chart_budget : 1e9);
  draw_error_chart(canvas_, layout::chart, chart_, simulation.method(), simulation.dt());
}

void Window::draw_help() {
  static constexpr std::array<std::array<const char*, 2>, 12> keys{
      {{"P, Space", "pause, play"},
       {".  or Right", "one step forward"},
       {",  or Left", "one step back"},
       {"R", "restart"},
       {"O", "slow motion (1/10)"},
       {"L", "contact lens: a contact lasts a second"},
       {"E", "speed against error, now: click a dot to choose it"},
       {"T", "from above, from the side (stages in space)"},
       {"mouse", "drag the ball, and throw it"},
       {"F12", "save a picture"},
       {"F1", "this page"},
       {"Esc", "quit"}}};
  const Rect area{150, 110, 490, 354};
  draw_rect(canvas_, area, palette::paper.faded(0.95));
  draw_frame(canvas_, area, palette::ink, 1);
  float y = area.y + 16;
  for (const auto& [key, meaning] : keys) {
    canvas_.text({area.x + 24, y}, key, palette::ink, Align::left, TextSize::normal);
    canvas_.text({area.x + 150, y}, meaning, palette::ink, Align::left, TextSize::normal);
    y += 27;
  }
}

void Window::read_pixels() {
  int width = 0, height = 0;
  SDL_GetRendererOutputSize(renderer_, &width, &height);
  pixels_.width = width;
  pixels_.height = height;
  pixels_.rgb.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
  SDL_RenderReadPixels(renderer_, nullptr, SDL_PIXELFORMAT_RGB24, pixels_.rgb.data(), 3 * width);
}

bool has_window() { return true; }

bool show_window(const Demo& demo, std::unique_ptr<Simulation> simulation, const Options& options) {
  std::unique_ptr<Window> window;
  try {
    window = std::make_unique<Window>(demo, std::move(simulation), options, true);
  } catch (const MachineFailure& failure) {
    std::cerr << demo.stage.name << ": " << failure.what()
              << "; running without a window instead\n";
    return false;
  }
  const auto frequency = static_cast<double>(SDL_GetPerformanceFrequency());
  Uint64 last = SDL_GetPerformanceCounter();
  double frame = 1.0 / 60;
  catch_interrupts();
  while (window->tick(frame) && !interrupted()) {
    Uint64 now = SDL_GetPerformanceCounter();
    const double spent = static_cast<double>(now - last) / frequency;
    if (spent < 1.0 / 65)
      SDL_Delay(static_cast<Uint32>((1.0 / 62 - spent) * 1000));  // no vsync here
    now = SDL_GetPerformanceCounter();
    frame = static_cast<double>(now - last) / frequency;
    last = now;
  }
  if (!options.save.empty()) save_state(options.save, demo.stage, window->player().simulation());
  return true;
}

void save_picture(const Demo& demo, std::unique_ptr<Simulation> simulation, const Options& options,
                  const std::string& path) {
  Window window(demo, std::move(simulation), options, false);
  window.view().forces = true;
  Player& player = window.player();
  while (player.shown_time() < options.duration && player.trouble().empty()) {
    const double left = options.duration - player.shown_time();
    player.frame(left < 1.5 / 60 ? left : 1.0 / 60);
    if (left < 1e-9) break;
  }
  if (player.is_refused()) throw BadInput(player.trouble());
  window.keep_pixels = true;
  player.paused = true;
  window.tick(0);  // Dear ImGui lays out in the first frame,
  window.tick(0);  // and draws in the second
  write_png(path, window.pixels());
}

void record_clip(const Demo& demo, std::unique_ptr<Simulation> simulation, const Options& options,
                 const std::string& path) {
  Recorder recorder(path);
  Window window(demo, std::move(simulation), options, false);
  window.view().forces = true;
  window.keep_pixels = true;
  catch_interrupts();
  const double frame = 1.0 / recorder.frames_per_second();
  const Player& player = window.player();
  while (player.shown_time() < options.duration && window.tick(frame) && !interrupted()) {
    recorder.add(window.pixels());
    if (!player.trouble().empty()) break;  // its last picture says so
  }
  if (player.is_refused()) throw BadInput(player.trouble());
  recorder.finish();
}

}  // namespace bounce
