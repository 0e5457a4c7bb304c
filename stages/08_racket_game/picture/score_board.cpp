#include "08_racket_game/picture/score_board.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "app/diagram.hpp"
#include "app/drawing.hpp"
#include "app/keys.hpp"
#include "app/palette.hpp"

namespace bounce {
namespace {

std::string title_of(const Settings& settings) {
  static constexpr const char* players[] = {"", "the autopilot plays", "", "nobody plays"};
  static constexpr const char* modes[] = {"keep it up", "target: send the ball into the ring",
                                          "blind: close your eyes and swing on the beat"};
  if (settings.player == PlayerKind::blind) return "blind: a sine that never looks";
  const std::string player = players[static_cast<int>(settings.player)];
  if (player.empty()) return modes[settings.mode];
  return settings.mode == Settings::keep_up ? player : player + ": " + mode_names[settings.mode];
}

std::string hits_in_words(const Round& round) {
  return std::to_string(round.score.hits) + (round.score.hits == 1 ? " hit" : " hits");
}

void draw_keys(Canvas& canvas, Rect area, const View& view) {
  if (!view.help) {
    const std::string line = "mouse or arrows: move    " + view.tilt_keys +
                             ": tilt    Space or button: swing    G: next mode    - +: assist    "
                             "F1: all keys" +
                             (view.in_page ? "" : "    Esc: quit");
    if (canvas.text_width(line, TextSize::normal) > area.width - 24) return;  // on a phone
    draw_label(canvas, {area.x + 24, area.bottom() - 34}, line, palette::ink, Align::left,
               TextSize::normal);
    return;
  }
  std::vector<Key> keys{{"mouse, arrows", "move the racket"},
                        {view.tilt_keys.c_str(), "tilt it: left, right, away, towards you"},
                        {"Space, button", "swing upwards; after a loss any key plays on"},
                        {"G", "the next mode: keep it up, target, blind"},
                        {"- and +", "less and more help with the aim"},
                        {"P", "pause;  . and ,  one step forward and back"},
                        {"O, L", "slow motion; a contact that lasts a second"},
                        {"R", "restart"},
                        {"M, N", "sound on and off; dark and light"},
                        {"fingers", "one moves; a tap or a second one swings"}};
  if (view.in_page) {
    keys.push_back({"F1", "this page"});
  } else {
    keys.insert(keys.end(),
                {{"F12", "save a picture"},
                 {"controller", "sticks move and tilt; A or a trigger swings; Back: next mode"},
                 {"--keys FILE", "other keys: a line 'J = A' lets J do what A does"},
                 {"F1, Esc", "this page; quit"}});
  }
  const Rect page{area.width / 2 - 300, 110, 600, 34 + 29 * static_cast<float>(keys.size())};
  draw_rect(canvas, page, palette::paper.faded(0.95));
  draw_frame(canvas, page, palette::ink, 1);
  float y = page.y + 20;
  for (const auto& [key, meaning] : keys) {
    canvas.text({page.x + 24, y}, key, palette::ink, Align::left, TextSize::normal);
    canvas.text({page.x + 170, y}, meaning, palette::ink, Align::left, TextSize::normal);
    y += 29;
  }
}

/// The words in lines that are not wider than this.
std::vector<std::string> in_lines(const Canvas& canvas, const std::string& words, TextSize size,
                                  float width) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < words.size();) {
    const std::size_t end = std::min(words.find(' ', begin), words.size());
    const std::string word = words.substr(begin, end - begin);
    if (!lines.empty() && canvas.text_width(lines.back() + " " + word, size) <= width) {
      lines.back() += " " + word;
    } else {
      lines.push_back(word);
    }
    begin = end + 1;
  }
  return lines;
}

}  // namespace

void draw_score_board(Canvas& canvas, const GameRun& run, Rect area, const View& view) {
  const Round& round = run.round();
  const Settings& settings = run.settings();
  const float right = area.right() - 32;
  const auto on_the_right = [&](float y, const std::string& words, Colour colour, TextSize size) {
    canvas.text({right, area.y + y}, words, colour, Align::right, size);
  };
  const bool points = settings.counts_points();
  on_the_right(20, points ? "points" : "hits", palette::exact, TextSize::title);
  on_the_right(46, std::to_string(points ? round.points.total : round.score.hits), palette::ink,
               TextSize::score);
  on_the_right(126, "best " + std::to_string(points ? round.points.best : round.score.best),
               palette::ink, TextSize::title);
  if (points) on_the_right(152, hits_in_words(round), palette::exact, TextSize::normal);
  if (points && round.clock - round.points.clock < 0.8) {  // s
    on_the_right(182, "+ " + std::to_string(round.points.last), accent, TextSize::title);
  }

  canvas.text({area.x + 28, area.y + 20}, run.is_replay() ? "a replay" : title_of(settings),
              palette::ink, Align::left, TextSize::title);
  std::string facts = "gravity " + to_rounded_text(run.gravity()) + " m/s^2     disc " +
                      to_rounded_text(run.disc().radius * 100) + " cm";
  if (settings.player == PlayerKind::human && !settings.on_beat()) {
    facts += "     assist " + to_rounded_text(settings.assist) + " %";
  }
  if (view.muted) facts += "     sound off";
  const TextSize size = area.width < 1000 ? TextSize::tick : TextSize::normal;
  if (canvas.text_width(facts, size) < area.width / 2) {  // not on a phone
    canvas.text({area.x + 28, area.y + 48}, facts, palette::exact, Align::left, size);
  }
  draw_keys(canvas, area, view);
}

void draw_loss(Canvas& canvas, const GameRun& run, const LossAgain& again, Rect area) {
  const Round& round = run.round();
  const bool narrow = area.width < 700;  // a phone: then there is no place beside the scene
  const float width = narrow ? area.width - 16 : 330;
  const std::vector<std::string> lines =
      in_lines(canvas, again.is_on() ? canvas.in_its_language(again.sentence()) : "",
               TextSize::normal, width - 32);
  const Rect plate{area.x + (narrow ? 8.0f : 24.0f), area.y + 96, width,
                   116 + 24 * static_cast<float>(lines.size())};
  draw_rect(canvas, plate, palette::paper.faded(0.92));
  draw_frame(canvas, plate, palette::ink, 1.5f);
  float y = plate.y + 14;
  const auto line = [&](const std::string& words, Colour colour, TextSize size, float height) {
    canvas.text({plate.x + 16, y}, words, colour, Align::left, size);
    y += height;
  };
  const bool is_best = round.points.total == round.points.best && round.points.total > 0;
  line("Lost after " + hits_in_words(round) + (is_best ? ": your best" : ""), palette::ink,
       TextSize::title, 34);
  for (const std::string& words : lines) line(words, palette::ink, TextSize::normal, 24);
  y += 8;
  if (again.is_on()) line("again, at a quarter of the speed", palette::exact, TextSize::tick, 24);
  line("any key: play on", palette::ink, TextSize::normal, 24);
}

void draw_blind_history(Canvas& canvas, const GameRun& run, const Playback& playback, Rect area) {
  constexpr double seconds = 15;
  const Rect box{area.x + 28, area.y + 110, 380, 190};
  draw_rect(canvas, box, palette::paper.faded(0.9));
  draw_frame(canvas, box, palette::grid_major, 1);
  const double home = run.settings().racket.disc.centre.y();
  const double now = playback.shown_time(), first = std::max(0.0, now - seconds);
  const Diagram diagram{
      {box.x, box.y + 16, box.width, box.height - 40}, {first, first + seconds}, {0, 1.7}};
  const BlindSwing swing = blind_swing(run.settings());
  const double top = swing.top + run.settings().racket.radius;
  draw_dashed(canvas, std::array{diagram.at(first, top), diagram.at(first + seconds, top)},
              palette::exact, 1);
  std::vector<Point> ball, racket;
  const auto& trace = playback.trace();
  for (std::size_t i = 0; i < trace.size(); i += 8) {
    if (trace[i].t < first) continue;
    ball.push_back(diagram.at(trace[i].t, trace[i].column("y") - home));
    racket.push_back(diagram.at(trace[i].t, swing.height(trace[i].t)));
  }
  if (ball.size() > 1) canvas.line(ball, palette::motion, 2);
  if (racket.size() > 1) canvas.line(racket, palette::spring, 1.5f);
  const bool slowing = run.settings().strike == Settings::slowing;
  canvas.text({box.x + 8, box.y + 6},
              slowing ? "struck while the racket slows down: it finds its height"
                      : "struck while the racket speeds up: it wanders or dies",
              palette::ink, Align::left, TextSize::tick);
  canvas.text({box.x + 8, box.bottom() - 20}, "height of ball and racket, 15 s", palette::exact,
              Align::left, TextSize::tick);
}

}  // namespace bounce
