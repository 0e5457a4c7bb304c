#pragma once
#include <cstdio>
#include <cstring>

namespace bounce::test {

/// A table of a lesson, by the name that the lesson's comment gives it.
struct Table {
  const char* name;
  void (*print)();
};

/// The whole of a program that prints the one table its command line names. Returns its exit code.
template <std::size_t count>
int print_table(const Table (&tables)[count], int argc, char** argv) {
  for (const Table& table : tables) {
    if (argc != 2 || std::strcmp(argv[1], table.name) != 0) continue;
    table.print();
    return 0;
  }
  std::fprintf(stderr, "usage: %s TABLE, where TABLE is one of\n", argv[0]);
  for (const Table& table : tables) std::fprintf(stderr, "  %s\n", table.name);
  return 2;
}

}  // namespace bounce::test
