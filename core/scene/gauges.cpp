#include "core/scene/gauges.h"

#include <algorithm>

namespace stylet::core {
namespace {

constexpr double mm = 1e-3;    // [m]

constexpr Gauge chart[] = {
    {"7G", 4.572 * mm, 3.810 * mm},    {"8G", 4.191 * mm, 3.429 * mm},   {"9G", 3.759 * mm, 2.997 * mm},
    {"10G", 3.404 * mm, 2.692 * mm},   {"11G", 3.048 * mm, 2.388 * mm},  {"12G", 2.769 * mm, 2.159 * mm},
    {"13G", 2.413 * mm, 1.803 * mm},   {"14G", 2.108 * mm, 1.600 * mm},  {"15G", 1.829 * mm, 1.372 * mm},
    {"16G", 1.651 * mm, 1.194 * mm},   {"17G", 1.473 * mm, 1.067 * mm},  {"18G", 1.270 * mm, 0.838 * mm},
    {"19G", 1.067 * mm, 0.686 * mm},   {"20G", 0.9081 * mm, 0.603 * mm}, {"21G", 0.8192 * mm, 0.514 * mm},
    {"22G", 0.7176 * mm, 0.413 * mm},  {"23G", 0.6414 * mm, 0.337 * mm}, {"24G", 0.5652 * mm, 0.311 * mm},
    {"25G", 0.5144 * mm, 0.260 * mm},  {"26G", 0.4636 * mm, 0.260 * mm}, {"27G", 0.4128 * mm, 0.210 * mm},
    {"28G", 0.3620 * mm, 0.184 * mm},  {"29G", 0.3366 * mm, 0.184 * mm}, {"30G", 0.3112 * mm, 0.159 * mm},
    {"31G", 0.2604 * mm, 0.133 * mm},  {"32G", 0.2350 * mm, 0.108 * mm}, {"33G", 0.2096 * mm, 0.108 * mm},
    {"34G", 0.1842 * mm, 0.0826 * mm},
};

}    // namespace

std::span<const Gauge> gauges() {
    return chart;
}

const Gauge* find_gauge(std::string_view name) {
    const auto found = std::ranges::find_if(chart, [name](const Gauge& gauge) { return name == gauge.name; });
    return found == std::end(chart) ? nullptr : &*found;
}

// Written out, for a declaration holds a plain text that is there from the beginning.
constexpr char gauge_names[] =
    "7G 8G 9G 10G 11G 12G 13G 14G 15G 16G 17G 18G 19G 20G 21G 22G 23G 24G 25G 26G 27G 28G 29G 30G 31G 32G 33G 34G";

}    // namespace stylet::core
