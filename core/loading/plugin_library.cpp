#include "core/loading/plugin_library.h"

#include "core/scene/complaints.h"
#include "core/scene/suggestion.h"

#include <fmt/format.h>
#include <boost/dll/shared_library.hpp>

#include <algorithm>
#include <cstring>

namespace stylet::core {

class PluginLibrary::Handle {
public:
    std::filesystem::path file;
    boost::dll::shared_library library;
    const Descriptor* descriptor = nullptr;
};

namespace {

constexpr const char* symbol = "stylet_plugin";

/// What the dynamic linker says, without the paths and the wrapping that a reader has no use for.
std::string reason_of(const std::string& message, const std::string& file_name) {
    std::string reason = message;
    constexpr std::string_view wrapping = "dlerror system message: ";
    if (const auto begin = reason.find(wrapping); begin != std::string::npos) reason = reason.substr(begin + wrapping.size());
    if (const auto name = reason.find(file_name + ": "); name != std::string::npos)
        reason = reason.substr(name + file_name.size() + 2);
    return reason.substr(0, reason.find_first_of(")\n"));
}

void load(boost::dll::shared_library& library, const std::filesystem::path& file, const std::string& type) {
    try {
        // Now: an undefined symbol is an error here, not a crash in a tick. Local: two plugins never see each other's symbols.
        library.load(file.string(), boost::dll::load_mode::rtld_now | boost::dll::load_mode::rtld_local);
    } catch (const std::exception& error) {
        throw Error(fmt::format("cannot open plugin '{}': {}", type, reason_of(error.what(), file.filename().string())));
    }
}

std::string eigen_version(std::uint32_t version) {
    return fmt::format("{}.{}.{}", version / 10000, version / 100 % 100, version % 100);
}

bool differ(const char* a, const char* b) {
    return a == nullptr || std::strcmp(a, b) != 0;
}

/// How the stamp of a plugin differs from this program's, empty where it does not. The SDK's version goes first: it explains the
/// rest.
std::string difference(const BuildStamp& theirs) {
    constexpr BuildStamp ours = build_stamp();
    if (theirs.sdk != ours.sdk) return fmt::format("for SDK version {}, this program has {}", theirs.sdk, ours.sdk);
    if (theirs.size != ours.size) {
        return fmt::format("with a descriptor of {} bytes, this program's has {}", theirs.size, ours.size);
    }
    if (theirs.eigen != ours.eigen) {
        return fmt::format("with Eigen {}, this program with {}", eigen_version(theirs.eigen), eigen_version(ours.eigen));
    }
    if (theirs.alignment != ours.alignment) {
        return fmt::format("for an Eigen alignment of {} bytes, this program has {} (compiler flags such as -mavx change it)",
                           theirs.alignment, ours.alignment);
    }
    if (differ(theirs.compiler, ours.compiler)) {
        return fmt::format("by {}, this program by {}", theirs.compiler ? theirs.compiler : "nothing", ours.compiler);
    }
    if (differ(theirs.library, ours.library)) {
        return fmt::format("with {}, this program with {}", theirs.library ? theirs.library : "nothing", ours.library);
    }
    return "";
}

/// Every text and every table that a declaration of this kind needs is there.
bool complete(const Parameter& parameter) {
    const bool texts =
        parameter.name != nullptr && parameter.unit != nullptr && parameter.meaning != nullptr && parameter.choices != nullptr;
    if (!texts || parameter.kind != Kind::records) return texts;
    const bool table = parameter.fields != nullptr && parameter.field_count > 0;
    return table && std::all_of(parameter.fields, parameter.fields + parameter.field_count, complete);
}

void check_descriptor(const Descriptor& descriptor, const std::string& type) {
    const bool texts = descriptor.name != nullptr && descriptor.about.summary != nullptr && descriptor.about.formula != nullptr &&
                       descriptor.about.source != nullptr && descriptor.about.validity != nullptr &&
                       descriptor.create != nullptr && (descriptor.parameters != nullptr || descriptor.parameter_count == 0);
    const bool whole = texts && std::all_of(descriptor.parameters, descriptor.parameters + descriptor.parameter_count, complete);
    if (!whole) throw Error(fmt::format("plugin '{}' has a descriptor with parts left out", type));
    if (type != descriptor.name) {
        throw Error(fmt::format("the library {0}.so calls its plugin {1}, wanted '{0}': a library bears its plugin's name", type,
                                quote(descriptor.name)));
    }
}

[[noreturn]] void refuse_missing(const std::string& type, const PluginFolders& folders) {
    if (!is_plain_name(type))
        throw Error(fmt::format("found {}, wanted a plugin's name (small letters, digits and '_')", quote(type)));
    std::vector<std::string> searched;
    for (const auto& folder : folders.folders()) searched.push_back(folder.string());
    throw Error(fmt::format("found no plugin '{}' in {}{}", type, list_of(searched), suggestion(type, folders.names())));
}

}    // namespace

PluginLibrary PluginLibrary::open(const std::string& type, const PluginFolders& folders) {
    const auto file = folders.find(type);
    if (!file) refuse_missing(type, folders);
    auto handle = std::make_unique<Handle>();
    handle->file = *file;
    load(handle->library, *file, type);
    if (!handle->library.has(symbol)) throw Error(fmt::format("the library {}.so is no plugin: it exports no {}", type, symbol));
    // Only the stamp may be read until it is known that the rest means the same to both.
    const std::string differs = difference(handle->library.get<const BuildStamp>(symbol));
    if (!differs.empty()) throw Error(fmt::format("plugin '{}' was built {}: rebuild it", type, differs));
    handle->descriptor = &handle->library.get<const Descriptor>(symbol);
    check_descriptor(*handle->descriptor, type);
    return PluginLibrary(std::move(handle));
}

PluginLibrary PluginLibrary::open(const std::string& type, Role role, const PluginFolders& folders) {
    PluginLibrary library = open(type, folders);
    const Role found = library.descriptor().role;
    if (found != role) throw Error(fmt::format("'{}' is {}, wanted {}", type, with_article(found), with_article(role)));
    return library;
}

PluginLibrary::PluginLibrary(std::unique_ptr<Handle> handle) : handle_(std::move(handle)) {}
PluginLibrary::PluginLibrary(PluginLibrary&&) noexcept = default;
PluginLibrary& PluginLibrary::operator=(PluginLibrary&&) noexcept = default;
PluginLibrary::~PluginLibrary() = default;

const Descriptor& PluginLibrary::descriptor() const {
    return *handle_->descriptor;
}
const std::filesystem::path& PluginLibrary::file() const {
    return handle_->file;
}

const char* name_of(Role role) {
    switch (role) {
        case Role::tissue:
            return "tissue";
        case Role::needle:
            return "needle";
        case Role::buckling:
            return "buckling model";
        case Role::effect:
            return "effect";
        case Role::device:
            return "device";
    }
    return "plugin of an unknown role";
}

std::string with_article(Role role) {
    const std::string name = name_of(role);
    return fmt::format("{} {}", name.front() == 'e' ? "an" : "a", name);
}

}    // namespace stylet::core
