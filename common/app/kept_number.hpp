#pragma once
#include <filesystem>
#include <string>

namespace bounce {

/// A number that is kept from one run to the next, such as a best score: in the user's data folder,
/// or in what a browser keeps for a page. 0 where there is none; where none can be kept, nothing
/// is.
int kept_number(const std::string& name);
/// That folder; empty where there is none. (Not in a page.)
std::filesystem::path kept_folder();
void keep_number(const std::string& name, int number);

}  // namespace bounce
