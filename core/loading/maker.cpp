#include "core/loading/maker.h"

#include "core/scene/value_tree.h"

namespace stylet::core {

const Descriptor& Maker::descriptor(const std::string& type, Role role) {
    for (const PluginLibrary& library : libraries) {
        const Descriptor& open = library.descriptor();
        if (open.role == role && open.name == type) return open;
    }
    libraries.push_back(PluginLibrary::open(type, role, folders));
    return libraries.back().descriptor();
}

void Maker::complain(const Choice& choice, const Error& error) {
    if (error.key().empty()) {
        complaints.add(choice.place, choice.path, error.what());
        return;
    }
    const std::string own = join(choice.within, error.key());
    for (const std::string& path : {own, join(choice.path, error.key()), error.key()}) {
        if (const auto found = scene.places.find(path); found != scene.places.end()) {
            complaints.add(found->second, path, error.what());
            return;
        }
    }
    complaints.add(choice.place, own, error.what());
}

}    // namespace stylet::core
