// What goes wrong naively, measured (naive.hpp): a line "CASE | WHAT HAPPENS" for each row of a
// section of docs/hard_cases.md.
//
//   naive_numbers SECTION

#include "docs/tables.hpp"
#include "naive.hpp"

using namespace bounce::naive;

int main(int argc, char** argv) {
  return bounce::test::print_table({{"steps", print_steps},
                                    {"long", print_long},
                                    {"far", print_far},
                                    {"rackets", print_rackets},
                                    {"planes", print_planes},
                                    {"balls", print_balls},
                                    {"input", print_input},
                                    {"builds", print_builds}},
                                   argc, argv);
}
