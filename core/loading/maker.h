// Makes a scene's objects from its plugins' libraries.
#pragma once

#include "core/loading/plugin_library.h"
#include "core/scene/complaints.h"
#include "core/scene/scene.h"

#include <memory>
#include <vector>

namespace stylet::core {

/// Makes the objects of a scene, and gathers what goes wrong with any of them.
struct Maker {
    const Scene& scene;
    const PluginFolders& folders;
    Workers& workers;
    std::vector<PluginLibrary>& libraries;    // opened here; whatever was made must go before them
    Complaints complaints{};

    /// A library is opened once, however many objects come from it.
    const Descriptor& descriptor(const std::string& type, Role role);

    /// A constructor names its own parameter, a common key of its role, or a whole path.
    void complain(const Choice& choice, const Error& error);

    /// Runs what calls a plugin, and turns whatever that throws into a complaint. Nothing of a plugin's own may get out of here:
    /// its library is closed before it would be caught.
    template <class Work>
    bool guard(const Choice& choice, Work&& work) {
        try {
            work();
            return true;
        } catch (const Error& error) {
            complain(choice, error);
        } catch (const std::exception& error) {
            complain(choice, Error("the plugin '" + choice.type + "' failed: " + error.what()));
        } catch (...) {
            complain(choice, Error("the plugin '" + choice.type + "' failed with something that is no exception"));
        }
        return false;
    }

    template <class Model>
    std::unique_ptr<Model> make(const Choice& choice, const BucklingModel* buckling) {
        std::unique_ptr<Model> model;
        guard(choice, [&] {
            const Descriptor& plugin = descriptor(choice.type, Model::role);
            const Setup setup{.parameters = choice.parameters,
                              .tissue = scene.tissue_setup ? &*scene.tissue_setup : nullptr,
                              .needle = scene.needle_setup ? &*scene.needle_setup : nullptr,
                              .buckling = buckling,
                              .dt = scene.run.dt(),
                              .workers = workers};
            model.reset(static_cast<Model*>(plugin.create(setup)));
            if (!model) throw Error("the plugin '" + choice.type + "' made nothing");
        });
        return model;
    }
};

}    // namespace stylet::core
