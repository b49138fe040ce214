#include "fast/panels.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace stylet::corotational_fem {

namespace {

int tiles(int nodes) {
    return (3 * nodes + lanes - 1) / lanes;
}

// The three numbers of each node, one node after the other; may write one number beyond them.
void compact(const Float4* nodes, int count, float* to) {
    for (int i = 0; i < count; ++i, to += 3) {
        to[0] = nodes[i].x;
        to[1] = nodes[i].y;
        to[2] = nodes[i].z;
    }
}

void compact(const Float4* nodes, const int* slots, int count, float* to) {
    for (int i = 0; i < count; ++i, to += 3) {
        const Float4& node = nodes[slots[i]];
        to[0] = node.x;
        to[1] = node.y;
        to[2] = node.z;
    }
}

void subtract(const float* from, Float4* nodes, const int* slots, int count) {
    for (int i = 0; i < count; ++i, from += 3) {
        Float4& node = nodes[slots[i]];
        node.x -= from[0];
        node.y -= from[1];
        node.z -= from[2];
    }
}

void add(const Float4* from, Float4* nodes, const int* slots, int count) {
    for (int i = 0; i < count; ++i) {
        Float4& node = nodes[slots[i]];
        node.x += from[i].x;
        node.y += from[i].y;
        node.z += from[i].z;
    }
}

Float4 scaled(float by, const Float4& v) {
    return {by * v.x, by * v.y, by * v.z, 0.0F};
}

void put(float value, float& to) {
    to = value;
}
void put(float value, Eigen::half& to) {
    to = Eigen::half(value);
}

// Tiles of the rows from `from` on of a matrix, for one column of tiles.
template <class Stored>
Stored* put_column(const MatrixX& matrix, int from, int to, int tile_column, Stored* into) {
    for (int r = from; r < to; ++r) {
        for (int j = lanes * tile_column; j < lanes * (tile_column + 1); ++j) {
            for (int i = lanes * r; i < lanes * (r + 1); ++i) {
                put(i < matrix.rows() && j < matrix.cols() ? static_cast<float>(matrix(i, j)) : 0.0F, *into++);
            }
        }
    }
    return into;
}

template <class Stored>
void put_blocks(const MatrixX& inverse, const MatrixX& below, int own_tiles, int row_tiles, void* to_inverse, void* to_below) {
    Stored* next = static_cast<Stored*>(to_inverse);
    for (int c = 0; c < own_tiles; ++c) next = put_column(inverse, c, own_tiles, c, next);
    next = static_cast<Stored*>(to_below);
    for (int c = 0; c < own_tiles; ++c) next = put_column(below, 0, row_tiles, c, next);
}

}    // namespace

Storage smallest_storage(InstructionSet set) {
    return panel_kernels(set).half.general != nullptr ? Storage::half : Storage::single;
}

Panels::Panels(const Factor& factor, Storage storage, InstructionSet set)
    : dissection_(factor.dissection()),
      storage_(storage),
      products_(storage == Storage::half ? panel_kernels(set).half : panel_kernels(set).whole),
      dots_(panel_kernels(set).dots),
      scale_(dissection_.places()) {
    lay_out();
    pack(factor);
}

void Panels::lay_out() {
    const std::size_t lines_per_tile = lanes * lanes * (storage_ == Storage::half ? 2 : 4) / sizeof(Line);
    std::size_t lines = 0;
    int nodes = 0, scratch = 0;
    for (int g = 0; g < static_cast<int>(dissection_.groups.size()); ++g) {
        const Group& group = dissection_.groups[g];
        if (group.stage == static_cast<int>(stages_.size())) stages_.push_back({g, 0});
        ++stages_.back()[1];
        Room room{nodes, group.size, group.outside, scratch, 0, 0, 0};
        const int* outside = dissection_.outside.data() + group.outside_begin;
        int most = 0;
        for (int s = group.begin; s < group.end; ++s) {
            const Supernode& supernode = dissection_.supernodes[s];
            const int own = tiles(supernode.size), rows = tiles(supernode.rows);
            parts_.push_back({lines, lines + own * (own + 1) / 2 * lines_per_tile, own, rows,
                              nodes + supernode.first - group.first, static_cast<int>(slots_.size())});
            lines += (own * (own + 1) / 2 + own * rows) * lines_per_tile;
            most = std::max(most, 2 * own + rows);
            for (int i = supernode.rows_begin; i < supernode.rows_begin + supernode.rows; ++i) {
                const int place = dissection_.rows[i], beyond = place - group.first - group.size;
                const int at =
                    beyond < 0
                        ? place - group.first
                        : group.size + static_cast<int>(std::lower_bound(outside, outside + group.outside, place) - outside);
                slots_.push_back(nodes + at);
            }
        }
        rooms_.push_back(room);
        nodes += group.size + group.outside;
        scratch += most;
    }
    for (int g = 0; g < static_cast<int>(dissection_.groups.size()); ++g) {
        const Group& group = dissection_.groups[g];
        rooms_[g].slots = static_cast<int>(outside_slots_.size());
        for (int i = group.outside_begin; i < group.outside_begin + group.outside; ++i) {
            const int place = dissection_.outside[i];
            const Group& parent = dissection_.groups[group.parent];
            const int* outside = dissection_.outside.data() + parent.outside_begin;
            const int at =
                place < parent.first + parent.size
                    ? place - parent.first
                    : parent.size + static_cast<int>(std::lower_bound(outside, outside + parent.outside, place) - outside);
            outside_slots_.push_back(rooms_[group.parent].begin + at);
        }
        rooms_[g].children_begin = static_cast<int>(children_.size());
        for (int child = 0; child < g; ++child) {
            if (dissection_.groups[child].parent == g) children_.push_back(child);
        }
        rooms_[g].children = static_cast<int>(children_.size()) - rooms_[g].children_begin;
    }
    blocks_.resize(lines);
    swept_.resize(nodes);
    moved_.resize(nodes);
    scratch_.resize(scratch);    // a column of a tile in single precision is a line
    static_assert(sizeof(Line) == lanes * sizeof(float));
}

void Panels::pack(const Factor& factor) {
    const int count = static_cast<int>(parts_.size());
    VectorX scale(3 * dissection_.places());
    for (int s = 0; s < count; ++s) {
        const Supernode& supernode = dissection_.supernodes[s];
        for (int i = 0; i < supernode.size; ++i) {
            const double c = std::sqrt(factor.inverse(s).diagonal().segment<3>(3 * i).mean());
            scale_[supernode.first + i] = static_cast<float>(c);
            scale.segment<3>(3 * (supernode.first + i)).setConstant(c);
        }
    }
    MatrixX inverse, below;
    for (int s = 0; s < count; ++s) {
        const Supernode& supernode = dissection_.supernodes[s];
        const VectorX own = scale.segment(3 * supernode.first, 3 * supernode.size).cwiseInverse();
        VectorX rows(3 * supernode.rows);
        for (int i = 0; i < supernode.rows; ++i)
            rows.segment<3>(3 * i) = scale.segment<3>(3 * dissection_.rows[supernode.rows_begin + i]);
        inverse = own.asDiagonal() * factor.inverse(s) * own.asDiagonal();
        below = rows.asDiagonal() * factor.below(s) * own.asDiagonal();
        const Part& part = parts_[s];
        void* const to_inverse = blocks_.data() + part.inverse;
        void* const to_below = blocks_.data() + part.below;
        if (storage_ == Storage::half) {
            put_blocks<Eigen::half>(inverse, below, part.own_tiles, part.row_tiles, to_inverse, to_below);
        } else {
            put_blocks<float>(inverse, below, part.own_tiles, part.row_tiles, to_inverse, to_below);
        }
    }
}

void Panels::forward(const Float4* rhs, Workers& workers) {
    for (const auto& [first, count] : stages_) {
        workers.each(count, [&, g = first](int task) { sweep(dissection_.groups[g + task], rooms_[g + task], rhs); });
    }
}

void Panels::backward(Float4* x, Workers& workers) {
    for (auto stage = stages_.rbegin(); stage != stages_.rend(); ++stage) {
        const int first = (*stage)[0];
        workers.each((*stage)[1], [&](int task) { substitute(dissection_.groups[first + task], rooms_[first + task], x); });
    }
}

void Panels::sweep(const Group& group, const Room& room, const Float4* rhs) {
    Float4* const local = swept_.data() + room.begin;
    for (int i = 0; i < room.size; ++i) local[i] = scaled(scale_[group.first + i], rhs[group.first + i]);
    std::fill_n(local + room.size, room.outside, Float4{});
    for (int i = room.children_begin; i < room.children_begin + room.children; ++i) {
        const Room& child = rooms_[children_[i]];
        add(swept_.data() + child.begin + child.size, swept_.data(), outside_slots_.data() + child.slots, child.outside);
    }
    for (int s = group.begin; s < group.end; ++s) {
        const Supernode& supernode = dissection_.supernodes[s];
        const Part& part = parts_[s];
        float* const own = reinterpret_cast<float*>(scratch_.data() + room.scratch);
        float* const rows = own + part.own_tiles * lanes;
        compact(swept_.data() + part.own, supernode.size, own);
        std::fill(own + 3 * supernode.size, rows, 0.0F);
        std::fill_n(rows, part.row_tiles * lanes, 0.0F);
        products_.general(blocks_.data() + part.below, part.row_tiles, part.own_tiles, 0, part.row_tiles, own, rows);
        subtract(rows, swept_.data(), slots_.data() + part.slots, supernode.rows);
    }
}

void Panels::substitute(const Group& group, const Room& room, Float4* x) {
    Float4* const local = moved_.data() + room.begin;
    for (int i = 0; i < room.outside; ++i) local[room.size + i] = moved_[outside_slots_[room.slots + i]];
    for (int s = group.end - 1; s >= group.begin; --s) {
        const Supernode& supernode = dissection_.supernodes[s];
        const Part& part = parts_[s];
        float* const own = reinterpret_cast<float*>(scratch_.data() + room.scratch);
        float* const moved = own + part.own_tiles * lanes;
        float* const rows = moved + part.own_tiles * lanes;
        compact(swept_.data() + part.own, supernode.size, own);
        std::fill(own + 3 * supernode.size, moved, 0.0F);
        std::fill(moved, rows, 0.0F);
        compact(moved_.data(), slots_.data() + part.slots, supernode.rows, rows);
        std::fill(rows + 3 * supernode.rows, rows + part.row_tiles * lanes, 0.0F);
        products_.symmetric(blocks_.data() + part.inverse, part.own_tiles, own, moved);
        products_.transposed(blocks_.data() + part.below, part.row_tiles, part.own_tiles, rows, moved);
        for (int i = 0; i < supernode.size; ++i) {
            moved_[part.own + i] = {moved[3 * i], moved[3 * i + 1], moved[3 * i + 2], 0.0F};
        }
    }
    for (int i = 0; i < room.size; ++i) x[group.first + i] = scaled(scale_[group.first + i], local[i]);
}

}    // namespace stylet::corotational_fem
