#include <stylet/contract/contract.h>

namespace stylet {
namespace {

using contract::Case;

NeedleSetup free_needle() {
    NeedleSetup needle = contract::steel_needle();
    needle.ends = Ends::clamped_free;
    return needle;
}

STYLET_CONTRACT(
    Case{.name = "Printed", .parameters = {{"form", "printed"}, {"foundation_modulus", "vesic"}}, .needle = free_needle()},
    Case{.name = "Consistent", .parameters = {{"form", "consistent"}, {"foundation_modulus", "vesic"}}, .needle = free_needle()},
    Case{.name = "InAir", .parameters = {{"form", "printed"}}, .needle = free_needle(), .has_tissue = false})

}    // namespace
}    // namespace stylet
