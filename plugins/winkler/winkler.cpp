#include "winkler.h"

#include "hermite_beam.h"
#include "mesh.h"

namespace stylet::winkler {
namespace {

constexpr int usual_elements = 64;
constexpr double tolerance = 1e-7;    // relative, of the interval around the load; its upper end is far closer

Pieces pieces_of(const FoundationPieces& foundation, double length, double bending_stiffness) {
    const double scale = length * length * length * length / bending_stiffness;    // [1/Pa]
    Pieces pieces;
    double end = 0.0;
    for (const FoundationPiece& piece : foundation) {
        if (!(piece.end / length > end)) continue;    // thinner than rounding
        end = std::min(piece.end / length, 1.0);
        pieces.of[pieces.size++] = {.end = end, .kappa = scale * piece.modulus};
    }
    if (end < 1.0) pieces.of[pieces.size++] = {.end = 1.0, .kappa = 0.0};    // a length below the radius
    return pieces;
}

void add_foundations(BandedPencil& pencil, const Pieces& pieces, const Nodes& nodes, int elements) {
    int e = 0;
    double begin = 0.0;
    for (std::size_t i = 0; i < pieces.size; ++i) {
        const auto [end, kappa] = pieces.of[i];
        for (; e < elements; ++e) {
            const auto n = static_cast<std::size_t>(e);
            const double left = nodes[n], right = nodes[n + 1], h = right - left;
            const double from = std::max(begin, left), to = std::min(end, right);
            if (kappa > 0.0 && to > from) add_foundation(pencil, e, h, (from - left) / h, (to - left) / h, kappa);
            if (right > end) break;    // the next piece begins in this element
        }
        begin = end;
    }
}

void hold(BandedPencil& pencil, Ends ends, int elements) {
    pencil.fix(0);
    if (ends != Ends::pinned_pinned) pencil.fix(1);
    if (ends == Ends::clamped_free) return;
    pencil.fix(2 * elements);
    if (ends == Ends::clamped_clamped) pencil.fix(2 * elements + 1);
}

}    // namespace

Winkler::Winkler(const Setup& setup)
    : foundation_(setup),
      elements_(setup.parameters.has("elements") ? static_cast<int>(setup.parameters.integer("elements")) : usual_elements) {}

double Winkler::critical_load(const Column& column) const {
    const double length = std::max(column.length(), column.radius);
    const Pieces pieces = pieces_of(foundation_.under(column), length, column.bending_stiffness);
    const double bound = bound_of_load(pieces);
    Nodes nodes;
    share_out(pieces, bound, elements_, nodes);

    BandedPencil pencil(2 * (elements_ + 1));
    for (int e = 0; e < elements_; ++e)
        add_beam(pencil, e, nodes[static_cast<std::size_t>(e) + 1] - nodes[static_cast<std::size_t>(e)]);
    add_foundations(pencil, pieces, nodes, elements_);
    hold(pencil, column.ends, elements_);
    return pencil.smallest_eigenvalue(bound, tolerance) * column.bending_stiffness / (length * length);
}

namespace {

constexpr Parameter parameters[] = {
    optional(finer_above(integer("elements", {.least = 4, .greatest = max_elements}, "of the column; left out: 64"))),
    foundation_modulus_parameter,
    given_moduli_parameter,
};

}    // namespace
}    // namespace stylet::winkler

STYLET_PLUGIN(
    stylet::winkler::Winkler, "winkler", stylet::winkler::parameters,
    .summary = "The converged critical load of a needle in layered tissue, an elastic foundation of any number of layers",
    .formula =
        "EI w'''' + P w'' + k(x) w = 0, P [N] the smallest for which some w other than zero keeps to the ends\n"
        "by cubic Hermite elements, O(h^4): K x = P G x\n"
        "EI [N m^2] bending stiffness, w [m] deflection, x [m] from base to tip, k [Pa] foundation modulus, zero in air",
    .source =
        "Hetenyi 1946, Beams on Elastic Foundation; Przemieniecki 1968, Theory of Matrix Structural Analysis, for the elements. "
        "Deviation: a length below the needle's radius counts as the radius",
    .validity =
        "Any ends, which are those of the whole needle, base and tip, however much of it is in tissue. 64 elements are within "
        "1e-6 of "
        "the converged load where d (k/EI)^(1/4), summed over the layers d thick, is up to 8, and within 1e-3 up to 50, always "
        "above. "
        "Leaves out shortening, shear, own weight, imperfections, friction along the shaft, and that tissue in one place answers "
        "to "
        "what it suffers in the next")
