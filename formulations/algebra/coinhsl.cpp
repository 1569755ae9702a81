#include "formulations/algebra/coinhsl.h"

#include <dlfcn.h>
#include <link.h>

#include <cstdlib>
#include <filesystem>

namespace desmo {

namespace {

/// File names of the library: of COIN-OR's build of HSL, and of HSL's own binaries.
constexpr const char* usual_names[] = {"libcoinhsl.so", "libhsl.so"};

std::string loader_message() {
  const char* const message = ::dlerror();
  return message ? message : "no reason given";
}

/// Sets `function` to a symbol of the library; adds the symbol to `lacking` where there is none.
template <class Function>
void resolve(void* library, const char* symbol, Function*& function, std::string& lacking) {
  function = reinterpret_cast<Function*>(::dlsym(library, symbol));
  if (!function) lacking += (lacking.empty() ? "" : ", ") + std::string(symbol);
}

/// Returns the name of the library's file with links resolved, such as libcoinhsl.so.2.2.5, and the
/// version that the library reports, if any. MA27 itself reports none.
std::string version_of(void* library) {
  std::string version;
  link_map* map = nullptr;
  if (::dlinfo(library, RTLD_DI_LINKMAP, &map) == 0) {
    std::error_code error;
    const std::filesystem::path file = map->l_name, target = canonical(file, error);
    version = (error ? file : target).filename().string();
  }
  if (const auto tell =
          reinterpret_cast<void (*)(int*, int*, int*)>(::dlsym(library, "LIBHSL_version"))) {
    int major = 0, minor = 0, patch = 0;
    tell(&major, &minor, &patch);
    version += " " + version_text(major, minor, patch);
  }
  return version;
}

CoinHsl absent(const std::string& reason, bool faulty) { return {{}, {}, {reason, faulty}}; }

CoinHsl use(void* library, const std::string& name) {
  CoinHsl result;
  std::string lacking;
  resolve(library, "ma27id_", result.ma27.set_defaults, lacking);
  resolve(library, "ma27ad_", result.ma27.analyse, lacking);
  resolve(library, "ma27bd_", result.ma27.factorise, lacking);
  resolve(library, "ma27cd_", result.ma27.solve, lacking);
  if (!lacking.empty())
    return absent(
        name + " is not a library with HSL's MA27 in double precision: it has no " + lacking, true);
  const auto functional = reinterpret_cast<bool (*)()>(::dlsym(library, "LIBHSL_isfunctional"));
  if (functional && !functional())
    return absent(name + " is the stand-in for HSL's library that solves nothing", true);
  result.version = version_of(library);
  return result;
}

void* open(const char* name) { return ::dlopen(name, RTLD_NOW | RTLD_LOCAL); }

}  // namespace

CoinHsl load_coinhsl(const char* file) {
  if (file && *file) {
    if (void* const library = open(file)) return use(library, file);
    return absent(
        std::string(coinhsl_variable) + " names what cannot be loaded: " + loader_message(), true);
  }
  std::string tried;
  for (const char* name : usual_names) {
    if (void* const library = open(name)) return use(library, name);
    // Where no such file is installed, the loader's message begins with the name asked for.
    // Otherwise it begins with the file that cannot be loaded, or with the library that it lacks.
    const std::string message = loader_message();
    if (!message.starts_with(std::string(name) + ":"))
      return absent("what was found cannot be loaded: " + message, true);
    tried += (tried.empty() ? "" : " nor ") + std::string(name);
  }
  return absent("HSL's MA27 may not come with desmo: the loader finds neither " + tried + ", and " +
                    coinhsl_variable + " does not name a file that has it",
                false);
}

const CoinHsl& coinhsl() {
  static const CoinHsl loaded = load_coinhsl(std::getenv(coinhsl_variable));
  return loaded;
}

}  // namespace desmo
