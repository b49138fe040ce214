#include "fast/front.h"

#include <Eigen/Cholesky>

#include <algorithm>

namespace stylet::corotational_fem {

namespace {

constexpr int padding = 24;      // both of a kernel's sizes divide it
constexpr int block = 64;        // own unknowns swept out at once: enough that to read and write the front pays
constexpr int task_size = 96;    // rows or columns of a task; a multiple of the padding

int padded(int count) {
    return (count + padding - 1) / padding * padding;
}

// The first `depth` columns, for the kernel: `run` rows at a time, all columns of those one after the other.
void pack(const MatrixX& matrix, int depth, int run, std::vector<double>& into) {
    into.resize(matrix.rows() * depth);
    double* to = into.data();
    for (Eigen::Index begin = 0; begin < matrix.rows(); begin += run) {
        for (int k = 0; k < depth; ++k) to = std::copy_n(&matrix(begin, k), run, to);
    }
}

}    // namespace

Front::Front(int own, int below, const DenseKernel& kernel)
    : kernel_(kernel), own_(own), values_(MatrixX::Zero(padded(own + below), padded(own + below))) {}

bool Front::sweep(std::span<const double> least, Workers& workers) {
    for (int first = 0; first < own_; first += block) {
        if (!sweep_block(first, std::min(first + block, own_), least, workers)) return false;
    }
    return true;
}

bool Front::sweep_block(int first, int last, std::span<const double> least, Workers& workers) {
    const int depth = last - first;
    const Eigen::LLT<MatrixX> cholesky(values_.block(first, first, depth, depth));
    if (cholesky.info() != Eigen::Success) return false;
    for (int i = 0; i < depth; ++i) {
        const double root = cholesky.matrixLLT()(i, i);
        if (!(root * root > least[first + i])) return false;
    }
    const MatrixX inverse = cholesky.solve(MatrixX::Identity(depth, depth));
    take(first, last);
    multiply(inverse, workers);
    subtract(depth, workers);
    put_back(first, last, inverse);
    return true;
}

void Front::take(int first, int last) {
    const int depth = last - first;
    const Eigen::Index after = values_.rows() - last;
    columns_.resize(values_.rows(), depth);
    columns_.topRows(first) = values_.block(first, 0, depth, first).transpose();
    columns_.middleRows(first, depth).setZero();
    columns_.bottomRows(after) = values_.block(last, first, after, depth);
}

int Front::tasks() const {
    return static_cast<int>((values_.rows() + task_size - 1) / task_size);
}

// V = W S⁻¹, as 0 − W (−S⁻¹)ᵀ.
void Front::multiply(const Block& inverse, Workers& workers) {
    const int depth = static_cast<int>(inverse.rows()), wide = padded(depth);
    MatrixX negative = MatrixX::Zero(wide, depth);
    negative.topRows(depth) = -inverse;
    pack(negative, depth, kernel_.columns, inverse_);
    pack(columns_, depth, kernel_.rows, left_);
    swept_.setZero(values_.rows(), wide);
    workers.each(tasks(), [&](int task) {
        const Eigen::Index begin = task * task_size, end = std::min(begin + task_size, values_.rows());
        for (Eigen::Index row = begin; row < end; row += kernel_.rows) {
            for (int column = 0; column < wide; column += kernel_.columns) {
                kernel_.subtract_product(&left_[row * depth], &inverse_[column * depth], depth, &swept_(row, column),
                                         swept_.rows());
            }
        }
    });
}

// F −= V Wᵀ in the lower triangle, and in what the kernel's tiles reach of the upper.
void Front::subtract(int depth, Workers& workers) {
    pack(swept_, depth, kernel_.rows, left_);
    pack(columns_, depth, kernel_.columns, right_);
    workers.each(tasks(), [&](int task) {
        const Eigen::Index begin = task * task_size, end = std::min(begin + task_size, values_.rows());
        for (Eigen::Index row = begin; row < values_.rows(); row += kernel_.rows) {
            for (Eigen::Index column = begin; column < std::min(end, row + kernel_.rows); column += kernel_.columns) {
                kernel_.subtract_product(&left_[row * depth], &right_[column * depth], depth, &values_(row, column),
                                         values_.rows());
            }
        }
    });
}

void Front::put_back(int first, int last, const Block& inverse) {
    const int depth = last - first;
    const Eigen::Index after = values_.rows() - last;
    values_.block(first, 0, depth, first) = swept_.topLeftCorner(first, depth).transpose();
    values_.block(last, first, after, depth) = swept_.block(last, 0, after, depth);
    values_.block(first, first, depth, depth) = -inverse;
}

}    // namespace stylet::corotational_fem
