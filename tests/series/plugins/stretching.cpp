// A tissue whose displacement every test knows: stretched and sheared at a constant rate, until it is nowhere.
#include <stylet/tissue_model.h>

#include <limits>

namespace {

constexpr stylet::Parameter parameters[] = {

    stylet::optional(
        stylet::number("lost_after", "s", stylet::positive, "from then on its displacement is not a number; left out: never"))};

class Stretching final : public stylet::TissueModel {
public:
    explicit Stretching(const stylet::Setup& setup) : setup_(*setup.tissue) {
        if (setup.parameters.has("lost_after")) lost_after_ = setup.parameters.number("lost_after");
    }

    void predict(double dt) override { time_ += dt; }

    // u = t·(x/10, y/5 + z/4, −z/10), lengths in m, t in s
    [[nodiscard]] stylet::Vector3 displacement(const stylet::Vector3& m) const override {
        if (time_ > lost_after_) return stylet::Vector3::Constant(std::numeric_limits<double>::quiet_NaN());
        return time_ * stylet::Vector3(m.x() / 10.0, m.y() / 5.0 + m.z() / 4.0, -m.z() / 10.0);
    }
    [[nodiscard]] stylet::Location locate(const stylet::Vector3& material) const override {
        return {.layer = -material.z() < setup_.layers.front().thickness ? 0 : 1, .depth = -material.z()};
    }

    [[nodiscard]] double entry(const stylet::Vector3&, const stylet::Vector3&) const override { return -1.0; }
    stylet::Linearisation linearise(stylet::ContactPoints, double) override {
        return {{nullptr, 0}, {nullptr, 0, 0, Eigen::OuterStride<>(1)}};    // nothing ever touches it
    }
    stylet::StepReport try_step(stylet::ContactPoints, stylet::Forces) override { return {}; }
    void commit() override {}
    void rollback() override {}
    [[nodiscard]] stylet::EnergyReport energy() const override { return {}; }

private:
    stylet::TissueSetup setup_;
    double lost_after_ = std::numeric_limits<double>::infinity();    // [s]
    double time_ = 0.0;                                              // [s]
};

}    // namespace

STYLET_PLUGIN(Stretching, "stretching", parameters, .summary = "A tissue for tests, stretched at a constant rate",
              .formula = "u = t (x/10, y/5 + z/4, -z/10)", .source = "none", .validity = "tests")
