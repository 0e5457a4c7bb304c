// The normal is a member, and normalize() would change it.
// stage: 07_tilted_plane
// says: mine.hpp:
// says: A member may not be changed in a function that is marked const

// [plane]
Plane plane() const {
  const double length = normal.norm();
  normal.normalize();
  return {normal, offset / length};
}
// [plane]
