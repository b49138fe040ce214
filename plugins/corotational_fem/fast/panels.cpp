#include "fast/panels.h"

#include "fast/nodal.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace stylet::corotational_fem {

namespace {

// A task of about 10 µs.
constexpr int share = 512;    // [tiles]

int tiles(int nodes) {
    return (3 * nodes + lanes - 1) / lanes;
}

// The three numbers of each node, one node after the other. The fourth, which may be anything, is written too, and then over.
template <class Slot>
void compact(const Float4* nodes, int count, Slot&& slot, float* to) {
    for (int i = 0; i < count - 1; ++i, to += 3) std::memcpy(to, &nodes[slot(i)], sizeof(Float4));
    if (count > 0) std::memcpy(to, &nodes[slot(count - 1)], 3 * sizeof(float));
}

// The other way round; reads one number beyond the last node's.
Quad expand(const float* from) {
    Quad v;
    std::memcpy(&v, from, sizeof(v));
    return v;
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
      kernels_(panel_kernels(set)),
      products_(storage == Storage::half ? kernels_.half : kernels_.whole),
      scale_(dissection_.places()) {
    lay_out();
    tie_groups();
    share_out();
    pack(factor);
}

void Panels::lay_out() {
    static_assert(sizeof(Line) == lanes * sizeof(float), "a line is a column of a tile in single precision");
    const std::size_t tile = lanes * lanes * (storage_ == Storage::half ? sizeof(Eigen::half) : sizeof(float));    // [bytes]
    int loads = 0, nodes = 0, scratch = 0;
    for (int g = 0; g < static_cast<int>(dissection_.groups.size()); ++g) {
        const Group& group = dissection_.groups[g];
        rooms_.push_back({nodes, group.size, group.outside, scratch, 0, 0, 0});
        int most = 0;
        for (int s = group.begin; s < group.end; ++s) {
            const Supernode& supernode = dissection_.supernodes[s];
            const int own = tiles(supernode.size), rows = tiles(supernode.rows), inverse = own * (own + 1) / 2;
            parts_.push_back({bytes_, bytes_ + inverse * tile, own, rows, loads, nodes + supernode.first - group.first,
                              static_cast<int>(slots_.size()), 0, 0});
            for (int i = 0; i < supernode.rows; ++i) slots_.push_back(slot(g, dissection_.rows[supernode.rows_begin + i]));
            bytes_ += (inverse + own * rows) * tile;
            loads += own;
            most = std::max(most, own + rows + 1);    // expand() reads beyond the last
        }
        nodes += group.size + group.outside;
        scratch += most;
    }
    blocks_ = LargePages(bytes_);
    loads_.resize(loads);
    nodes_.resize(nodes);
    scratch_.resize(scratch);
}

void Panels::tie_groups() {
    for (int g = 0; g < static_cast<int>(rooms_.size()); ++g) {
        const Group& group = dissection_.groups[g];
        if (group.stage == static_cast<int>(stages_.size())) stages_.push_back({g, 0});
        ++stages_.back()[1];
        Room& room = rooms_[g];
        room.slots = static_cast<int>(outside_slots_.size());
        for (int i = 0; i < group.outside; ++i) {
            outside_slots_.push_back(slot(group.parent, dissection_.outside[group.outside_begin + i]));
        }
        room.begin = static_cast<int>(children_.size());
        for (int child = 0; child < g; ++child) {
            if (dissection_.groups[child].parent == g) children_.push_back(child);
        }
        room.children = static_cast<int>(children_.size()) - room.begin;
    }
}

// Those products with S⁻¹ that are taken for themselves, all at once, as nothing but the forward half comes before them: of all
// supernodes whose groups are too few to keep several threads busy.
void Panels::share_out() {
    int answers = 0;
    for (const Group& group : dissection_.groups) {
        if (group.stage == 0) continue;
        for (int s = group.begin; s < group.end; ++s) {
            Part& part = parts_[s];
            part.begin = static_cast<int>(shares_.size());
            for (int first = 0, last = 0; first < part.own_tiles; first = last) {
                for (int count = 0; last < part.own_tiles && count < share; ++last) count += part.own_tiles - last;
                shares_.push_back({s, first, last, answers});
                answers += part.own_tiles;
            }
            part.shares = static_cast<int>(shares_.size()) - part.begin;
        }
    }
    answers_.resize(answers);
}

// Where a group has this place in nodes_.
int Panels::slot(int g, int place) const {
    const Group& group = dissection_.groups[g];
    if (place < group.first + group.size) return rooms_[g].nodes + place - group.first;
    const int* const outside = dissection_.outside.data() + group.outside_begin;
    const int* const found = std::lower_bound(outside, outside + group.outside, place);
    return rooms_[g].nodes + group.size + static_cast<int>(found - outside);
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
    for (int s = 0; s < count; ++s) {
        const Supernode& supernode = dissection_.supernodes[s];
        const VectorX own = scale.segment(3 * supernode.first, 3 * supernode.size).cwiseInverse();
        VectorX rows(3 * supernode.rows);
        for (int i = 0; i < supernode.rows; ++i) {
            rows.segment<3>(3 * i) = scale.segment<3>(3 * dissection_.rows[supernode.rows_begin + i]);
        }
        const MatrixX inverse = own.asDiagonal() * factor.inverse(s) * own.asDiagonal();
        const MatrixX below = rows.asDiagonal() * factor.below(s) * own.asDiagonal();
        const Part& part = parts_[s];
        void* const to_inverse = blocks_.at(part.inverse);
        void* const to_below = blocks_.at(part.below);
        if (storage_ == Storage::half) {
            put_blocks<Eigen::half>(inverse, below, part.own_tiles, part.row_tiles, to_inverse, to_below);
        } else {
            put_blocks<float>(inverse, below, part.own_tiles, part.row_tiles, to_inverse, to_below);
        }
    }
}

void Panels::forward(const Float4* rhs, Workers& workers) {
    for (const auto& [first, count] : stages_) {
        workers.each(count, [this, rhs, begin = first](int task) { sweep(begin + task, rhs); });
    }
}

void Panels::clear() {
    std::fill(loads_.begin(), loads_.end(), Line{});
}

void Panels::backward(Float4* x, Workers& workers) {
    workers.each(static_cast<int>(shares_.size()), [this](int task) { multiply(shares_[task]); });
    for (auto stage = stages_.rbegin(); stage != stages_.rend(); ++stage) {
        workers.each((*stage)[1], [this, x, begin = (*stage)[0]](int task) { substitute(begin + task, x); });
    }
}

void Panels::sweep(int g, const Float4* rhs) {
    const Group& group = dissection_.groups[g];
    const Room& room = rooms_[g];
    for (int i = 0; i < room.size; ++i) nodes_[room.nodes + i] = scaled(scale_[group.first + i], rhs[group.first + i]);
    std::fill_n(nodes_.begin() + room.nodes + room.size, room.outside, Float4{});
    for (int i = room.begin; i < room.begin + room.children; ++i) {
        const Room& child = rooms_[children_[i]];
        const Float4* const from = &nodes_[child.nodes + child.size];
        for (int k = 0; k < child.outside; ++k) quad(nodes_[outside_slots_[child.slots + k]]) += quad(from[k]);
    }
    float* const rows = reinterpret_cast<float*>(scratch_.data() + room.scratch);
    for (int s = group.begin; s < group.end; ++s) {
        const Supernode& supernode = dissection_.supernodes[s];
        const Part& part = parts_[s];
        compact(
            &nodes_[part.nodes], supernode.size, [](int i) { return i; }, loads(part));
        std::fill_n(rows, part.row_tiles * lanes, 0.0F);
        products_.general(blocks_.at(part.below), part.row_tiles, part.own_tiles, loads(part), rows);
        const int* const slots = slots_.data() + part.slots;
        for (int i = 0; i < supernode.rows; ++i) quad(nodes_[slots[i]]) -= expand(rows + 3 * i);
    }
}

// Forces on contacts alone reach few supernodes.
bool Panels::unloaded(const Part& part) {
    return std::all_of(loads(part), loads(part) + part.own_tiles * lanes, [](float load) { return load == 0.0F; });
}

void Panels::multiply(const Share& s) {
    const Part& part = parts_[s.supernode];
    float* const answer = reinterpret_cast<float*>(answers_.data() + s.answer);
    std::fill_n(answer, part.own_tiles * lanes, 0.0F);
    if (unloaded(part)) return;
    products_.symmetric(blocks_.at(part.inverse), part.own_tiles, s.first, s.last, loads(part), answer);
}

void Panels::substitute(int g, Float4* x) {
    const Group& group = dissection_.groups[g];
    const Room& room = rooms_[g];
    for (int i = 0; i < room.outside; ++i) nodes_[room.nodes + room.size + i] = nodes_[outside_slots_[room.slots + i]];
    for (int s = group.end - 1; s >= group.begin; --s) {
        const Supernode& supernode = dissection_.supernodes[s];
        const Part& part = parts_[s];
        float* const rows = reinterpret_cast<float*>(scratch_.data() + room.scratch);
        float* const own = rows + part.row_tiles * lanes;
        const int* const slots = slots_.data() + part.slots;
        compact(
            nodes_.data(), supernode.rows, [slots](int i) { return slots[i]; }, rows);
        std::fill(rows + 3 * supernode.rows, own, 0.0F);
        std::fill_n(own, part.own_tiles * lanes, 0.0F);
        if (part.shares == 0 && !unloaded(part)) {
            products_.symmetric(blocks_.at(part.inverse), part.own_tiles, 0, part.own_tiles, loads(part), own);
        }
        for (int i = part.begin; i < part.begin + part.shares; ++i) {
            const float* const answer = reinterpret_cast<const float*>(answers_.data() + shares_[i].answer);
            for (int k = 0; k < part.own_tiles * lanes; ++k) own[k] += answer[k];
        }
        products_.transposed(blocks_.at(part.below), part.row_tiles, part.own_tiles, rows, own);
        for (int i = 0; i < supernode.size; ++i) quad(nodes_[part.nodes + i]) = expand(own + 3 * i);
    }
    for (int i = 0; i < room.size; ++i) x[group.first + i] = scaled(scale_[group.first + i], nodes_[room.nodes + i]);
}

}    // namespace stylet::corotational_fem
