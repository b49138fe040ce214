#include <stylet/contract/contract.h>

namespace stylet {
namespace {

using contract::Case;

STYLET_CONTRACT(Case{.name = "Steel", .parameters = {{"foundation_modulus", "vesic"}}},
                Case{.name = "FewElements", .parameters = {{"foundation_modulus", "vesic"}, {"elements", std::int64_t{16}}}},
                Case{.name = "InAir", .has_tissue = false})

}    // namespace
}    // namespace stylet
