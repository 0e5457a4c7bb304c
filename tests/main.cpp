#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include "floating_point_traps.hpp"
#include "temporary_folder.hpp"

int main(int argc, char** argv) {
  const bounce::test::TemporaryFolder folder;
  folder.use_for_all();
  bounce::test::trap_floating_point_errors();
  return doctest::Context(argc, argv).run();
}
