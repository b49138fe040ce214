#include "fast/reach.h"

#include <algorithm>

namespace stylet::corotational_fem {

Reach::Reach(Panels& panels) : panels_(panels), path_(panels.parts_.size()), stop_(panels.parts_.size(), -1) {
    std::size_t lines = 0, rows = 0;
    for (const Panels::Part& part : panels.parts_) {
        lines += 3 * part.own_tiles;
        rows = std::max(rows, static_cast<std::size_t>(3 * part.row_tiles));
    }
    loads_.resize(lines);
    answers_.resize(lines);
    rows_.resize(rows);
}

void Reach::sweep(std::span<const NodeWeight> footprint) {
    find_path(footprint);
    load(footprint);
    for (int i = 0; i < stops_; ++i) climb(path_[i]);
}

// All supernodes from those of the footprint up to their roots.
void Reach::find_path(std::span<const NodeWeight> footprint) {
    const Dissection& d = panels_.dissection_;
    for (int i = 0; i < stops_; ++i) stop_[path_[i].supernode] = -1;
    stops_ = 0;
    for (const NodeWeight& share : footprint) {
        const int place = d.place_of_node[share.node];
        if (place == d.places()) continue;
        for (int s = d.supernode[place]; s >= 0 && stop_[s] < 0; s = d.parent(s)) {
            stop_[s] = 0;
            path_[stops_++] = {s, panels_.parts_[s].own_tiles, 0};
        }
    }
    std::sort(path_.begin(), path_.begin() + stops_, [](const Stop& a, const Stop& b) { return a.supernode < b.supernode; });
    for (int i = 0, at = 0; i < stops_; at += 3 * path_[i].lines, ++i) {
        path_[i].at = at;
        stop_[path_[i].supernode] = i;
    }
}

void Reach::load(std::span<const NodeWeight> footprint) {
    const Dissection& d = panels_.dissection_;
    const int lines = stops_ == 0 ? 0 : path_[stops_ - 1].at + 3 * path_[stops_ - 1].lines;
    std::fill_n(loads(0), lines * lanes, 0.0F);
    for (const NodeWeight& share : footprint) {
        const int place = d.place_of_node[share.node];
        if (place == d.places()) continue;
        const Stop& stop = path_[stop_[d.supernode[place]]];
        float* const own = loads(stop.at) + 3 * (place - d.supernodes[stop.supernode].first);
        const float load = panels_.scale_[place] * static_cast<float>(share.weight);
        for (int axis = 0; axis < 3; ++axis) own[axis * stop.lines * lanes + axis] += load;
    }
}

// From a stop's load its answer, and what of it is left for the stops above.
void Reach::climb(const Stop& stop) {
    const Dissection& d = panels_.dissection_;
    const Supernode& supernode = d.supernodes[stop.supernode];
    const Panels::Part& part = panels_.parts_[stop.supernode];
    float* const rows = reinterpret_cast<float*>(rows_.data());
    std::fill_n(answers(stop.at), 3 * stop.lines * lanes, 0.0F);
    std::fill_n(rows, 3 * part.row_tiles * lanes, 0.0F);
    const PanelProducts& products = panels_.products_;
    products.symmetric_of_three(panels_.blocks_.at(part.inverse), part.own_tiles, loads(stop.at), answers(stop.at));
    products.general_of_three(panels_.blocks_.at(part.below), part.row_tiles, part.own_tiles, loads(stop.at), rows);
    for (int i = 0; i < supernode.rows; ++i) {
        const int place = d.rows[supernode.rows_begin + i];
        const Stop& above = path_[stop_[d.supernode[place]]];
        float* const to = loads(above.at) + 3 * (place - d.supernodes[above.supernode].first);
        for (int axis = 0; axis < 3; ++axis) {
            const float* const from = rows + axis * part.row_tiles * lanes + 3 * i;
            for (int k = 0; k < 3; ++k) to[axis * above.lines * lanes + k] -= from[k];
        }
    }
}

Matrix3 Reach::compliance(const Reach& other) const {
    float products[9] = {};
    for (int i = 0; i < stops_; ++i) {
        const Stop& stop = path_[i];
        const int theirs = other.stop_[stop.supernode];
        if (theirs < 0) continue;
        panels_.kernels_.dots(loads(stop.at), other.answers(other.path_[theirs].at), stop.lines * lanes, products);
    }
    Matrix3 w;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            w(i, j) = this == &other ? 0.5 * (products[3 * i + j] + products[3 * j + i]) : products[3 * i + j];
    }
    return w;
}

Vector3 Reach::displacement() const {
    float products[3] = {};
    for (int i = 0; i < stops_; ++i) {
        const Stop& stop = path_[i];
        panels_.kernels_.dots_with_one(answers(stop.at), panels_.loads(panels_.parts_[stop.supernode]), stop.lines * lanes,
                                       products);
    }
    return {products[0], products[1], products[2]};
}

void Reach::push(const Vector3& force) const {
    const float f[3] = {static_cast<float>(force.x()), static_cast<float>(force.y()), static_cast<float>(force.z())};
    for (int i = 0; i < stops_; ++i) {
        const Stop& stop = path_[i];
        panels_.kernels_.add(loads(stop.at), f, stop.lines * lanes, panels_.loads(panels_.parts_[stop.supernode]));
    }
}

}    // namespace stylet::corotational_fem
