#include "run/output_file.hpp"

#include <cerrno>
#include <cstring>
#include <system_error>

#include "physics/text.hpp"

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#include <process.h>
#else
#include <unistd.h>
#endif

namespace bounce {

namespace fs = std::filesystem;

/// Where an output stands until it is complete.
static std::string part_path(const std::string& path) {
#ifdef _WIN32
  const int process = _getpid();
#else
  const int process = getpid();
#endif
  return path + "." + std::to_string(process) + ".part";
}

OutputFile::OutputFile(std::string option, const std::string& path)
    : option_(std::move(option)), path_(path), part_(path) {
  if (path == "-") {
#ifdef _WIN32
    _setmode(_fileno(stdout), _O_BINARY);  // lines end in \n, as they do in a file
#endif
    file_ = stdout;
    return;
  }
  std::error_code error;
  if (const fs::path real = fs::canonical(path_of(path), error); !error) path_ = name_of(real);
  const fs::file_status target = fs::status(path_of(path_), error);
  if (path.empty() || fs::is_directory(target)) {
    throw BadInput(option_ + " '" + path + "' is not allowed: it must be the path of a file");
  }
  const bool direct = fs::exists(target) && !fs::is_regular_file(target);
  part_ = direct ? path_ : part_path(path_);
  // A file that is there must be one that may be changed, though it is replaced in the end.
  std::FILE* old = direct || !fs::exists(target) ? nullptr : std::fopen(path_.c_str(), "ab");
  const bool refused = fs::exists(target) && !direct && old == nullptr;
  if (old != nullptr) std::fclose(old);
  file_ = refused ? nullptr : std::fopen(part_.c_str(), "wb");
  if (file_ == nullptr) {
    throw BadInput(option_ + " '" + path + "' cannot be written (" + std::strerror(errno) +
                   "): it must be a file in a folder that exists and that you may write to");
  }
}

void OutputFile::check(const std::string& option, const std::string& path) {
  std::error_code error;
  const fs::file_status target = fs::status(path_of(path), error);
  if (path == "-" || fs::is_character_file(target) || fs::is_fifo(target)) return;
  OutputFile(option, path);
}

OutputFile::~OutputFile() {
  if (file_ == nullptr || file_ == stdout) return;
  std::fclose(file_);
  if (part_ != path_) std::remove(part_.c_str());
}

void OutputFile::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) fail();
}

void OutputFile::finish() {
  if (std::fflush(file_) != 0) fail();
  if (file_ == stdout) return;
  std::FILE* file = file_;
  file_ = nullptr;
  if (std::fclose(file) != 0) fail();
  if (part_ == path_) return;
  std::error_code error;
  const fs::path part = path_of(part_), target = path_of(path_);
  const fs::perms old_permissions = fs::status(target, error).permissions();
  if (!error && fs::exists(target)) fs::permissions(part, old_permissions, error);
  fs::rename(part, target, error);
  if (error) fail();
}

void OutputFile::fail() const {
  throw MachineFailure(option_ + " '" + path_ + "' could not be written: " + std::strerror(errno));
}

OutputFolder::OutputFolder(const std::string& option, const std::string& path) : option_(option) {
  std::error_code error;
  path_ = fs::weakly_canonical(fs::absolute(path_of(path), error), error);
  if (!path_.has_filename()) path_ = path_.parent_path();  // "name/"
  const bool free = !fs::exists(path_) || (fs::is_directory(path_) && fs::is_empty(path_, error));
  if (path.empty() || error || !free) {
    throw BadInput(option + " '" + path +
                   "' is not allowed: it must be a folder that does not exist yet, or is empty");
  }
  part_ = path_of(part_path(name_of(path_)));
  if (!fs::create_directory(part_, error) || error) {
    throw BadInput(option + " '" + path + "' cannot be written (" + error.message() +
                   "): it must be in a folder that exists and that you may write to");
  }
}

OutputFolder::~OutputFolder() {
  std::error_code error;
  if (!finished_) fs::remove_all(part_, error);
}

void OutputFolder::finish() {
  std::error_code error;
  fs::rename(part_, path_, error);
  if (error) {
    throw MachineFailure(option_ + " '" + name_of(path_) +
                         "' could not be written: " + error.message());
  }
  finished_ = true;
}

}  // namespace bounce
