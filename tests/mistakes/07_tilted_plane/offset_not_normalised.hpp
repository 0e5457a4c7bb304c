// Half of the equation is divided.
// check: the offset is divided by the same length
// told: offset not normalised

// [plane]
/// The plane with a normal of unit length: only that makes d(p) below a distance in metres.
Plane plane() const { return {normal.normalized(), offset}; }
// [plane]
