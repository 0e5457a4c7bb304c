// x and z one by one. (On an upright racket it even has corners.)
// check: is the ball on the disc? Beside it the nearest point is on the rim
// told: square racket

// [nearest]
NearestPoint nearest(const Disc& racket, const Eigen::Vector3d& ball) const {
  const Eigen::Vector3d outwards = racket.outwards(ball);  // along the racket, from its centre
  const double lateral = outwards.norm();
  if (std::abs(outwards.x()) < racket.radius &&
      std::abs(outwards.z()) < racket.radius) {  // over the disc: the plane of stage 7
    return {racket.centre + outwards, side * racket.normal, side * racket.height(ball)};
  }
  // Beside it: the nearest point is on the rim, and the push goes from there to the ball.
  const Eigen::Vector3d rim = racket.centre + outwards * (racket.radius / lateral);
  const double distance = (ball - rim).norm();
  if (distance == 0) return {rim, side * racket.normal, 0};
  return {rim, (ball - rim) / distance, distance};
}
// [nearest]
