#include "apps/study/neighbours.h"

#include "apps/study/fineness.h"
#include "core/loading/cast.h"
#include "core/loading/maker.h"
#include "core/scene/common_keys.h"
#include "core/scene/value_tree.h"

#include <stylet/buckling_model.h>
#include <stylet/needle_model.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <span>

namespace stylet::study {
namespace {

using core::Choice;
using core::Override;
using core::PluginFolders;
using core::PluginLibrary;
using core::Scene;
using std::optional;

/// A place in a scene where one word names a model.
struct Slot {
    const char* section;    // needle.buckling
    Role role;
    optional<Choice> Scene::*choice;
};
constexpr Slot tissue_slot{"tissue", Role::tissue, &Scene::tissue};
constexpr Slot needle_slot{"needle", Role::needle, &Scene::needle};
constexpr Slot buckling_slot{"needle.buckling", Role::buckling, &Scene::buckling};

std::span<const Parameter> parameters_of(const Descriptor& plugin) {
    return {plugin.parameters, plugin.parameter_count};
}

/// Those of the role that can be named without another word. A library that is refused is none.
std::vector<std::string> plain_plugins(Role role, const PluginFolders& folders) {
    std::vector<std::string> plain;
    for (const std::string& name : folders.names()) {
        try {
            const PluginLibrary library = PluginLibrary::open(name, role, folders);
            const auto asks = [](const Parameter& parameter) { return parameter.need == Need::required; };
            if (std::ranges::none_of(parameters_of(library.descriptor()), asks)) plain.push_back(name);
        } catch (const Error&) {
            continue;
        }
    }
    return plain;
}

/// The scene's own first. Empty where it names none.
std::vector<std::string> models_for(const Slot& slot, const Scene& scene, const PluginFolders& folders) {
    const optional<Choice>& own = scene.*slot.choice;
    if (!own) return {};
    std::vector<std::string> models{own->type};
    const auto add = [&](const std::vector<std::string>& more) {
        for (const std::string& model : more) {
            if (std::ranges::find(models, model) == models.end()) models.push_back(model);
        }
    };
    add(own->alternatives);
    add(plain_plugins(slot.role, folders));
    return models;
}

// Nobody typed the changes that make neighbours: errors say so, and reasons leave it out.
constexpr const char* ours = "neighbour";

Override changed(const std::string& key, const std::string& value) {
    return {.key = key, .value = value, .given = ours};
}

std::string reason(const core::SceneErrors& errors) {
    const std::string message = errors.messages().front(), before = std::string(ours) + ": ";
    return message.starts_with(before) ? message.substr(before.size()) : message;
}

std::vector<Override> naming(const Slot& slot, const std::string& model, const Scene& scene) {
    const optional<Choice>& own = scene.*slot.choice;
    if (!own || model.empty() || own->type == model) return {};
    return {changed(fmt::format("{}.type", slot.section), model)};
}

/// A buckling model that only notes whether it is asked.
class Listening final : public BucklingModel {
public:
    double critical_load(const Column& column) const override {
        asked_ = true;
        return column.bending_stiffness / (column.free_length * column.free_length);
    }
    [[nodiscard]] bool asked() const { return asked_; }

private:
    mutable bool asked_ = false;
};

class Search {
public:
    explicit Search(const ChangedScene& base) : base_(base), scene_(base.read()) {}

    Neighbours all() {
        const core::Cast cast(scene_, base_.folders);    // throws where the scene itself is refused
        combine();
        add_steps();
        return std::move(found_);
    }

private:
    /// Models of the slot that this scene's other models go together with.
    std::vector<std::string> sound(const Slot& slot) {
        std::vector<std::string> models;
        for (const std::string& model : models_for(slot, scene_, base_.folders)) {
            try {
                const Scene scene = base_.read(naming(slot, model, scene_));
                const core::Cast cast(scene, base_.folders);
                models.push_back(model);
            } catch (const core::SceneErrors& errors) {
                found_.left_out.push_back({model, reason(errors)});
            }
        }
        if (models.empty()) models.emplace_back();    // the scene has no such part
        return models;
    }

    void combine() {
        const std::vector<std::string> tissues = sound(tissue_slot), needles = sound(needle_slot);
        const std::vector<std::string> loads = sound(buckling_slot);
        for (const std::string& tissue : tissues) {
            for (const std::string& needle : needles) {
                const bool asks =
                    !loads.front().empty() && asks_for_load(base_.read(naming(needle_slot, needle, scene_)), base_.folders);
                for (const std::string& load : loads) {
                    if (asks || load == loads.front()) add({tissue, needle, load}, asks);
                }
            }
        }
    }

    struct Models {
        std::string tissue, needle, load;
    };

    void add(const Models& models, bool asks) {
        Neighbour neighbour;
        const auto take = [&](const Slot& slot, const std::string& model, bool named) {
            if (named && !model.empty()) neighbour.name += (neighbour.name.empty() ? "" : ", ") + model;
            for (Override& change : naming(slot, model, scene_)) neighbour.changes.push_back(std::move(change));
        };
        take(tissue_slot, models.tissue, true);
        take(needle_slot, models.needle, true);
        take(buckling_slot, models.load, asks);
        add(std::move(neighbour), found_.models);
    }

    /// Where a scene is left.
    void add(Neighbour neighbour, std::vector<Neighbour>& to) {
        try {
            (void)base_.read(neighbour.changes);
            to.push_back(std::move(neighbour));
        } catch (const core::SceneErrors& errors) {
            found_.left_out.push_back({neighbour.name, reason(errors)});
        }
    }

    void add_steps();

    const ChangedScene& base_;
    const Scene scene_;
    Neighbours found_;
};

/// A parameter of the scene, and where it stands.
struct Standing {
    std::string key;
    const Parameter& parameter;
    const Parameters& given;
};

/// Visits each parameter of the scene's models, but for a buckling model that is not asked.
template <class Visit>
void visit_parameters(const Scene& scene, const PluginFolders& folders, Visit&& visit) {
    for (const Slot& slot : {tissue_slot, needle_slot, buckling_slot}) {
        const optional<Choice>& choice = scene.*slot.choice;
        if (!choice || (slot.role == Role::buckling && !asks_for_load(scene, folders))) continue;
        const PluginLibrary library = PluginLibrary::open(choice->type, slot.role, folders);
        for (const Parameter& parameter : parameters_of(library.descriptor()))
            visit(Standing{core::join(choice->within, parameter.name), parameter, choice->parameters});
    }
}

/// The same of those that may come in steps, core's own among them.
template <class Visit>
void visit_steps(const Scene& scene, const PluginFolders& folders, Visit&& visit) {
    visit_parameters(scene, folders, visit);
    Parameters common;
    common.set("rate", scene.run.rate);
    if (scene.tissue && scene.needle) common.set("contact_spacing", scene.contact_spacing);
    for (const Parameter& parameter : core::run_keys) visit(Standing{core::join("run", parameter.name), parameter, common});
    for (const Parameter& parameter : core::coupling_keys)
        visit(Standing{core::join("coupling", parameter.name), parameter, common});
}

void Search::add_steps() {
    visit_steps(scene_, base_.folders, [this](const Standing& standing) {
        for (const Step step : {Step::coarser, Step::finer}) {
            const auto value = one_step(standing.parameter, standing.given, step);
            if (value) add({fmt::format("{}={}", standing.key, *value), {changed(standing.key, *value)}}, found_.steps);
        }
    });
}

Override without(const std::string& key) {
    return {.key = key, .value = "", .given = "without " + key, .removes = true};
}

}    // namespace

Scene ChangedScene::read(const std::vector<Override>& more) const {
    std::vector<Override> all = changes;
    all.insert(all.end(), more.begin(), more.end());
    return core::read_scene(file, all, folders);
}

Neighbours neighbours_of(const ChangedScene& base) {
    return Search(base).all();
}

std::vector<Override> finest_step(const Scene& scene, const PluginFolders& folders) {
    std::vector<Override> finest;
    visit_steps(scene, folders, [&](const Standing& standing) {
        if (standing.parameter.kind == Kind::choice || standing.key == "run.rate") return;
        if (const auto value = one_step(standing.parameter, standing.given, Step::finer))
            finest.push_back(changed(standing.key, *value));
    });
    return finest;
}

optional<std::string> load_by_mesh(const Scene& scene, const PluginFolders& folders) {
    if (scene.needle || !scene.tissue || scene.effects.empty()) return std::nullopt;
    const PluginLibrary library = PluginLibrary::open(scene.tissue->type, Role::tissue, folders);
    const std::string name = "load_shared_by", same_for_all = "area";
    const auto shares = [&](const Parameter& parameter) { return parameter.name == name; };
    if (std::ranges::none_of(parameters_of(library.descriptor()), shares)) return std::nullopt;
    const Parameters& given = scene.tissue->parameters;
    if (given.has(name) && given.text(name) == same_for_all) return std::nullopt;
    return fmt::format(
        "the load is shared out by the mesh: another mesh bears another one, and errors hold that too; "
        "--set {}={} is the same load for all",
        core::join(scene.tissue->within, name), same_for_all);
}

std::vector<Neighbour> omissions(const Scene& scene, const PluginFolders& folders) {
    std::vector<Neighbour> all;
    for (const Choice& effect : scene.effects)
        all.push_back({fmt::format("{} {}", effect.path, effect.type), {without(effect.path)}});
    if (scene.buckling && asks_for_load(scene, folders))
        all.push_back({fmt::format("{} {}", buckling_slot.section, scene.buckling->type), {without(buckling_slot.section)}});
    visit_parameters(scene, folders, [&](const Standing& standing) {
        const Parameter& parameter = standing.parameter;
        const bool quantity = parameter.kind == Kind::number || parameter.kind == Kind::vector3;
        const bool off_when_absent = parameter.need == Need::optional && quantity && parameter.finer == Finer::neither;
        if (off_when_absent && standing.given.has(parameter.name)) all.push_back({standing.key, {without(standing.key)}});
    });
    return all;
}

bool asks_for_load(const Scene& scene, const PluginFolders& folders) {
    if (!scene.needle) return false;
    const Listening listening;
    std::vector<PluginLibrary> libraries;
    core::Maker maker{.scene = scene, .folders = folders, .workers = one_thread(), .libraries = libraries};
    const auto needle = maker.make<NeedleModel>(*scene.needle, &listening);
    if (!needle) return false;
    maker.guard(*scene.needle, [&] {
        const double length = scene.needle_setup->length;
        needle->predict({.position = {0.0, 0.0, length}}, length, scene.run.dt());
        needle->commit();
    });
    return listening.asked();
}

}    // namespace stylet::study
