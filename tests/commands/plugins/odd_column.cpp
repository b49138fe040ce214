// Answers what no buckling model may, as `answer` asks.
#include <stylet/buckling_model.h>

#include <limits>
#include <stdexcept>

namespace {

constexpr stylet::Parameter parameters[] = {stylet::choice("answer", "nothing infinity throw", "what critical_load does")};

class OddColumn final : public stylet::BucklingModel {
public:
    explicit OddColumn(const stylet::Setup& setup) : answer_(setup.parameters.text("answer")) {}
    double critical_load(const stylet::Column&) const override {
        if (answer_ == "throw") throw std::runtime_error("it snapped");
        return answer_ == "nothing" ? std::numeric_limits<double>::quiet_NaN() : std::numeric_limits<double>::infinity();
    }

private:
    std::string answer_;
};

}    // namespace

STYLET_PLUGIN(OddColumn, "odd_column", parameters, .summary = "A buckling model that answers oddly, for tests", .formula = "none",
              .source = "none", .validity = "tests")
