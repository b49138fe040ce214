#include <stylet/contract/contract.h>

namespace stylet {
namespace {

using contract::Case;

NeedleSetup free_needle() {
    NeedleSetup needle = contract::steel_needle();
    needle.ends = Ends::clamped_free;
    return needle;
}

STYLET_CONTRACT(Case{.name = "TwoTerms",
                     .parameters = {{"terms", std::int64_t{2}}, {"foundation_modulus", "vesic"}},
                     .needle = free_needle()},
                Case{.name = "ThreeTerms",
                     .parameters = {{"terms", std::int64_t{3}}, {"foundation_modulus", "vesic"}},
                     .needle = free_needle()},
                Case{.name = "InAir", .parameters = {{"terms", std::int64_t{2}}}, .needle = free_needle(), .has_tissue = false})

}    // namespace
}    // namespace stylet
