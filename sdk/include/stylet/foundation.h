// The tissue's layers as the elastic foundation of a column, for buckling models that know what tissue does.
//
//     foundation_modulus: given
//     given:
//       - {layer: fat, modulus: 28.5 kPa}
//       - {layer: muscle, modulus: 77.3 kPa}
//
// What is given is each model's own: the k of a Winkler foundation and the μ of Eq. (3) are different numbers for one tissue.
#pragma once

#include <stylet/foundation_modulus.h>

#include <array>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace stylet {

/// To be declared by every plugin that makes a Foundation.
inline constexpr Parameter foundation_modulus_parameter = optional(choice(
    "foundation_modulus", "vesic disc_in_block disc_between_walls given",
    "where each layer's modulus as a Winkler foundation comes from: Vesic's beam on a surface; a disc in plane strain in a block "
    "whose four sides are fixed, or in a square one between two fixed sides, along which the needle buckles; or the list "
    "`given`. Left out: only where the scene has no tissue"));

/// The fields of the records `given`.
inline constexpr Parameter given_modulus_fields[] = {
    text("layer", "the name of one of the tissue's layers"),
    number("modulus", "Pa", not_negative, "newtons a metre of shaft for a metre of deflection"),
};

/// To be declared beside foundation_modulus_parameter.
inline constexpr Parameter given_moduli_parameter =
    optional(records("given", given_modulus_fields,
                     "the modulus of every layer, used where foundation_modulus is `given`; left out: with the others"));

/// A part of a column with one foundation modulus, from base to tip.
struct FoundationPiece {
    double begin;      // [m] from the base
    double end;        // [m] from the base, beyond `begin`
    double modulus;    // [Pa] k, zero in air
};

/// More layers than this are refused when a Foundation is made.
inline constexpr std::size_t max_foundation_layers = 32;

/// The pieces of one column, base first. A value without memory of its own elsewhere, so that a tick may make one.
class FoundationPieces {
public:
    /// Adds what follows; nothing where the length [m] is zero.
    void add(double length, double modulus) {
        if (!(length > 0.0)) return;
        const double begin = size_ == 0 ? 0.0 : pieces_[size_ - 1].end;
        pieces_[size_++] = {.begin = begin, .end = begin + length, .modulus = modulus};
    }

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] const FoundationPiece* begin() const { return pieces_.data(); }
    [[nodiscard]] const FoundationPiece* end() const { return pieces_.data() + size_; }
    [[nodiscard]] const FoundationPiece& operator[](std::size_t i) const { return pieces_[i]; }

private:
    std::array<FoundationPiece, max_foundation_layers + 2> pieces_;    // air above and below the layers
    std::size_t size_ = 0;
};

namespace foundation_reader {

inline std::string names(const TissueSetup& tissue) {
    std::string names;
    for (const Layer& layer : tissue.layers) names += (names.empty() ? "" : ", ") + layer.name;
    return names;
}

inline std::size_t index_of(const std::string& name, const TissueSetup& tissue) {
    for (std::size_t i = 0; i < tissue.layers.size(); ++i)
        if (tissue.layers[i].name == name) return i;
    throw Error("given", "found the layer \"" + name + "\", wanted the names of the tissue's layers: " + names(tissue));
}

/// The modulus of each layer [Pa], from the records `given`.
inline std::vector<double> given_moduli(const Parameters& parameters, const TissueSetup& tissue) {
    const std::string wanted = ", wanted every layer once: " + names(tissue);
    if (!parameters.has("given")) throw Error("given", "found none beside `foundation_modulus: given`" + wanted);
    constexpr double none = -1.0;
    std::vector<double> moduli(tissue.layers.size(), none);
    for (const Parameters& record : parameters.records("given")) {
        const std::string& name = record.text("layer");
        double& modulus = moduli[index_of(name, tissue)];
        if (modulus != none) throw Error("given", "found the layer \"" + name + "\" twice" + wanted);
        modulus = record.number("modulus");
    }
    for (std::size_t i = 0; i < moduli.size(); ++i)
        if (moduli[i] == none) throw Error("given", "found no modulus of the layer \"" + tissue.layers[i].name + "\"" + wanted);
    return moduli;
}

/// The radius that stands for the block's four sides [m], for each layer the same.
inline std::vector<double> block_bounds(const TissueSetup& tissue) {
    if (tissue.fixed == "bottom")
        throw Error("foundation_modulus",
                    "found disc_in_block for a block whose sides are free (`fixed: bottom`), which in plane strain hold nothing; "
                    "wanted `fixed: sides` or `bottom_and_sides`, or else vesic or given");
    return std::vector<double>(tissue.layers.size(), conformal_radius(tissue.extent.x(), tissue.extent.y()));
}

/// The radius that stands for two opposite sides [m], in each layer its own.
inline std::vector<double> wall_bounds(const TissueSetup& tissue) {
    constexpr double rounding = 1e-9;
    const double side = tissue.extent.x(), other_side = tissue.extent.y();    // [m]
    if (std::abs(side - other_side) > rounding * side) {
        std::ostringstream message;
        message << "found disc_between_walls for a block of " << side << " m by " << other_side
                << " m, wanted a square one: it was calculated for no other";
        throw Error("foundation_modulus", message.str());
    }
    std::vector<double> bounds;
    for (const Layer& layer : tissue.layers) {
        if (layer.poisson_ratio < 0.0)
            throw Error("foundation_modulus", "found disc_between_walls and a Poisson ratio below zero in the layer \"" +
                                                  layer.name + "\", wanted zero or more: it was calculated for no other");
        bounds.push_back(radius_between_walls(0.5 * side, layer.poisson_ratio));
    }
    return bounds;
}

}    // namespace foundation_reader

/// What the layers of a scene's tissue are to a column.
class Foundation {
public:
    /// Reads foundation_modulus and given. Throws Error at the parameter that is missing or does not go with the tissue. A scene
    /// without a tissue needs neither, and its columns are in air.
    explicit Foundation(const Setup& setup) : tissue_(setup.tissue) {
        if (tissue_ == nullptr) return;
        if (tissue_->layers.size() > max_foundation_layers)
            throw Error("foundation_modulus", "found a tissue of " + std::to_string(tissue_->layers.size()) +
                                                  " layers, wanted at most " + std::to_string(max_foundation_layers));
        if (!setup.parameters.has("foundation_modulus"))
            throw Error("foundation_modulus",
                        "found none in a scene with a tissue, wanted vesic, disc_in_block, disc_between_walls or given: what its "
                        "layers are to a needle");
        const std::string& source = setup.parameters.text("foundation_modulus");
        if (source == "given") given_ = foundation_reader::given_moduli(setup.parameters, *tissue_);
        if (source == "disc_in_block") bounds_ = foundation_reader::block_bounds(*tissue_);
        if (source == "disc_between_walls") bounds_ = foundation_reader::wall_bounds(*tissue_);
    }

    /// From base to tip: air over the free length, then each layer as far as the needle crosses it (a slanting one crosses
    /// inserted/depth of its thickness), and air again beyond the last. Allocates nothing.
    [[nodiscard]] FoundationPieces under(const Column& column) const {
        FoundationPieces pieces;
        pieces.add(column.free_length, 0.0);
        double left = column.inserted;    // [m]
        if (tissue_ != nullptr && left > 0.0) {
            const double way = column.depth > 0.0 ? left / column.depth : std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i < tissue_->layers.size() && left > 0.0; ++i) {
                const double crossed = std::min(left, way * tissue_->layers[i].thickness);
                pieces.add(crossed, modulus(i, column));
                left -= crossed;
            }
        }
        constexpr double rounding = 1e-12;    // a tip that just reaches the bottom is not in air
        if (left > rounding * column.inserted) pieces.add(left, 0.0);
        return pieces;
    }

private:
    [[nodiscard]] double modulus(std::size_t i, const Column& column) const {    // [Pa] of layer i
        if (!given_.empty()) return given_[i];
        if (!bounds_.empty()) return disc_modulus(tissue_->layers[i], column.radius, bounds_[i]);
        return vesic_modulus(tissue_->layers[i], column);
    }

    const TissueSetup* tissue_;
    std::vector<double> given_;     // [Pa] of each layer, where the modulus is given
    std::vector<double> bounds_;    // [m] of each layer, where a disc's is taken
};

}    // namespace stylet
