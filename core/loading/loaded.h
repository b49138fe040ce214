#pragma once

#include "core/loading/maker.h"

namespace stylet::core {

/// One model that a scene names, loaded and made by itself, without the rest of its cast.
template <class Model>
class Loaded {
public:
    /// The model refers to the scene's setups and to the choice's parameters: both must outlive it. Throws SceneErrors where its
    /// library is refused or its constructor throws.
    Loaded(const Scene& scene, const Choice& choice, const PluginFolders& folders)
        : choice_(choice),
          maker_{.scene = scene, .folders = folders, .workers = one_thread(), .libraries = libraries_},
          model_(maker_.make<Model>(choice, nullptr)) {
        maker_.complaints.throw_if_any();
    }
    Loaded(const Loaded&) = delete;
    Loaded& operator=(const Loaded&) = delete;

    /// What `question` makes of the model; whatever that throws becomes SceneErrors.
    template <class Question>
    auto ask(Question&& question) {
        decltype(question(std::as_const(*model_))) answer{};
        maker_.guard(choice_, [&] { answer = question(std::as_const(*model_)); });
        maker_.complaints.throw_if_any();
        return answer;
    }

private:
    const Choice& choice_;
    std::vector<PluginLibrary> libraries_;
    Maker maker_;
    std::unique_ptr<Model> model_;    // goes before its library
};

}    // namespace stylet::core
