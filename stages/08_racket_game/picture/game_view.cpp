#include "08_racket_game/picture/game_view.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "08_racket_game/picture/court_drawing.hpp"
#include "08_racket_game/picture/marks.hpp"
#include "08_racket_game/picture/score_board.hpp"
#include "app/drawing.hpp"
#include "app/layout.hpp"
#include "app/palette.hpp"
#include "app/space_drawing.hpp"
#include "run/rows.hpp"

namespace bounce {

using Eigen::Vector3d;

namespace {

constexpr double opening = 40;           // degrees
constexpr double camera_height = 1.15;   // m above the racket
constexpr double camera_distance = 2.7;  // m
constexpr double raised = 0.4;           // m, what it looks at above the racket
constexpr double follows_within = 0.7;   // s: calmly
constexpr double flash_lasts = 0.15;     // s

double flash(const Court& court, const View& view) {
  if (view.calm || !court.game) return 0;
  const Round& round = court.game->round();
  return std::clamp(1 - (round.clock - round.touch_clock) / flash_lasts, 0.0, 1.0);
}

/// The touches, and blind the beats between them, which sound softer.
Knock last_sound(const GameRun& game) {
  constexpr double soft = 1.5;  // m/s
  const Round& round = game.round();
  if (!game.settings().on_beat() || round.score.lost) return {round.touches, round.touch_speed};
  const Beat beat = beat_of(game.settings());
  const int beats = beat.count(round.clock);
  const double last = beat.first + (beats - 1) * beat.period;
  const bool is_beat = beats > 0 && last > round.touch_clock;
  return {round.touches + beats, is_beat ? soft : round.touch_speed};
}

}  // namespace

Camera GameView::camera_for(const Court& court, double t) {
  const Vector3d home = court.home, now = court.racket.disc.centre;
  const Vector3d aim = court.game ? Vector3d(home + 0.5 * (now - home)) : now;
  if (t < last_t_ || last_t_ < 0 || !court.game) focus_ = aim;
  const double share = 1 - std::exp(-(t - last_t_) / follows_within);
  if (t > last_t_) focus_ += share * (aim - focus_);
  last_t_ = t;
  home_height_ = home.y();
  const Vector3d eye = focus_ + Vector3d(0, camera_height, camera_distance);
  return {eye, focus_ + Vector3d(0, raised, 0), Vector3d::UnitY(), area_, opening};
}

std::optional<Vector3d> GameView::on_racket_plane(Point pixel) const {
  const Vector3d eye = focus_ + Vector3d(0, camera_height, camera_distance);
  const Camera camera(eye, focus_ + Vector3d(0, raised, 0), Vector3d::UnitY(), area_, opening);
  const Vector3d sight = camera.under(pixel, focus_) - eye;
  const double farthest = 4 * camera_distance;
  if (!(sight.y() < 0)) return std::nullopt;  // above the horizon
  return eye + sight * std::min((home_height_ - eye.y()) / sight.y(), farthest);
}

void GameView::draw_scene(Canvas& canvas, const Court& court, double t,
                          std::span<const TrailPoint> trail, const View& view) {
  const Camera camera = camera_for(court, t);
  const Vector3d ball = court.ball.position;
  const Disc disc = court.racket.disc;
  const double radius = court.racket.radius;

  const bool unseen = court.game && court.game->settings().on_beat() && !again_.is_on();
  if (court.game) {
    const double height = court.game->floor_height();
    const Plane floor{Vector3d::UnitY(), -height};
    draw_sky(canvas, camera, area_, height);
    draw_floor(canvas, camera, height, focus_);
    draw_disc_shadow(canvas, camera, disc, height);
    if (!unseen) draw_shadow(canvas, camera, floor, ball, radius);
  }
  // No depth buffer: what is on the far side of the disc is drawn first.
  const Vector3d eye = focus_ + Vector3d(0, camera_height, camera_distance);
  const bool from_front = disc.height(eye) > 0;
  const double glow = again_.is_on() ? 0 : flash(court, view);
  if (unseen) return draw_disc(canvas, camera, disc, from_front, glow);
  const bool ball_behind = (disc.height(ball) > 0) != from_front;
  const NearestPoint nearest = court.racket.nearest(disc, ball);
  const auto draw_ball = [&] {
    if (view.trail) draw_game_trail(canvas, camera, trail);
    draw_flattened_ball(canvas, camera, ball, radius, nearest);
  };
  if (ball_behind) draw_ball();
  draw_disc(canvas, camera, disc, from_front, glow);
  if (!ball_behind && disc.normal.y() > 0 && disc.outwards(ball).norm() < disc.radius) {
    draw_shadow(canvas, camera, {disc.normal, -disc.normal.dot(disc.centre)}, ball, radius);
  }
  if (court.game && !again_.is_on() && court.game->settings().counts_points()) {
    draw_goal(canvas, camera, court);
  }
  draw_landing(canvas, camera, court);
  if (glow > 0 && camera.sees(court.game->round().touch_place)) {
    canvas.circle(camera.at(court.game->round().touch_place), static_cast<float>(40 - 28 * glow),
                  accent.faded(glow), 2.5f);
  }
  if (!ball_behind) draw_ball();
  if (again_.is_on()) draw_arrows(canvas, camera, court, again_.now(), again_.touch());
  if (const Point at = camera.at(ball); camera.depth(ball) > 0 && at.y < area_.y - 5) {
    const Point tip{std::clamp(at.x, area_.x + 20, area_.right() - 20), area_.y + 8};
    draw_arrow(canvas, {tip.x, tip.y + 34}, tip, palette::motion, Shaft::velocity);
    draw_label(canvas, {tip.x + 14, tip.y + 12}, with_unit(ball.y() - court.home.y(), "m"),
               palette::ink);
  }
}

void GameView::draw_court(Canvas& canvas, const Playback& playback, const View& view) {
  Court court = court_of(playback.simulation());
  if (again_.is_on()) {
    court.ball = again_.now().ball;
    court.racket.disc = again_.now().disc;
    return draw_scene(canvas, court, again_.now().t, again_.trail(), view);
  }
  court.ball = state_in<Vector3d>(playback.shown_values());
  const double now = playback.shown_time();
  std::vector<TrailPoint> trail;
  for (auto point = playback.trace().rbegin(); point != playback.trace().rend(); ++point) {
    if (now - point->t > trail_lasts) break;
    trail.push_back({now - point->t, state_in<Vector3d>(point->values).position});
  }
  draw_scene(canvas, court, now, trail, view);
}

void GameView::draw(Canvas& canvas, const Playback& playback, const View& view) {
  const GameRun* game = run_if<GameRun>(playback.simulation());
  area_ = game ? view.whole : layout::scene;
  again_.follow(playback);
  canvas.push_clip(area_);
  draw_court(canvas, playback, view);
  if (game) {
    const bool blind = game->settings().player == PlayerKind::blind;
    if (blind) draw_blind_history(canvas, *game, playback, area_);
    if (game->settings().on_beat() && !again_.is_on()) {
      const double phase = beat_of(game->settings()).phase(playback.shown_time());
      draw_beat(canvas, {area_.x + area_.width / 2, area_.y + 200}, phase,
                view.calm ? 0 : std::max(0.0, 1 - phase / 0.15));
    }
    draw_score_board(canvas, *game, area_, view);
    if (game->round().score.lost && !view.help) draw_loss(canvas, *game, again_, area_);
  }
  if (is_live && playback.paused) {
    draw_label(canvas, {area_.width / 2, 60}, "paused (P)", palette::ink, Align::centre,
               TextSize::title);
  }
  if (!playback.trouble().empty()) {
    draw_label(canvas, {area_.x + 20, area_.bottom() - 90}, playback.trouble(), palette::ink);
  }
  canvas.pop_clip();
}

std::shared_ptr<GameView> use_game_view(Demo& demo) {
  const auto view = std::make_shared<GameView>();
  demo.picture = [view](const Playback& playback, const View& seen, Canvas& canvas) {
    view->draw(canvas, playback, seen);
  };
  demo.knock = [](const Playback& playback) {
    const GameRun* game = run_if<GameRun>(playback.simulation());
    return game ? last_sound(*game) : Knock{};
  };
  demo.is_over = [](const Playback& playback) {  // a machine that has lost serves again
    const GameRun* game = run_if<GameRun>(playback.simulation());
    return game && game->round().score.lost && game->settings().player != PlayerKind::human &&
           game->round().clock - game->round().lost_clock > 2;
  };
  return view;
}

}  // namespace bounce
