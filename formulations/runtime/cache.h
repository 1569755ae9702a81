#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "formulations/runtime/descriptor.h"

namespace desmo::load {

/// The user's folder of generated and compiled code: desmo/kernels in XDG_CACHE_HOME, by default in
/// ~/.cache. Only the user may read or write it (mode 0700, finished files 0600). Every finished
/// file ends in a seal, a digest of its name and content. Several processes may use the folder at
/// once, and it may be emptied at any time. File names consist of letters, digits and dots.
class Cache {
 public:
  /// Opens the folder; creates it if it does not exist. Throws Unavailable, naming the folder, when
  /// - the folder or its parent belongs to another user, is a link or can be written to by others,
  /// - others have any permission on the folder,
  /// - it cannot be created or opened.
  static Cache open();

  const std::filesystem::path& folder() const { return folder_; }
  int descriptor() const { return descriptor_.number(); }  ///< of the folder, while this lives

  /// Returns the content written under this name; nullopt when there is none. A file that was
  /// damaged or renamed does not count, nor does a link, nor one that others own or may open.
  std::optional<std::string> read(const std::string& name) const;

  /// Writes a file atomically, replacing any file of that name. Before that, removes the oldest
  /// finished files beyond 255, and unfinished ones that are older than an hour. Throws Unavailable
  /// when the file cannot be written.
  void write(const std::string& name, std::string_view content) const;

  /// Removes a file if it exists.
  void remove(const std::string& name) const;

  /// Calls make(name), which lets another program write a file of that unique name into the folder;
  /// returns the file's content and removes it. Throws what `make` throws, and Unavailable when
  /// there is no such regular file afterwards, or it has more than 256 MiB.
  std::string content_made_by(const std::function<void(const std::string& name)>& make) const;

 private:
  Cache() = default;
  void remove_old() const;

  std::filesystem::path folder_;
  Descriptor descriptor_;
};

}  // namespace desmo::load
