#include "fast/element_pass.h"

#include <Eigen/Dense>

namespace stylet::corotational_fem {

namespace sse2 {
extern const ElementKernels element_kernels;
}
namespace avx2 {
extern const ElementKernels element_kernels;
}
namespace avx512 {
extern const ElementKernels element_kernels;
}

const ElementKernels& element_kernels(InstructionSet set) {
    switch (set) {
        case InstructionSet::sse2:
            return sse2::element_kernels;
        case InstructionSet::avx2:
            return avx2::element_kernels;
        case InstructionSet::avx512:
            break;
    }
    return avx512::element_kernels;
}

void careful_rotation(const float gradient[9], float rotation[9]) {
    using Rows = Eigen::Matrix<float, 3, 3, Eigen::RowMajor>;
    Eigen::Map<Rows> result(rotation);
    result.setZero();
    const Eigen::Matrix3d g = Eigen::Map<const Rows>(gradient).cast<double>();
    if (!g.allFinite()) return;
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(Eigen::Matrix3d::Identity() + g, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Matrix3d left = svd.matrixU();
    const Eigen::Matrix3d& right = svd.matrixV();
    if (left.determinant() * right.determinant() < 0.0) left.col(2) *= -1.0;    // of the least stretch
    result = (left * right.transpose() - Eigen::Matrix3d::Identity()).cast<float>();
}

}    // namespace stylet::corotational_fem
