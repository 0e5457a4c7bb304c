// cmake.exe and its like for wine: hands its words to a program of that name on the system below
// (course_cmd.sh), and waits for the answer.
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <thread>

int main(int argc, char** argv) {
  const std::filesystem::path here = std::filesystem::path(BOUNCE_REQUESTS),
                              question = here / "question", answer = here / "answer",
                              code = here / "code";
  {
    std::ofstream words(here / "writing", std::ios::binary);
    words << std::filesystem::path(argv[0]).stem().string() << '\n';
    for (int i = 1; i < argc; ++i) words << argv[i] << '\n';
  }
  std::filesystem::rename(here / "writing", question);
  while (!std::filesystem::exists(code)) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  std::ifstream said(answer, std::ios::binary);
  if (said.peek() != EOF) std::cout << said.rdbuf();
  int result = 1;
  std::ifstream(code) >> result;
  std::filesystem::remove(code);
  return result;
}
