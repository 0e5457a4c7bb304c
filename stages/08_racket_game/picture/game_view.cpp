#include "08_racket_game/picture/game_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "08_racket_game/picture/score_board.hpp"
#include "app/drawing.hpp"
#include "app/layout.hpp"
#include "app/palette.hpp"
#include "app/space_drawing.hpp"
#include "run/rows.hpp"

namespace bounce {

using Eigen::Vector3d;

namespace {

constexpr double opening = 40;            // degrees
constexpr double camera_height = 1.15;    // m above the racket
constexpr double camera_distance = 2.7;   // m
constexpr double raised = 0.4;            // m, what it looks at above the racket
constexpr double follows_within = 0.7;    // s: calmly
constexpr double flash_lasts = 0.15;      // s
constexpr double trail_lasts = 0.35;      // s
constexpr Colour face{0xBF, 0xD3, 0xE2};  // of the racket
constexpr Colour back{0x9A, 0xAF, 0xBE};

/// A circle in space, around `centre`, square to `normal`.
std::vector<Vector3d> circle(const Vector3d& centre, const Vector3d& normal, double radius,
                             int corners = 64) {
  const auto [along, across] = axes_of(Plane{normal, 0});
  std::vector<Vector3d> points;
  for (int i = 0; i <= corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    points.push_back(centre + radius * (std::cos(angle) * along + std::sin(angle) * across));
  }
  return points;
}

Colour mixed(Colour from, Colour to, double share) {
  const auto mix = [share](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(a + share * (b - a));
  };
  return {mix(from.red, to.red), mix(from.green, to.green), mix(from.blue, to.blue), 255};
}

double flash(const Court& court, const View& view) {
  if (view.calm || !court.game) return 0;
  const Round& round = court.game->round();
  return std::clamp(1 - (round.clock - round.touch_clock) / flash_lasts, 0.0, 1.0);
}

/// Squares of half a metre that fade with the distance. Lines only: a filled floor would cost more
/// than all the rest of the picture together, where the processor has to draw it.
void draw_floor(Canvas& canvas, const Camera& camera, const Plane& floor, const Vector3d& centre) {
  constexpr double square = 0.5;  // m
  constexpr int reach = 6;        // squares
  const double height = -floor.offset;
  const double first_x = square * std::round(centre.x() / square);
  const double first_z = square * std::round(centre.z() / square);
  const auto line = [&](double x1, double z1, double x2, double z2) {
    const double away = std::hypot((x1 + x2) / 2 - centre.x(), (z1 + z2) / 2 - centre.z());
    const double share = 1 - away / (reach * square);
    if (share <= 0) return;
    const std::array<Vector3d, 2> ends{Vector3d(x1, height, z1), Vector3d(x2, height, z2)};
    draw_path(canvas, camera, ends, palette::exact.faded(0.5 * share), 1);
  };
  for (int i = -reach; i <= reach; ++i) {
    for (int j = -reach; j < reach; ++j) {
      const double a = square * i, b = square * j, c = square * (j + 1);
      line(first_x + a, first_z + b, first_x + a, first_z + c);
      line(first_x + b, first_z + a, first_x + c, first_z + a);
    }
  }
}

/// The disc is drawn as large as it counts.
void draw_disc(Canvas& canvas, const Camera& camera, const Disc& disc, bool from_front,
               double glow) {
  const std::vector<Vector3d> rim = circle(disc.centre, disc.normal, disc.radius);
  const Colour fill = mixed(from_front ? face : back, palette::spring, 0.6 * glow);
  draw_patch(canvas, camera, rim, {fill.red, fill.green, fill.blue, 235});
  const auto inner = circle(disc.centre, disc.normal, disc.radius / 2, 48);
  draw_path(canvas, camera, inner, palette::motion.faded(0.35), 1);
  draw_path(canvas, camera, rim, palette::motion, 3);
}

void draw_disc_shadow(Canvas& canvas, const Camera& camera, const Disc& disc, double floor) {
  std::vector<Vector3d> shadow = circle(disc.centre, disc.normal, disc.radius, 40);
  for (Vector3d& point : shadow) point.y() = floor;
  draw_patch(canvas, camera, shadow, palette::ink.faded(0.10));
}

/// Where the ball will come down to the racket's height: a cross, and a ring that closes.
void draw_landing(Canvas& canvas, const Camera& camera, const Court& court) {
  const double height = court.racket.disc.centre.y(), radius = court.racket.radius;
  const Landing next = landing(court.ball, court.racket.gravity, height + radius);
  if (next.after == never || next.after > 3) return;
  Vector3d place = next.place;
  place.y() = height + 0.004;
  const double size = radius * (0.5 + 1.5 * std::min(1.0, next.after));
  draw_path(canvas, camera, circle(place, Vector3d::UnitY(), size, 40), palette::damper, 2);
  for (const Vector3d& arm : {Vector3d(0.05, 0, 0), Vector3d(0, 0, 0.05)}) {
    const std::array<Vector3d, 2> line{place - arm, place + arm};
    draw_path(canvas, camera, line, palette::damper, 2);
  }
}

void draw_trail(Canvas& canvas, const Camera& camera, const Player& player) {
  const double now = player.shown_time();
  std::vector<Vector3d> path;
  std::vector<double> ages;
  for (auto point = player.trace().rbegin(); point != player.trace().rend(); ++point) {
    if (now - point->t > trail_lasts) break;
    path.push_back(state_in<Vector3d>(point->values).position);
    ages.push_back((now - point->t) / trail_lasts);
  }
  for (std::size_t i = 0; i + 4 < path.size(); i += 4) {
    const std::array<Vector3d, 2> piece{path[i], path[i + 4]};
    const double share = std::clamp(1 - ages[i], 0.0, 1.0);
    draw_path(canvas, camera, piece, palette::motion.faded(0.55 * share),
              static_cast<float>(2 + 5 * share));
  }
}

/// A ball in contact is flattened by its real overlap; its volume stays.
void draw_ball(Canvas& canvas, const Camera& camera, const Vector3d& centre, double radius,
               const NearestPoint& nearest) {
  if (!(nearest.distance < radius) || !(nearest.distance > 0.3 * radius) || !camera.sees(centre)) {
    return draw_ball_in_space(canvas, camera, centre, radius);
  }
  const double flat = nearest.distance, wide = radius * std::sqrt(radius / flat);
  const Point at = camera.at(centre), foot = camera.at(centre + nearest.direction * 0.01);
  const float length = std::max(1e-3f, std::hypot(foot.x - at.x, foot.y - at.y));
  const Point up{(foot.x - at.x) / length, (foot.y - at.y) / length};
  const float tall = static_cast<float>(flat) * camera.per_metre(centre);
  const float broad = static_cast<float>(wide) * camera.per_metre(centre);
  std::vector<Point> outline;
  for (int i = 0; i <= 40; ++i) {
    const double angle = 2 * std::numbers::pi * i / 40;
    const float a = tall * static_cast<float>(std::sin(angle));
    const float b = broad * static_cast<float>(std::cos(angle));
    outline.push_back({at.x + a * up.x - b * up.y, at.y + a * up.y + b * up.x});
  }
  canvas.fill(outline, palette::ball);
  canvas.line(outline, palette::ink, 1.5f);
}

}  // namespace

Court court_of(const Simulation& simulation) {
  Court court;
  court.ball = state_in<Vector3d>(simulation.values());
  if (const GameRun* game = run_if<GameRun>(simulation)) {
    court.game = game;
    court.racket = game->scene_now();
    court.home = game->settings().racket.disc.centre;
  } else {
    const BareRacketWorld& world = run_as<BareRacketRun>(simulation).world();
    court.racket = world.scene_now();
    court.racket.disc = world.disc(simulation.time());
    court.home = world.setup.racket.disc.centre;
  }
  return court;
}

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

void GameView::draw_scene(Canvas& canvas, const Player& player, const View& view) {
  const Court court = court_of(player.simulation());
  const Camera camera = camera_for(court, player.shown_time());
  const Vector3d ball = state_in<Vector3d>(player.shown_values()).position;
  const Disc disc = court.racket.disc;
  const double radius = court.racket.radius;

  if (court.game) {
    const double height = court.game->floor_height();
    const Plane floor{Vector3d::UnitY(), -height};
    draw_floor(canvas, camera, floor, focus_);
    draw_disc_shadow(canvas, camera, disc, height);
    draw_shadow(canvas, camera, floor, ball, radius);
  }
  // No depth buffer: what is on the far side of the disc is drawn first.
  const Vector3d eye = focus_ + Vector3d(0, camera_height, camera_distance);
  const bool from_front = disc.height(eye) > 0;
  const bool ball_behind = (disc.height(ball) > 0) != from_front;
  const NearestPoint nearest = court.racket.nearest(disc, ball);
  if (view.trail && ball_behind) draw_trail(canvas, camera, player);
  if (ball_behind) draw_ball(canvas, camera, ball, radius, nearest);
  const double glow = flash(court, view);
  draw_disc(canvas, camera, disc, from_front, glow);
  if (!ball_behind && disc.normal.y() > 0 && disc.outwards(ball).norm() < disc.radius) {
    draw_shadow(canvas, camera, {disc.normal, -disc.normal.dot(disc.centre)}, ball, radius);
  }
  draw_landing(canvas, camera, court);
  if (glow > 0 && camera.sees(court.game->round().touch_place)) {
    canvas.circle(camera.at(court.game->round().touch_place), static_cast<float>(40 - 28 * glow),
                  palette::spring.faded(glow), 2.5f);
  }
  if (!ball_behind) {
    if (view.trail) draw_trail(canvas, camera, player);
    draw_ball(canvas, camera, ball, radius, nearest);
  }
  if (const Point at = camera.at(ball); camera.depth(ball) > 0 && at.y < area_.y - 5) {
    const Point tip{std::clamp(at.x, area_.x + 20, area_.right() - 20), area_.y + 8};
    draw_arrow(canvas, {tip.x, tip.y + 34}, tip, palette::motion, Shaft::velocity);
    draw_label(canvas, {tip.x + 14, tip.y + 12}, with_unit(ball.y() - court.home.y(), "m"),
               palette::ink);
  }
}

void GameView::draw(Canvas& canvas, const Player& player, const View& view, bool bare) {
  const GameRun* game = run_if<GameRun>(player.simulation());
  area_ = bare ? Rect{0, 0, layout::width, layout::height} : layout::scene;
  canvas.push_clip(area_);
  draw_scene(canvas, player, view);
  if (game) {
    const bool blind = game->settings().player == PlayerKind::blind;
    if (blind) draw_blind_history(canvas, *game, player, area_);
    draw_score_board(canvas, *game, area_, view.help, view.muted);
  }
  if (is_live && player.paused) {
    draw_label(canvas, {area_.width / 2, 60}, "paused (P)", palette::ink, Align::centre,
               TextSize::title);
  }
  if (!player.trouble().empty()) {
    draw_label(canvas, {area_.x + 20, area_.bottom() - 90}, player.trouble(), palette::ink);
  }
  canvas.pop_clip();
}

void use_game_view(Demo& demo, GameView& view) {
  demo.picture = [&demo, &view](const Player& player, const View& seen, Canvas& canvas) {
    view.draw(canvas, player, seen, demo.bare);
  };
  demo.knock = [](const Player& player) {
    const GameRun* game = run_if<GameRun>(player.simulation());
    return game ? Knock{game->round().touches, game->round().touch_speed} : Knock{};
  };
  demo.is_over = [](const Player& player) {  // a machine that has lost serves again
    const GameRun* game = run_if<GameRun>(player.simulation());
    return game && game->round().score.lost && game->settings().player != PlayerKind::human &&
           game->round().clock - game->round().lost_clock > 2;
  };
}

}  // namespace bounce
