#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include "floating_point_traps.hpp"

int main(int argc, char** argv) {
  bounce::test::trap_floating_point_errors();
  return doctest::Context(argc, argv).run();
}
