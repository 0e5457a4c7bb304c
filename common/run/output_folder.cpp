#include "run/output_folder.hpp"

#include <system_error>

#include "physics/text.hpp"
#include "run/output_file.hpp"

namespace bounce {

namespace fs = std::filesystem;

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
