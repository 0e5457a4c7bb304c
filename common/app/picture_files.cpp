#include "app/picture_files.hpp"

#include <png.h>

#include <cstdlib>

#include "physics/text.hpp"

namespace bounce {
namespace {

#ifdef _WIN32
constexpr const char *nothing = "NUL", *to_write = "wb";
#define popen _popen
#define pclose _pclose
/// One word of a command line. No name of a file has a " in it there.
std::string quoted(const std::string& word) { return '"' + word + '"'; }
#else
constexpr const char *nothing = "/dev/null", *to_write = "w";
/// One word of a shell's command line, whatever letters it has.
std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char letter : word) {
    if (letter == '\'')
      text += "'\\''";
    else
      text += letter;
  }
  return text + "'";
}
#endif

bool is_gif(const std::string& path) {
  if (path.ends_with(".gif")) return true;
  if (path.ends_with(".mp4")) return false;
  throw BadInput("--record '" + path + "' is not allowed: it must end in .gif or .mp4");
}

}  // namespace

void write_png(const std::string& path, const Pixels& pixels) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(pixels.width);
  image.height = static_cast<png_uint_32>(pixels.height);
  image.format = PNG_FORMAT_RGB;
  OutputFile file("--screenshot", path);
  png_alloc_size_t size = 0;
  png_image_write_to_memory(&image, nullptr, &size, 0, pixels.rgb.data(), 0, nullptr);
  std::string bytes(size, '\0');
  if (!png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.rgb.data(), 0, nullptr)) {
    throw MachineFailure(std::string("--screenshot: the picture could not be packed: ") +
                         image.message);
  }
  bytes.resize(size);
  file.write(bytes);
  file.finish();
}

Recorder::Recorder(const std::string& path)
    : path_(path), is_gif_(is_gif(path)), file_("--record", path) {
  if (std::system((std::string("ffmpeg -version > ") + nothing + " 2>&1").c_str()) != 0) {
    throw MachineFailure(
        "--record needs the program ffmpeg, which is not here: install it "
        "(Debian, Ubuntu: apt-get install ffmpeg; macOS: brew install ffmpeg)");
  }
}

void Recorder::add(const Pixels& pixels) {
  if (pipe_ == nullptr) {
    const std::string size = std::to_string(pixels.width) + "x" + std::to_string(pixels.height);
    const std::string how =
        is_gif_ ? "-vf \"scale=iw*3/4:-1:flags=area,split[a][b];[a]palettegen=max_colors=64:"
                  "stats_mode=diff[p];[b][p]paletteuse=dither=none:diff_mode=rectangle\" -f gif"
                : "-c:v libx264 -pix_fmt yuv420p -crf 20 -movflags +faststart -f mp4";
    const std::string command = "ffmpeg -loglevel error -y -f rawvideo -pix_fmt rgb24 -s " + size +
                                " -r " + std::to_string(frames_per_second()) + " -i - " + how +
                                " " + quoted(file_.path_in_work());
    pipe_ = popen(command.c_str(), to_write);
    if (pipe_ == nullptr) throw MachineFailure("--record: ffmpeg could not be started");
  }
  if (std::fwrite(pixels.rgb.data(), 1, pixels.rgb.size(), pipe_) != pixels.rgb.size()) {
    throw MachineFailure("--record '" + path_ + "': ffmpeg stopped");
  }
}

void Recorder::finish() {
  std::FILE* pipe = pipe_;
  pipe_ = nullptr;
  if (pipe == nullptr || pclose(pipe) != 0) {
    throw MachineFailure("--record '" + path_ + "': ffmpeg could not write the clip");
  }
  file_.finish();
}

Recorder::~Recorder() {
  if (pipe_ != nullptr) pclose(pipe_);
}

}  // namespace bounce
