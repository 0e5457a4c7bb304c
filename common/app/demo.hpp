#pragma once
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/canvas.hpp"
#include "app/playback.hpp"
#include "run/headless.hpp"
#include "run/whose_lines.hpp"

namespace bounce {

/// What the user wants to see.
struct View {
  bool forces = false;  // all of them; gravity is always drawn
  bool trail = true;
  bool ghost = true;
  bool help = false;
  bool chart = false;                    // speed against error
  bool calm = false;                     // nothing that flashes
  bool muted = false;                    // no sound
  bool dark = false;                     // a game's picture; a page has a switch of its own
  bool survey = false, section = false;  // always, and not only while a slider moves
  bool narrow = false;                   // a phone: the plots are below each other
  bool in_page = false;                  // of the web: no files, no controller, nothing to quit
  bool from_above = false;               // in space: the camera looks straight down
  std::string tilt_keys = "A D W S";     // what is printed on the keys in these places
  Rect whole{0, 0, 1280, 720};           // the picture of a demo without a panel
  std::vector<TracePoint> future;        // with the present setting, while a slider moves
  std::vector<TracePoint> earlier;       // with the setting before
};

/// A ball that is thrown with the pointer is not thrown faster [m/s].
inline constexpr double fastest_throw = 8;

/// One quantity against time.
struct Plot {
  std::string title;
  std::string unit;
  Colour colour;
  std::function<double(const TracePoint&)> value;
  std::function<double(const TracePoint&)> exact = {};  // drawn dashed below it; may be empty
};

/// A column of the trace, with the exact solution's below it.
Plot plot_column(const std::string& title, const std::string& unit, const std::string& column);
/// How far that column is from the exact solution's.
Plot plot_error(const std::string& title, const std::string& unit, const std::string& column);
/// Energy of motion, and in the springs [J].
Plot plot_kinetic_energy(const std::string& title);
Plot plot_spring_energy(const std::string& title);
/// The energy that the damper took; and the energy that is neither here nor taken [J].
Plot plot_lost_energy(const std::string& title);
Plot plot_energy_error(const std::string& title);

/// A slider of the demo's own, for what is no parameter but follows from some.
struct Dial {
  std::string name, unit, meaning;
  Range range;
  std::function<double(const Simulation&)> get;
  std::function<void(Simulation&, double)> set;
};

/// What becomes of a run, for all values of one parameter at once: a picture in place of the plots.
struct Survey {
  std::string parameter;
  /// Computes for so long [s] what is not known yet. Returns whether all is known.
  std::function<bool(const Simulation&, double seconds)> work;
  std::function<void(Canvas&, Rect, const Simulation&)> draw;
  std::function<std::optional<double>(Rect, Point)> value_at;  // nothing beside the picture
  /// What the run itself has come by so far: a picture in place of the second plot.
  std::function<void(Canvas&, Rect, const Playback&)> section;
};

/// What a player's hands do, for a demo that is a game: the keys that are down, and the mouse.
struct Controls {
  Point mouse{0, 0};
  bool mouse_moved = false;  // since the last frame
  bool button = false, space = false;
  bool left = false, right = false, up = false, down = false;  // arrow keys
  bool a = false, d = false, w = false, s = false;
  bool less = false, more = false;  // minus and plus, when they go down
  bool next = false;                // the key of the modes went down
  bool any = false;                 // a key or button went down that does nothing else
  // A game controller's sticks, from -1 to 1, and its buttons; a tap or a second finger.
  double move_x = 0, move_z = 0, tilt_x = 0, tilt_z = 0;
  bool pad_swing = false, touch_swing = false;
  double seconds = 0;  // since the last frame

  bool swings() const { return space || button || pad_swing || touch_swing; }

  /// What happened in the last frame is over; what is held down stays.
  void begin_frame() { mouse_moved = less = more = next = any = false; }
};

/// The last sound that a demo makes: how many there have been, and how hard the ball was hit [m/s].
struct Knock {
  long long count = 0;
  double speed = 0;
};

/// A stage's demo: a simulation and its picture. Everything else - window, sliders, keys, command
/// line, recording - is the same for all stages.
struct Demo {
  StageName stage;
  std::string title;
  std::string question;              // the one question that drives the play
  std::vector<Dial> dials;           // sliders that are no parameters
  std::vector<std::string> sliders;  // two or three parameters to begin with
  std::function<std::unique_ptr<Simulation>()> make;
  std::function<void(const Playback&, const View&, Canvas&)> picture;
  std::vector<Plot> plots;  // at most two
  Survey survey;            // empty where there is none
  /// Called while the mouse button is down on the ball; empty when it cannot be dragged.
  std::function<bool(const Playback&, const View&, Point)> is_on_ball;
  /// Puts the ball where the mouse is, with that velocity of the mouse [px/s].
  std::function<void(Playback&, const View&, Point, Point velocity)> drag;
  bool in_space = false;  // three dimensions: the view from above makes sense
  /// The demo starts anew (in the window only) when this says so.
  std::function<bool(const Playback&)> is_over;
  /// How a slider sets a parameter in a run, where more has to change with it; may be empty.
  std::function<void(Simulation&, const Parameter&, const std::string& text)> set;
  std::vector<StageOption> options;  // on the command line, besides those of all stages
  /// Work that an option of the stage asks for in place of the demo. Returns the exit code, or
  /// nothing when it was not asked for; may be empty.
  std::function<std::optional<int>(Simulation&, const Options&)> other_work;
  std::function<void()> at_end;  // after a run that went well; may be empty
  std::string keys;              // a game's file of keys (key_map.hpp); empty: the player's own
  bool bare = false;             // the picture alone: no panel, no plots
  /// For a game: called once a frame, before time moves. Space and the arrows are the game's then.
  std::function<void(Playback&, const View&, const Controls&)> control;
  std::function<Knock(const Playback&)> knock;  // may be empty
};

/// Whether demos have pictures. A small figure of a web page draws one curve by itself, and does
/// not load what draws others.
#ifdef BOUNCE_FIGURE
inline constexpr bool has_picture = false;
#else
inline constexpr bool has_picture = true;
#endif

/// As a slider sets a parameter: of a run by itself, and of one that is played.
void set_parameter(const Demo& demo, Simulation& simulation, const std::string& name,
                   const std::string& text);
void set_parameter(const Demo& demo, Playback& playback, const std::string& name,
                   const std::string& text);

/// Reads the command line, and runs headless or in a window. Returns the exit code.
int play_demo(int argc, const char* const* argv, const Demo& demo);

/// The main program of every stage. It says so when it runs on a learner's lines. (Each program has
/// its own, hence `static`: the libraries do not know.)
static inline int play(int argc, const char* const* argv, Demo& demo) {
  if (is_mine) {
    std::cerr << demo.stage.name << ": " << whose_lines << "\n";
    demo.title += std::string(" (") + whose_lines + ")";
  }
  return play_demo(argc, argv, demo);
}

// ---- Implemented by the window (window.cpp), or by the null app where SDL2 is missing.

/// Shows the demo until the user closes it. Returns false, and says why on standard error, when
/// there is no display.
bool show_window(const Demo& demo, std::unique_ptr<Simulation> simulation, const Options& options);
/// Saves what the window would show at the end of the duration. Throws MachineFailure.
void save_picture(const Demo& demo, std::unique_ptr<Simulation> simulation, const Options& options,
                  const std::string& path);
/// Records what the window would show during the duration. Throws MachineFailure.
void record_clip(const Demo& demo, std::unique_ptr<Simulation> simulation, const Options& options,
                 const std::string& path);
/// Whether this build can draw at all.
bool has_window();

}  // namespace bounce
