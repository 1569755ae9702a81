#pragma once

#include <spawn.h>

namespace desmo::load {

/// An owned list of descriptor actions for posix_spawn.
struct FileActions {
  FileActions() { ::posix_spawn_file_actions_init(&list); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  ~FileActions() { ::posix_spawn_file_actions_destroy(&list); }
  posix_spawn_file_actions_t list;
};

}  // namespace desmo::load
