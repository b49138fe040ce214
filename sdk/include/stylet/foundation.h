// The tissue's layers as the elastic foundation of a column, for buckling models that know what tissue does.
//
//     foundation_modulus: given
//     given:
//       - {layer: fat, modulus: 28.5 kPa}
//       - {layer: muscle, modulus: 77.3 kPa}
#pragma once

#include <stylet/foundation_modulus.h>

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace stylet {

/// To be declared by every plugin that makes a Foundation.
inline constexpr Parameter foundation_modulus_parameter = optional(choice(
    "foundation_modulus", "vesic disc_in_block given",
    "where each layer's modulus as a Winkler foundation comes from: Vesic's beam on a surface; a disc in a block whose sides "
    "are fixed, in plane strain; or the list `given`. Left out: only where the scene has no tissue"));

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
            throw Error(
                "foundation_modulus",
                "found none in a scene with a tissue, wanted vesic, disc_in_block or given: what the layers are to a needle");
        const std::string& source = setup.parameters.text("foundation_modulus");
        if (source == "given") read_given(setup.parameters);
        if (source == "disc_in_block") set_bound();
    }

    /// From base to tip: air over the free length, then each layer as far as the needle crosses it (a slanting one crosses
    /// inserted/depth of its thickness), and air again beyond the last. Allocates nothing.
    [[nodiscard]] FoundationPieces under(const Column& column) const {
        FoundationPieces pieces;
        pieces.add(column.free_length, 0.0);
        if (!(column.inserted > 0.0) || tissue_ == nullptr) {
            pieces.add(column.inserted, 0.0);
            return pieces;
        }
        const double way = column.depth > 0.0 ? column.inserted / column.depth : std::numeric_limits<double>::infinity();
        double left = column.inserted;    // [m]
        for (std::size_t i = 0; i < tissue_->layers.size() && left > 0.0; ++i) {
            const double crossed = std::min(left, way * tissue_->layers[i].thickness);
            pieces.add(crossed, modulus(i, column));
            left -= crossed;
        }
        pieces.add(left, 0.0);
        return pieces;
    }

private:
    [[nodiscard]] double modulus(std::size_t layer, const Column& column) const {    // [Pa]
        if (!given_.empty()) return given_[layer];
        if (bound_ > 0.0) return disc_modulus(tissue_->layers[layer], column.radius, bound_);
        return vesic_modulus(tissue_->layers[layer], column);
    }

    void read_given(const Parameters& parameters) {
        if (!parameters.has("given"))
            throw Error("given", "found none beside `foundation_modulus: given`, wanted the modulus of every layer: " + names());
        given_.assign(tissue_->layers.size(), -1.0);
        for (const Parameters& record : parameters.records("given")) {
            double& modulus = given_[index_of(record.text("layer"))];
            if (modulus >= 0.0)
                throw Error("given",
                            "found the layer \"" + record.text("layer") + "\" twice, wanted every layer once: " + names());
            modulus = record.number("modulus");
        }
        for (std::size_t i = 0; i < given_.size(); ++i) {
            if (given_[i] < 0.0)
                throw Error("given", "found no modulus of the layer \"" + tissue_->layers[i].name +
                                         "\", wanted every layer once: " + names());
        }
    }

    [[nodiscard]] std::size_t index_of(const std::string& name) const {
        for (std::size_t i = 0; i < tissue_->layers.size(); ++i)
            if (tissue_->layers[i].name == name) return i;
        throw Error("given", "found the layer \"" + name + "\", wanted the names of the tissue's layers: " + names());
    }

    [[nodiscard]] std::string names() const {
        std::string names;
        for (const Layer& layer : tissue_->layers) names += (names.empty() ? "" : ", ") + layer.name;
        return names;
    }

    void set_bound() {
        if (tissue_->fixed == "bottom")
            throw Error(
                "foundation_modulus",
                "found disc_in_block for a block whose sides are free (`fixed: bottom`), which in plane strain hold nothing; "
                "wanted `fixed: sides` or `bottom_and_sides`, or else vesic or given");
        bound_ = conformal_radius(tissue_->extent.x(), tissue_->extent.y());
    }

    const TissueSetup* tissue_;
    std::vector<double> given_;    // [Pa] of each layer; empty where it is calculated
    double bound_ = 0.0;           // [m] radius that the sides stand for; zero where they do not matter
};

}    // namespace stylet
