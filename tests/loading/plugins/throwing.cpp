#include <stylet/force_model.h>

namespace {

struct NoException {};

class Throwing : public stylet::ForceModel {
public:
    explicit Throwing(const stylet::Setup& setup) {
        const std::string& what = setup.parameters.text("what");
        if (what == "error") throw stylet::Error("found a plugin that refuses its scene");
        if (what == "exception") throw std::out_of_range("a bug");
        throw NoException{};
    }
    void add_to(const stylet::Contact&, stylet::ContactLaw&) const override {}
};

constexpr stylet::Parameter parameters[] = {
    stylet::choice("what", "error exception nothing_known", "what its constructor throws")};

}    // namespace

STYLET_PLUGIN(Throwing, "throwing", parameters, .summary = "An effect whose constructor throws", .formula = "none",
              .source = "none", .validity = "tests")
