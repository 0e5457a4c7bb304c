// The first error is in a file of the course.
// says: the checks ask for something that they do not find
// says: FreeFall
// says: must stay as they are
// change: s/struct FreeFall /struct FallingBall /
