#include "app/diagram.hpp"

#include "app/drawing.hpp"
#include "app/palette.hpp"

namespace bounce {

void Diagram::draw(Canvas& canvas, const std::string& title, int columns, int rows,
                   const std::string& unit, bool large) const {
  const TextSize size = large ? TextSize::title : TextSize::tick;
  for (const double y : ticks(up.lowest, up.highest, rows)) {
    const Point left = at(across.lowest, y), right = at(across.highest, y);
    draw_line(canvas, left, right, y == 0 ? palette::exact : palette::grid_major, 1);
    canvas.text({left.x - 6, left.y - (large ? 11.0f : 8.0f)}, to_rounded_text(y, 4), palette::ink,
                Align::right, size);
  }
  for (const double x : ticks(across.lowest, across.highest, columns)) {
    const Point foot = at(x, up.lowest);
    draw_line(canvas, foot, at(x, up.highest), palette::grid_minor, 1);
    canvas.text({foot.x, foot.y + 4}, to_rounded_text(x, 4) + unit, palette::exact, Align::centre,
                size);
  }
  canvas.text({box.x, box.y - (large ? 28.0f : 20.0f)}, title, palette::ink, Align::left,
              large ? TextSize::title : TextSize::normal);
}

}  // namespace bounce
