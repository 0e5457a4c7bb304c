// 0 / 0, straight above the centre.
// check: over the disc the nearest point is straight below the ball
// told: none of the known mistakes
// seen: wrong straight above the centre; not a number
// advice: the length of `outwards` is 0 there, and 0 / 0 is no direction

// [nearest]
NearestPoint nearest(const Disc& racket, const Eigen::Vector3d& ball) const {
  const Eigen::Vector3d outwards = racket.outwards(ball);  // along the racket, from its centre
  const double lateral = outwards.norm();
  if (lateral < racket.radius) {  // over the disc: the plane of stage 7
    return {racket.centre + outwards / lateral * lateral, side * racket.normal,
            side * racket.height(ball)};
  }
  // Beside it: the nearest point is on the rim, and the push goes from there to the ball.
  const Eigen::Vector3d rim = racket.centre + outwards * (racket.radius / lateral);
  const double distance = (ball - rim).norm();
  if (distance == 0) return {rim, side * racket.normal, 0};
  if (through && side * racket.height(ball) < 0) return beyond_rim(racket, rim, ball);
  return {rim, (ball - rim) / distance, distance};
}
// [nearest]
