// 0 / 0, exactly on the rim.
// check: a ball exactly on the rim, or exactly a radius out
// told: none of the known mistakes
// seen: right in 20 of 40 cases at the rim; not a number
// advice: the distance is 0 there, and 0 / 0 is no direction

// [nearest]
NearestPoint nearest(const Disc& racket, const Eigen::Vector3d& ball) const {
  const Eigen::Vector3d outwards = racket.outwards(ball);  // along the racket, from its centre
  const double lateral = outwards.norm();
  if (lateral < racket.radius) {  // over the disc: the plane of stage 7
    return {racket.centre + outwards, side * racket.normal, side * racket.height(ball)};
  }
  // Beside it: the nearest point is on the rim, and the push goes from there to the ball.
  const Eigen::Vector3d rim = racket.centre + outwards * (racket.radius / lateral);
  const double distance = (ball - rim).norm();
  if (through && side * racket.height(ball) < 0) return beyond_rim(racket, rim, ball);
  return {rim, (ball - rim) / distance, distance};
}
// [nearest]
