#pragma once

// A shared library that a program loads when it first needs it, so that other runs start faster.
//
// Example:
//   const geom::LoadedLibrary math("libm.so.6", "libc6");
//   double (*const cosine)(double) = math.function("cos");
//   assert(cosine(0) == 1);

namespace geom {

// Stays loaded until the process ends. Threads may load the same library at once.
class LoadedLibrary {
 public:
  // A function of the library; it takes the type of the pointer that it initialises, unchecked.
  class Function {
   public:
    explicit Function(void* address) : address_(address) {}
    template <class F>
    operator F*() const {
      return reinterpret_cast<F*>(address_);
    }

   private:
    void* address_;
  };

  // `file` is a name such as "libm.so.6", which the system looks for where its libraries are;
  // `package` is Debian's package that has it, for the message. Throws std::runtime_error if the
  // library cannot be loaded, and std::bad_alloc if memory is short.
  LoadedLibrary(const char* file, const char* package);

  // Throws std::runtime_error if the library has no such function.
  Function function(const char* name) const;

  // A function of a library that this one uses, as this one finds it. Null if there is none.
  Function used_function(const char* name) const;

 private:
  const char* file_;
  void* handle_;
};

// The function of this name, with the type that its header declares.
#define SKYWAY_FUNCTION(library, name) \
  static_cast<decltype(&name)>((library).function(#name))  // NOLINT: a name and its text

// The same as a member of a struct, behind its member `library`, which it is loaded from.
#define SKYWAY_LOADED(member, name) \
  decltype(&name) member = library.function(#name)  // NOLINT: a name and its text

}  // namespace geom
