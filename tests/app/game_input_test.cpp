// A player's hands: fingers on a screen, a game controller that comes and goes, keys of his own.
#include <SDL.h>
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "app/fingers.hpp"
#include "app/gamepad.hpp"
#include "app/key_map.hpp"
#include "physics/parameters.hpp"
#include "run_program.hpp"

using namespace bounce;

TEST_CASE("one finger moves; a second one swings, and so does a tap") {
  Fingers fingers;
  CHECK_FALSE(fingers.at());
  fingers.down(7, {100, 200}, 0);
  fingers.move(7, {140, 210});
  CHECK(fingers.at()->x == 140);
  CHECK_FALSE(fingers.is_swinging(0.5));
  fingers.down(9, {600, 300}, 0.6);
  CHECK(fingers.is_swinging(0.7));
  CHECK(fingers.at()->x == 140);  // it is the first that moves
  fingers.up(9, 0.8);
  CHECK_FALSE(fingers.is_swinging(0.81));
  fingers.up(7, 0.9);  // it was down for long: no tap
  CHECK_FALSE(fingers.is_swinging(0.91));

  fingers.down(1, {50, 50}, 2);
  fingers.up(1, 2.1);
  CHECK(fingers.is_swinging(2.2));
  CHECK_FALSE(fingers.is_swinging(2.1 + Fingers::swing + 0.01));
  fingers.down(1, {50, 50}, 3);  // short, but it slipped: that was a movement
  fingers.move(1, {90, 50});
  fingers.up(1, 3.1);
  CHECK_FALSE(fingers.is_swinging(3.15));
}

TEST_CASE("a stick has a middle in which it is still, and reaches its ends") {
  CHECK(stick(0) == 0);
  CHECK(stick(4000) == 0);
  CHECK(stick(-4000) == 0);
  CHECK(stick(32767) == 1);
  CHECK(stick(-32768) == -1);
  CHECK(stick(20000) > 0.5);
  CHECK(stick(-20000) == -stick(20000));
}

TEST_CASE("a game controller may come and go") {
  REQUIRE(SDL_Init(0) == 0);
  {
    Gamepad pad;
    Controls controls;
    const auto hear = [&] {
      SDL_GameControllerUpdate();
      for (SDL_Event event; SDL_PollEvent(&event) != 0;) pad.handle(event, controls);
      pad.read(controls);
    };
    hear();
    CHECK(controls.move_x == 0);
    const int index = SDL_JoystickAttachVirtual(
        SDL_JOYSTICK_TYPE_GAMECONTROLLER, SDL_CONTROLLER_AXIS_MAX, SDL_CONTROLLER_BUTTON_MAX, 0);
    REQUIRE(index >= 0);
    hear();
    REQUIRE(pad.is_there());
    SDL_Joystick* stick_of_it = SDL_JoystickOpen(index);
    SDL_JoystickSetVirtualAxis(stick_of_it, SDL_CONTROLLER_AXIS_LEFTX, 32767);
    SDL_JoystickSetVirtualButton(stick_of_it, SDL_CONTROLLER_BUTTON_A, 1);
    hear();
    CHECK(controls.move_x == 1);
    CHECK(controls.swings());
    CHECK(controls.any);
    SDL_JoystickClose(stick_of_it);
    SDL_JoystickDetachVirtual(index);
    hear();
    CHECK_FALSE(pad.is_there());
    CHECK(controls.move_x == 0);
    CHECK_FALSE(controls.swings());
  }
  SDL_Quit();
}

TEST_CASE("a file of keys: one key does what another did, and what is wrong is said") {
  const std::string path = (std::filesystem::temp_directory_path() / "bounce_keys").string();
  const auto write = [&](const std::string& text) { std::ofstream(path) << text; };
  write("# the racket's lean\nJ = A\n Keypad 0=Space\nA = L\n");
  KeyMap keys;
  keys.read(path);
  SDL_Keysym pressed{};
  pressed.scancode = SDL_SCANCODE_J;
  CHECK(keys.meaning_of(pressed).scancode == SDL_SCANCODE_A);
  pressed.scancode = SDL_SCANCODE_W;
  CHECK(keys.meaning_of(pressed).scancode == SDL_SCANCODE_W);
  Uint8 down[SDL_NUM_SCANCODES] = {};
  down[SDL_SCANCODE_KP_0] = 1;
  CHECK(keys.is_down(down, SDL_SCANCODE_SPACE));
  down[SDL_SCANCODE_A] = 1;  // that is an L now
  CHECK_FALSE(keys.is_down(down, SDL_SCANCODE_A));
  CHECK(keys.is_down(down, SDL_SCANCODE_L));
  CHECK(keys.key_for(SDL_SCANCODE_A) == SDL_SCANCODE_J);

  for (const char* wrong : {"J\n", "J = Nose\n", "J = A = B\n", " = A\n"}) {
    write(wrong);
    CAPTURE(wrong);
    CHECK_THROWS_AS(KeyMap().read(path), BadInput);
  }
  CHECK_THROWS_AS(KeyMap().read("/nowhere/keys"), BadInput);
  CHECK(test::run_program("08_racket_game --headless --player none --keys x").code == 2);
  CHECK(test::run_program("08_racket_game --headless --keys /nowhere/keys").code == 2);
  std::filesystem::remove(path);
}
