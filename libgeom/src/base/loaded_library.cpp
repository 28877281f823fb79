#include "geom/base/loaded_library.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cerrno>
#include <new>
#include <stdexcept>

namespace geom {

LoadedLibrary::LoadedLibrary(const char* file, const char* package) : file_(file) {
  errno = 0;
  handle_ = dlopen(file, RTLD_LAZY | RTLD_LOCAL);
  if (handle_) return;
  if (errno == ENOMEM) throw std::bad_alloc();
  throw std::runtime_error(
      fmt::format("cannot load {} of the package {}: {}", file, package, dlerror()));
}

LoadedLibrary::Function LoadedLibrary::function(const char* name) const {
  if (void* const address = dlsym(handle_, name)) return Function(address);
  throw std::runtime_error(fmt::format("{} has no {}: it is of another version", file_, name));
}

// The system looks at the program and what it was linked with first.
LoadedLibrary::Function LoadedLibrary::used_function(const char* name) const {
  void* const of_program = dlsym(RTLD_DEFAULT, name);
  return Function(of_program ? of_program : dlsym(handle_, name));
}

}  // namespace geom
