#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "formulations/runtime/descriptor.h"

namespace desmo::load {

/// The user's own folder of generated and compiled code, desmo/kernels in XDG_CACHE_HOME or else
/// ~/.cache. It and its files belong to the user, and nobody else may so much as read them (mode
/// 0700, 0600). Every file ends in a seal, a digest of its name and content. Several processes may
/// use the folder at once, and it may be emptied at any time. Names are ours: letters, digits,
/// dots.
class Cache {
 public:
  /// Makes the folder where there is none. Throws Unavailable, naming the folder, when it is not
  /// the user's own, others could write to it or to the folder around it, or either is a link.
  static Cache open();

  const std::filesystem::path& folder() const { return folder_; }
  int descriptor() const { return descriptor_.number(); }

  /// What was written under this name; none when there is no such file or it is not as it was
  /// written: damaged, renamed, a link, of another owner, open to others.
  std::optional<std::string> read(const std::string& name) const;

  /// Writes a file: whole or not at all, in the place of what had its name. Of many files the
  /// oldest go. Throws Unavailable.
  void write(const std::string& name, std::string_view content) const;

  void remove(const std::string& name) const;

  /// What another program writes into the folder: make(name) has it do so under a name that nobody
  /// else uses. Throws Unavailable when there is nothing under it then, and what `make` throws.
  std::string content_made_by(const std::function<void(const std::string& name)>& make) const;

 private:
  Cache() = default;
  void remove_old() const;

  std::filesystem::path folder_;
  Descriptor descriptor_;
};

}  // namespace desmo::load
