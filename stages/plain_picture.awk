# Draws what a plain.cpp prints as SVG: height against time, a line for each ball, and one for the
# floor where it moves. ./course plain N --picture FILE.svg runs it.
BEGIN { FS = ","; left = 80; right = 875; top = 50; bottom = 435 } # of the frame, in pixels

NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
("t" in column) && ("y" in column) && $column["y"] ~ /^[-+.0-9e]+$/ { # not nan, not inf
  add("ball" in column ? "ball " ($column["ball"] + 0) : "ball", $column["t"] + 0, $column["y"] + 0)
  if ("floor" in column) add("floor", $column["t"] + 0, $column["floor"] + 0)
}
function add(line, t, y) {
  if (!(line in count)) name[++lines] = line
  time[line, ++count[line]] = t
  height[line, count[line]] = y
  if (t > end) end = t
  if (lowest == "" || y < lowest) lowest = y
  if (highest == "" || y > highest) highest = y
}

function x_of(t) { return left + (right - left) * t / end }
function y_of(y) { return bottom - (bottom - top) * (y - lowest) / (highest - lowest) }
function floor_of(x) { return int(x) > x ? int(x) - 1 : int(x) }
function step_for(range,   power) { # from tick to tick: 1, 2 or 5 times a power of ten
  power = 10 ^ floor_of(log(range / 5) / log(10))
  return power * (range / power > 25 ? 5 : range / power > 10 ? 2 : 1)
}
function stroke(x1, y1, x2, y2, colour) {
  printf "<path d='M%.1f %.1fL%.1f %.1f' stroke='%s'/>\n", x1, y1, x2, y2, colour
}
function text(x, y, anchor, words) {
  printf "<text x='%.1f' y='%.1f' text-anchor='%s'>%s</text>\n", x, y, anchor, words
}
function axes(   step, at) {
  step = step_for(highest - lowest)
  at = floor_of(lowest / step)
  lowest = at * step
  highest = -floor_of(-highest / step) * step
  for (; at * step < highest + step / 2; at++) {
    stroke(left, y_of(at * step), right, y_of(at * step), "#dadcd8")
    text(left - 10, y_of(at * step) + 5, "end", sprintf("%g", at * step))
  }
  step = step_for(end)
  for (at = 0; at * step < end * 1.001; at++) {
    stroke(x_of(at * step), bottom, x_of(at * step), bottom + 6, "#20262e")
    text(x_of(at * step), bottom + 25, "middle", sprintf("%g", at * step))
  }
  stroke(left, bottom, right, bottom, "#20262e")
  text((left + right) / 2, bottom + 52, "middle", "time t [s]")
  text(15, 28, "start", "height y [m]")
}
function curve(line, colour,   i, x, y, x_drawn, y_drawn) {
  printf "<path stroke='%s' d='", colour
  for (i = 1; i <= count[line]; i++) {
    x = x_of(time[line, i])
    y = y_of(height[line, i])
    # Closer than half a pixel to the last point nobody sees a point.
    if (i > 1 && i < count[line] && (x - x_drawn) ^ 2 + (y - y_drawn) ^ 2 < 0.25) continue
    printf "%s%.1f %.1f", (i == 1 ? "M" : "L"), x, y
    x_drawn = x
    y_drawn = y
  }
  print "'/>"
}
END {
  if (!end) exit 1 # no rows with t and y
  if (highest == lowest) { highest += 1; lowest -= 1 }
  print "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 900 500' width='900' height='500'" \
    " font-family='sans-serif' font-size='16' fill='#20262e' stroke-linejoin='round'>"
  print "<style>path{fill:none}</style><rect width='900' height='500' fill='#fafaf7'/>"
  axes()
  print "<g stroke-width='2'>"
  split("#0072b2 #d55e00 #009e73 #6a1b74", colours, " ")
  for (i = 1; i <= lines; i++) {
    colour = name[i] == "floor" ? "#5f6b76" : colours[(i - 1) % 4 + 1]
    curve(name[i], colour)
    if (lines > 1 && i <= 5) stroke(120 + 110 * i, 23, 150 + 110 * i, 23, colour)
  }
  print "</g>"
  for (i = 1; lines > 1 && i <= lines && i <= 5; i++) text(158 + 110 * i, 28, "start", name[i])
  print "</svg>"
}
