#include "run/command_words.hpp"

#include <CLI/CLI.hpp>
#include <iostream>

#include "physics/text.hpp"
#include "run/output_file.hpp"

namespace bounce {
namespace {

void declare(CLI::App& app, Words& words, Options& options) {
  app.set_help_flag("-h,--help", "this page");
  app.add_option("--method", words.method, "how time is moved; --list names the methods")
      ->type_name("NAME");
  app.add_option("--dt", words.dt,
                 "time step (default 0.001); auto: a twentieth of the largest stable step of the "
                 "slides' loop, or less for a restitution right to 0.01")
      ->type_name("S|auto");
  app.add_option("--tolerance", words.tolerance, "error control of the method 'reference'")
      ->type_name("T");
  app.add_option("--duration", words.duration, "simulated seconds (default 10)")->type_name("S");
  app.add_option("--set", words.set, "set a parameter; may be given more than once")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  app.add_flag("--list", words.list, "show methods and parameters, with units and valid values");
  app.add_flag("--headless", options.headless, "run without a window, as fast as possible");
  app.add_option("--csv", options.csv, "write the trace; '-' is standard output (no window)")
      ->type_name("FILE|-");
  app.add_option("--sample", words.sample, "trace rows at 0, S, 2 S, ... instead of every step")
      ->type_name("S");
  app.add_option("--at", words.at, "trace rows at exactly these times")->type_name("T1,T2,...");
  app.add_option("--screenshot", options.screenshot,
                 "the picture at the end of --duration (no window)")
      ->type_name("FILE.png");
  app.add_option("--record", options.record, "a clip of --duration; needs ffmpeg (no window)")
      ->type_name("FILE.gif|FILE.mp4");
  app.add_option("--save", options.save, "save the state at the end of the run")->type_name("FILE");
  app.add_option("--load", options.load, "go on from a saved state")->type_name("FILE");
  app.add_option("--seed", words.seed, "for scenes with chance in them (default 1)")
      ->type_name("N");
  app.add_flag("--calm", options.calm, "no trail and nothing that flashes or shakes");
  app.add_flag("--from-above", options.from_above, "in space: look straight down (the key T)");
}

std::vector<std::string> names_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) names.push_back(option->get_name());
  return names;
}

}  // namespace

void answer(const std::string& option, const std::string& text) {
  std::cout << text << std::flush;
  if (!std::cout) throw MachineFailure(option + " could not be written to standard output");
}

bool read_words(int argc, const char* const* argv, const StageName& stage,
                const std::vector<StageOption>& of_stage, Words& words, Options& options) {
  CLI::App app(stage.about, stage.name);
  declare(app, words, options);
  for (const StageOption& option : of_stage) {
    const auto keep = [&options, name = option.name](const std::string& text) {
      options.of_stage[name] = text;
    };
    app.add_option_function<std::string>(option.name, keep, option.meaning)
        ->type_name(option.value);
  }
  for (int i = 1; i < argc; ++i) {  // CLI11 2.1 takes the next option for the value
    const std::string_view word = argv[i];
    if (word.substr(0, 2) == "--" && word.back() == '=') {
      throw BadInput(std::string(word) + " is not allowed: after the = there must be a value");
    }
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    answer("--help", app.help());
    return false;
  } catch (const CLI::ExtrasError& error) {
    // "The following argument was not expected: --metod"
    throw BadInput(error.what() + did_you_mean(app.remaining().front(), names_of(app)) +
                   "; --help shows the options that are allowed, such as --set mass=2");
  } catch (const CLI::ParseError& error) {
    // "--dt: 1 required S|auto missing" and the like
    throw BadInput(std::string(error.what()) +
                   ": an option takes one value; --help shows them all");
  }
  for (const char* option : {"--csv", "--screenshot", "--record", "--save", "--load"}) {
    if (app.count(option) > 0 && app[option]->as<std::string>().empty()) {
      throw BadInput(std::string(option) + " '' is not allowed: it must be the path of a file");
    }
  }
  return true;
}

}  // namespace bounce
