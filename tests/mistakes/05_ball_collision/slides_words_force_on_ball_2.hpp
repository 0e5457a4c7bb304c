// The slides' words: + k (2r - d) e12 acts on ball 2.
// check: the force on ball 1: spring and damper along e12
// told: the force on ball 2

// [pair]
/// The force on ball 1 [N]; the force on ball 2 is the opposite one. The slides point e12 from ball
/// 2 to ball 1, as here, and then call k (2r - d) e12 the force on ball 2: it is the one on ball 1.
inline Eigen::Vector3d pair_force(const Ball& ball1, const Ball& ball2,
                                  const SpringDamper& contact) {
  const Meeting meeting = meet(ball1, ball2);
  return -contact.force(meeting.overlap, meeting.separation_speed) * meeting.e12;
}
// [pair]
