#pragma once

#include <stylet/foundation.h>

namespace stylet::winkler {

/// The converged critical load of a column on a piecewise constant elastic foundation.
///
///     EI w⁗ + P w″ + k(x) w = 0,   P the smallest for which a w ≠ 0 keeps to the ends
///
/// by cubic Hermite elements, O(h⁴): K x = P G x. The ends are those of the whole column, base and tip; k(x) [Pa] is zero in air
/// and may jump anywhere inside an element. Source: Hetényi 1946, Beams on Elastic Foundation; Przemieniecki 1968 for the
/// elements. A length below the needle's radius counts as the radius. Leaves out what Euler leaves out, but for the tissue, whose
/// answer in one place does not depend on how the needle bends in the next. 64 elements are within 1e-6 where the sum of
/// d (k/EI)^¼ over the layers d thick is up to 8, and within 1e-3 up to 50; an answer is an upper bound.
class Winkler final : public BucklingModel {
public:
    explicit Winkler(const Setup& setup);

    double critical_load(const Column& column) const override;

private:
    Foundation foundation_;
    int elements_;
};

}    // namespace stylet::winkler
