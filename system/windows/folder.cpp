#include "system/folder.hpp"

#include "system/windows/error.hpp"
#include "system/windows/links.hpp"
#include "system/windows/wide.hpp"

#include <algorithm>
#include <memory>
#include <windows.h>

namespace axisc::system {
namespace {

FileKind kind_of(WIN32_FIND_DATAW const& facts) {
  if (is_link(facts.dwFileAttributes, facts.dwReserved0)) return FileKind::link;
  return (facts.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0 ? FileKind::folder : FileKind::regular;
}

struct FindCloser {
  void operator()(HANDLE search) const {
    if (search != INVALID_HANDLE_VALUE) ::FindClose(search);
  }
};

}  // namespace

Result<std::vector<FolderEntry>> entries_of(std::string const& folder) {
  auto const pattern = wide_path(name_in(folder.empty() ? "." : folder, "*"));
  WIN32_FIND_DATAW facts{};
  std::unique_ptr<void, FindCloser> const search(::FindFirstFileExW(
      pattern.c_str(), FindExInfoBasic, &facts, FindExSearchNameMatch, nullptr, FIND_FIRST_EX_LARGE_FETCH));
  if (search.get() == INVALID_HANDLE_VALUE) return last_error();
  std::vector<FolderEntry> entries;
  do {
    std::string name = narrow(facts.cFileName);
    if (name != "." && name != "..") entries.push_back({std::move(name), kind_of(facts)});
  } while (::FindNextFileW(search.get(), &facts) != 0);
  if (::GetLastError() != ERROR_NO_MORE_FILES) return last_error();
  std::sort(entries.begin(), entries.end(),
            [](FolderEntry const& left, FolderEntry const& right) { return left.name < right.name; });
  return entries;
}

}  // namespace axisc::system
