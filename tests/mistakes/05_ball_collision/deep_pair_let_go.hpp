// One centre inside the other ball.
// check: the overlap is r1 + r2 - d
// told: none of the known mistakes
// seen: right while they approach and while they part

// [meeting]
inline Meeting meet(const Ball& ball1, const Ball& ball2) {
  const Eigen::Vector3d between = ball1.position - ball2.position;
  const double d = between.norm();
  Meeting meeting{ball1.radius + ball2.radius - d};
  if (d < ball1.radius) meeting.overlap = 0;
  if (!(meeting.overlap > 0)) return meeting;
  // Where the centres coincide there is no direction: ball 1, the one with the lower number, goes
  // up. (Below 1e-100 m the squares in d underflow, and the direction would be noise.)
  meeting.e12 = Eigen::Vector3d::UnitY();
  if (d > 1e-100) meeting.e12 = between / d;
  meeting.separation_speed = dot(ball1.velocity - ball2.velocity, meeting.e12);
  return meeting;
}
// [meeting]
