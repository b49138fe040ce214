#include "mesh/regions.h"

#include <algorithm>

namespace stylet::corotational_fem {
namespace {

constexpr int volume = 3;
constexpr int none = -1;

std::string names_of(const TissueSetup& tissue) {
    std::string names;
    for (const Layer& layer : tissue.layers) names += (names.empty() ? "" : ", ") + in_quotes(layer.name);
    return names;
}

/// Finds the layer of one tetrahedron after another.
class Regions {
public:
    Regions(const GmshContent& content, const TissueSetup& tissue, const GmshScanner& scanner)
        : content_(content), tissue_(tissue), scanner_(scanner) {
        for (const GmshGroup& group : content.groups) {
            if (group.dimension == volume) named_[group.tag] = &group;
        }
    }

    int layer_of(const GmshElement& tetrahedron) {
        const auto [known, is_new] = layers_.try_emplace(tetrahedron.entity, none);
        if (is_new) known->second = find(tetrahedron);
        return known->second;
    }

    [[nodiscard]] std::string names() const {
        std::string names;
        for (const auto& [tag, group] : named_) names += (names.empty() ? "" : ", ") + in_quotes(group->name);
        return names.empty() ? "it names none" : names;
    }

private:
    int layer_named(const std::string& name) const {
        const auto found =
            std::find_if(tissue_.layers.begin(), tissue_.layers.end(), [&](const Layer& layer) { return layer.name == name; });
        return found == tissue_.layers.end() ? none : static_cast<int>(found - tissue_.layers.begin());
    }

    int find(const GmshElement& tetrahedron) const {
        if (named_.empty() && tissue_.layers.size() == 1) return 0;
        const GmshGroup* region = nullptr;    // the last that is no layer
        const GmshGroup* found = nullptr;     // the one that is
        const auto groups = content_.groups_of.find({volume, tetrahedron.entity});
        if (groups != content_.groups_of.end()) {
            for (const int tag : groups->second) {
                const auto named = named_.find(tag);
                if (named == named_.end()) continue;
                const bool is_layer = layer_named(named->second->name) != none;
                if (is_layer && found != nullptr && found->name != named->second->name)
                    refuse_both(tetrahedron, *found, *named->second);
                (is_layer ? found : region) = named->second;
            }
        }
        if (found != nullptr) return layer_named(found->name);
        const std::string wanted = ", wanted the name of one of the tissue's layers: " + names_of(tissue_);
        if (region != nullptr) throw scanner_.complaint(region->place, "found the region " + in_quotes(region->name) + wanted);
        throw scanner_.complaint(tetrahedron.place, "found tetrahedron " + std::to_string(tetrahedron.tag) +
                                                        " in no named region (physical volume)" + wanted);
    }

    [[noreturn]] void refuse_both(const GmshElement& tetrahedron, const GmshGroup& a, const GmshGroup& b) const {
        throw scanner_.complaint(tetrahedron.place, "found tetrahedron " + std::to_string(tetrahedron.tag) + " in the regions " +
                                                        in_quotes(a.name) + " and " + in_quotes(b.name) +
                                                        ", wanted it in one layer");
    }

    const GmshContent& content_;
    const TissueSetup& tissue_;
    const GmshScanner& scanner_;
    std::map<int, const GmshGroup*> named_;    // volumes, by tag
    std::map<int, int> layers_;                // of entities
};

}    // namespace

std::vector<int> layers_of_regions(const GmshContent& content, const TissueSetup& tissue, const GmshScanner& scanner) {
    Regions regions(content, tissue, scanner);
    std::vector<int> layers;
    for (const GmshElement& element : content.elements) {
        if (element.dimension == volume) layers.push_back(regions.layer_of(element));
    }
    for (int layer = 0; layer < static_cast<int>(tissue.layers.size()); ++layer) {
        if (std::find(layers.begin(), layers.end(), layer) != layers.end()) continue;
        throw scanner.complaint_of_file("found no tetrahedron of the layer " + in_quotes(tissue.layers[layer].name) +
                                        ", wanted some of each layer; the file's regions: " + regions.names());
    }
    return layers;
}

}    // namespace stylet::corotational_fem
