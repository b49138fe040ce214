// A good effect but for one thing: ALTERATION changes its descriptor before core reads it.
#include <stylet/force_model.h>

namespace {

class Nothing : public stylet::ForceModel {
public:
    explicit Nothing(const stylet::Setup&) {}
    void add_to(const stylet::Contact&, stylet::ContactLaw&) const override {}
};

constexpr stylet::Descriptor altered() {
    stylet::Descriptor descriptor{
        .stamp = stylet::build_stamp(),
        .role = Nothing::role,
        .parameter_count = 0,
        .name = NAME,
        .about = {.summary = "A library altered for tests", .formula = "none", .source = "none", .validity = "tests"},
        .parameters = nullptr,
        .create = stylet::create_plugin<Nothing>};
    ALTERATION;
    return descriptor;
}

}    // namespace

extern "C" __attribute__((visibility("default"))) const stylet::Descriptor stylet_plugin;
const stylet::Descriptor stylet_plugin = altered();
