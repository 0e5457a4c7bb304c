// What the user does to the window: keys, mouse, and clicks on the chart.
#include "app/kept_number.hpp"
#include "app/layout.hpp"
#include "app/survey.hpp"
#include "app/window.hpp"
#include "run/file_name.hpp"

namespace bounce {

void Window::handle(const SDL_Event& event) {
  backend_->event(event);
  if (event.type == SDL_QUIT) closed_ = true;
  if (event.type == SDL_KEYDOWN) key(keys_.meaning_of(event.key.keysym));
  if (gamepad_) gamepad_->handle(event, controls_);
  if (gamepad_ && (event.type == SDL_FINGERDOWN || event.type == SDL_FINGERUP ||
                   event.type == SDL_FINGERMOTION)) {
    touch(event.tfinger);
  }
  if (event.type == SDL_MOUSEBUTTONDOWN) controls_.any = true;
  if (event.type == SDL_KEYMAPCHANGED) read_keyboard_layout();
  if (event.type == SDL_MOUSEMOTION) controls_.mouse_moved = true;
  if (event.type == SDL_MOUSEBUTTONDOWN && event.button.button == SDL_BUTTON_LEFT) {
    const Point at{static_cast<float>(event.button.x), static_cast<float>(event.button.y)};
    if (!choose_from_chart(demo_, view_, chart_, playback_, at) &&
        !choose_from_survey(demo_, view_, playback_, at)) {
      held_.take(demo_, playback_, view_, at);
    }
  }
  if (event.type == SDL_MOUSEBUTTONUP) held_.let_go();
}

/// The keys that tilt the racket are places, so that they lie alike on every keyboard. What is
/// printed on them? Where that is another alphabet, the Latin letters stand there, too.
void Window::read_keyboard_layout() {
  std::string names;
  for (const SDL_Scancode place :
       {SDL_SCANCODE_A, SDL_SCANCODE_D, SDL_SCANCODE_W, SDL_SCANCODE_S}) {
    const SDL_Keycode key = SDL_GetKeyFromScancode(keys_.key_for(place));
    if (key < 'a' || key > 'z') return;
    names += std::string(names.empty() ? "" : " ") + SDL_GetKeyName(key);
  }
  view_.tilt_keys = names;
}

/// All other letters go by what the layout says, and by their place where it has no Latin ones.
void Window::key(SDL_Keysym pressed) {
  const SDL_Keycode key = pressed.sym;
  const auto press_ = [this](char letter) {
    return press(letter, demo_, playback_, view_, controls_);
  };
  switch (key) {
    case SDLK_ESCAPE:
      closed_ = true;
      break;
    case SDLK_F12:
      screenshot_ = demo_.stage.name + ".png";
      break;
    case SDLK_F1:
      press_('?');
      break;
    case SDLK_LEFT:
    case SDLK_RIGHT:
      if (!is_game(demo_)) press_(key == SDLK_LEFT ? ',' : '.');
      controls_.any = true;
      break;
    case SDLK_KP_MINUS:
      press_('-');
      break;
    case SDLK_KP_PLUS:
    case SDLK_EQUALS:
      press_('+');
      break;
    default: {
      const SDL_Scancode place = pressed.scancode;
      const bool has_letter = key < 128 || place < SDL_SCANCODE_A || place > SDL_SCANCODE_Z;
      const SDL_Keycode letter = has_letter ? key : 'a' + (place - SDL_SCANCODE_A);
      // SDL's code of a letter is the letter.
      if (letter >= 128 || !press_(static_cast<char>(letter))) controls_.any = true;
      break;
    }
  }
}

/// A game's own: its player's keys (by themselves keys.txt beside the best scores), a controller,
/// fingers.
void Window::begin_game() {
  const std::filesystem::path folder = kept_folder(), usual = folder / "keys.txt";
  if (!demo_.keys.empty()) {
    keys_.read(demo_.keys);
  } else if (!folder.empty() && std::filesystem::exists(usual)) {
    keys_.read(name_of(usual));
  }
  SDL_SetHint(SDL_HINT_TOUCH_MOUSE_EVENTS, "0");  // a finger moves: it is no button
  gamepad_ = std::make_unique<Gamepad>();
}

void Window::touch(const SDL_TouchFingerEvent& finger) {
  const Point at{finger.x * layout::width, finger.y * layout::height};
  if (finger.type == SDL_FINGERDOWN) fingers_.down(finger.fingerId, at, clock_);
  if (finger.type == SDL_FINGERMOTION) fingers_.move(finger.fingerId, at);
  if (finger.type == SDL_FINGERUP) fingers_.up(finger.fingerId, clock_);
  controls_.any = controls_.any || finger.type == SDL_FINGERDOWN;
}

/// What hands are doing now goes to the game.
void Window::play_game(double real_seconds) {
  const Uint8* keys = SDL_GetKeyboardState(nullptr);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  controls_.mouse = fingers_.at().value_or(Point{mouse.x, mouse.y});
  controls_.mouse_moved = controls_.mouse_moved || fingers_.at();
  controls_.touch_swing = fingers_.is_swinging(clock_);
  gamepad_->read(controls_);
  controls_.button = (SDL_GetMouseState(nullptr, nullptr) & SDL_BUTTON_LMASK) != 0;
  controls_.space = keys_.is_down(keys, SDL_SCANCODE_SPACE);
  controls_.left = keys_.is_down(keys, SDL_SCANCODE_LEFT);
  controls_.right = keys_.is_down(keys, SDL_SCANCODE_RIGHT);
  controls_.up = keys_.is_down(keys, SDL_SCANCODE_UP);
  controls_.down = keys_.is_down(keys, SDL_SCANCODE_DOWN);
  controls_.a = keys_.is_down(keys, SDL_SCANCODE_A);
  controls_.d = keys_.is_down(keys, SDL_SCANCODE_D);
  controls_.w = keys_.is_down(keys, SDL_SCANCODE_W);
  controls_.s = keys_.is_down(keys, SDL_SCANCODE_S);
  controls_.seconds = real_seconds;
  demo_.control(playback_, view_, controls_);
  controls_.begin_frame();
}

}  // namespace bounce
