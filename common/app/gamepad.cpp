#include "app/gamepad.hpp"

namespace bounce {

Gamepad::Gamepad() {
  // Without it the game is played with keys; SDL tells of what is plugged in by an event each.
  SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER);
}

Gamepad::~Gamepad() {
  pad_.reset();  // while its subsystem is there
  SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
}

void Gamepad::handle(const SDL_Event& event, Controls& controls) {
  if (event.type == SDL_CONTROLLERDEVICEADDED) {
    pad_.reset(SDL_GameControllerOpen(event.cdevice.which));
  }
  if (event.type == SDL_CONTROLLERDEVICEREMOVED && pad_ != nullptr &&
      event.cdevice.which == SDL_JoystickInstanceID(SDL_GameControllerGetJoystick(pad_.get()))) {
    pad_.reset();
  }
  if (event.type == SDL_CONTROLLERBUTTONDOWN) {
    controls.any = true;
    if (event.cbutton.button == SDL_CONTROLLER_BUTTON_BACK) controls.next = true;
  }
}

void Gamepad::read(Controls& controls) const {
  const auto axis = [this](SDL_GameControllerAxis which) {
    return pad_ == nullptr ? 0 : SDL_GameControllerGetAxis(pad_.get(), which);
  };
  const auto is_down = [this](SDL_GameControllerButton which) {
    return pad_ != nullptr && SDL_GameControllerGetButton(pad_.get(), which) != 0;
  };
  controls.move_x = stick(axis(SDL_CONTROLLER_AXIS_LEFTX));
  controls.move_z = stick(axis(SDL_CONTROLLER_AXIS_LEFTY));
  controls.tilt_x = stick(axis(SDL_CONTROLLER_AXIS_RIGHTX));
  controls.tilt_z = stick(axis(SDL_CONTROLLER_AXIS_RIGHTY));
  controls.pad_swing = is_down(SDL_CONTROLLER_BUTTON_A) ||
                       is_down(SDL_CONTROLLER_BUTTON_LEFTSHOULDER) ||
                       is_down(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER) ||
                       stick(axis(SDL_CONTROLLER_AXIS_TRIGGERLEFT)) > 0.3 ||
                       stick(axis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT)) > 0.3;
}

}  // namespace bounce
