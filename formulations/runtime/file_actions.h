#pragma once

#include <spawn.h>

namespace desmo::load {

/// What posix_spawn does with the descriptors of a program that it starts.
struct FileActions {
  FileActions() { ::posix_spawn_file_actions_init(&list); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  ~FileActions() { ::posix_spawn_file_actions_destroy(&list); }
  posix_spawn_file_actions_t list;
};

}  // namespace desmo::load
