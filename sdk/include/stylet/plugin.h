// The border between core and a plugin's library: one exported descriptor, checked before anything else is called.
//
//     STYLET_PLUGIN(Friction, "friction", parameters,
//                   .summary = "Dry friction along the shaft", .formula = "F = f l", .source = "Okamura et al. 2004",
//                   .validity = "Dry sliding at any speed; leaves out damping")
//
// A plugin is one class that derives from a role (TissueModel, NeedleModel, BucklingModel, ForceModel, HapticDevice) and is made
// from a const Setup&; its constructor throws Error where a value makes no sense. Its library bears its name: friction.so.
#pragma once

#include <stylet/setup.h>

#include <cstdint>
#include <iterator>
#include <memory>
#include <span>

namespace stylet {

enum class Role : std::uint32_t { tissue, needle, buckling, effect, device };

/// What every plugin object is, so that core can own one without knowing more.
class Object {
public:
    Object() = default;
    Object(const Object&) = delete;
    Object& operator=(const Object&) = delete;
    virtual ~Object() = default;
};

/// Raised by one whenever a library built before could no longer be called.
inline constexpr std::uint32_t sdk_version = 4;

/// What a library was built with. It comes first, holds only integers and C strings, and never changes its layout.
struct BuildStamp {
    std::uint32_t size;         // of the whole Descriptor [bytes]
    std::uint32_t sdk;          // sdk_version
    std::uint32_t eigen;        // major · 10000 + minor · 100 + patch
    std::uint32_t alignment;    // Eigen's largest static alignment [bytes]
    const char* compiler;       // name and major version
    const char* library;        // C++ standard library and its string ABI
};

/// What a plugin says of itself, in lists, pages and editors. Plain text that lives as long as the library; line breaks are kept
/// in `formula` alone.
struct About {
    const char* summary;     // one line
    const char* formula;     // what it computes
    const char* source;      // author, year, equation, and where we deviate from it
    const char* validity;    // where it may be trusted, and what it leaves out
};

struct Descriptor {
    BuildStamp stamp;
    Role role;
    std::uint32_t parameter_count;
    const char* name;    // the `type:` of a scene and the library's file name
    About about;
    const Parameter* parameters;
    Object* (*create)(const Setup&);
};

#define STYLET_TEXT_(x) #x
#define STYLET_TEXT(x) STYLET_TEXT_(x)
#if defined(__clang__)
#define STYLET_COMPILER "clang " STYLET_TEXT(__clang_major__)
#elif defined(__GNUC__)
#define STYLET_COMPILER "g++ " STYLET_TEXT(__GNUC__)
#else
#define STYLET_COMPILER "another compiler"
#endif
#if defined(_GLIBCXX_USE_CXX11_ABI)
#define STYLET_LIBRARY "libstdc++, string ABI " STYLET_TEXT(_GLIBCXX_USE_CXX11_ABI)
#else
#define STYLET_LIBRARY "another standard library"
#endif

/// The stamp of the translation unit that calls it: internal linkage keeps each library's own.
[[nodiscard]] static constexpr BuildStamp build_stamp() {
    return {sizeof(Descriptor),
            sdk_version,
            EIGEN_WORLD_VERSION * 10000 + EIGEN_MAJOR_VERSION * 100 + EIGEN_MINOR_VERSION,
            EIGEN_MAX_STATIC_ALIGN_BYTES,
            STYLET_COMPILER,
            STYLET_LIBRARY};
}

template <class Plugin>
Object* create_plugin(const Setup& setup) {
    return std::make_unique<Plugin>(setup).release();
}

}    // namespace stylet

/// Exports `Class` (its role is the one it derives from). `parameters_` is an array of Parameter or `no_parameters`; what follows
/// are the fields of About.
#define STYLET_PLUGIN(Class, name_, parameters_, ...)                                         \
    extern "C" __attribute__((visibility("default"))) const stylet::Descriptor stylet_plugin; \
    const stylet::Descriptor stylet_plugin = {.stamp = stylet::build_stamp(),                 \
                                              .role = Class::role,                            \
                                              .parameter_count = std::size(parameters_),      \
                                              .name = name_,                                  \
                                              .about = {__VA_ARGS__},                         \
                                              .parameters = std::data(parameters_),           \
                                              .create = stylet::create_plugin<Class>};
