// The checks of each role, gathered by checks_of().
#pragma once

#include <stylet/contract/contract.h>

namespace stylet::contract {

std::vector<Check> descriptor_checks();
std::vector<Check> body_checks();    // of tissue and needle alike
std::vector<Check> tissue_checks();
std::vector<Check> needle_checks();
std::vector<Check> buckling_checks();
std::vector<Check> effect_checks();
std::vector<Check> device_checks();

}    // namespace stylet::contract
