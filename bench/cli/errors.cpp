#include "bench/cli/errors.h"

#include <cerrno>
#include <cstdio>
#include <new>

#include "cases/io/new_files.h"
#include "cases/io/text_file.h"

namespace desmo::cli {
namespace {

int complain(const char* message, int code) {
  std::fprintf(stderr, "desmo: %s\n", message);
  return code;
}

}  // namespace

int report_current_exception() noexcept {
  try {
    throw;
  } catch (const OutputError& error) {
    // Nobody waits for a message when the reader of a pipe is gone.
    return error.code() == EPIPE ? output_closed : complain(error.what(), not_completed);
  } catch (const CommandError& error) {
    return complain(error.what(), error.code());
  } catch (const UnreadableFile& error) {
    return complain(error.what(), unreadable_input);
  } catch (const InputError& error) {
    return complain(error.what(), bad_input);
  } catch (const std::invalid_argument& error) {
    return complain(error.what(), bad_input);
  } catch (const std::bad_alloc&) {
    return complain("out of memory; choose a smaller mechanism", internal_error);
  } catch (const std::exception& error) {
    return complain(error.what(), internal_error);
  } catch (...) {
    return complain("an error of unknown kind", internal_error);
  }
}

}  // namespace desmo::cli
