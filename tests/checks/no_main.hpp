// Included ahead of a learner's file. A main() of its own compiles into a module, and then collides
// with the stage's when the stage is played: so the check says where it is.
#pragma GCC poison main
