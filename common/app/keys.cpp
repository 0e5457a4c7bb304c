#include "app/keys.hpp"

namespace bounce {

std::vector<Key> keys_of(const Demo& demo) {
  std::vector<Key> keys{{"P, Space", "pause, play"},
                        {".  or Right", "one step forward"},
                        {",  or Left", "one step back"},
                        {"R", "restart"},
                        {"O", "slow motion (1/10)"},
                        {"L", "contact lens: a contact lasts a second"},
                        {"E", "speed against error, now: click a dot to choose it"}};
  if (demo.in_space) keys.push_back({"T", "from above, from the side"});
  if (demo.survey.draw) {
    keys.push_back({"B", "all values of a slider: click to go there"});
    keys.push_back({"N", "Poincare section: each touch is a point"});
  }
  keys.push_back({"mouse", "drag the ball, and throw it"});
  keys.push_back({"F1", "this page"});
  return keys;
}

bool press(char key, const Demo& demo, Playback& playback, View& view, Controls& controls) {
  switch (key) {
    case ' ':
      if (is_game(demo)) return false;
      [[fallthrough]];
    case 'p':
      playback.paused = !playback.paused;
      return true;
    case '.':
      playback.step_forward();
      return true;
    case ',':
      playback.step_back();
      return true;
    case 'r':
      playback.restart();
      return true;
    case 'o':
      playback.rate = playback.rate < 1 ? 1 : 0.1;
      return true;
    case 'l':
      playback.contact_lens = !playback.contact_lens;
      return true;
    case 't':
      view.from_above = demo.in_space && !view.from_above;
      return demo.in_space;
    case 'e':
      view.chart = !view.chart;
      return true;
    case 'b':
      view.survey = demo.survey.draw && !view.survey;
      return static_cast<bool>(demo.survey.draw);
    case 'n':  // by night; or the section of the survey
      view.dark = is_game(demo) && !view.dark;
      view.section = demo.survey.section && !view.section;
      return is_game(demo) || demo.survey.section;
    case 'm':
      view.muted = !view.muted;
      return true;
    case 'g':
      controls.next = is_game(demo);
      return controls.next;
    case '-':
      controls.less = true;
      return true;
    case '+':
      controls.more = true;
      return true;
    case '?':
      view.help = !view.help;
      return true;
    default:
      return false;
  }
}

}  // namespace bounce
