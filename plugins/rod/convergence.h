// For tests: how fast an answer nears the exact one as elements are added.
#pragma once

#include <stylet/types.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace stylet::rod {

/// An answer that the chain must near with the square of its elements' length.
struct Answer {
    std::string name;
    VectorX exact;         // any number of components, of one unit
    double coefficient;    // n elements are off by at most this over n², of the exact answer's norm (of 1 where that is zero)

    Answer(std::string name_, double exact_, double coefficient_)
        : name(std::move(name_)), exact(VectorX::Constant(1, exact_)), coefficient(coefficient_) {}
    Answer(std::string name_, VectorX exact_, double coefficient_)
        : name(std::move(name_)), exact(std::move(exact_)), coefficient(coefficient_) {}

    [[nodiscard]] double error(const VectorX& found) const {
        const VectorX off = found - exact;
        const double size = exact.norm() > 0.0 ? exact.norm() : 1.0;
        return off.size() == 1 ? off[0] / size : off.norm() / size;
    }
};

/// Solves `problem(elements)`, which returns a std::vector<VectorX> with as many answers, with 10 elements and twice as many
/// until `finest`. Prints the errors and the order fitted to the last three, and expects every answer to be of second order, and
/// off by no more than its coefficient allows from 40 elements on.
template <class Problem>
void expect_second_order(const std::vector<Answer>& answers, Problem problem, int finest = 160) {
    constexpr double fourth = 0.2;    // what terms of fourth order leave in the fitted order where bends are short
    std::vector<std::vector<double>> errors(answers.size());
    for (int elements = 10; elements <= finest; elements *= 2) {
        const std::vector<VectorX> found = problem(elements);
        for (std::size_t a = 0; a < answers.size(); ++a) {
            errors[a].push_back(answers[a].error(found[a]));
            if (elements < 40) continue;
            EXPECT_LE(std::abs(errors[a].back()), answers[a].coefficient / (elements * elements))
                << answers[a].name << " with " << elements << " elements";
        }
    }
    for (std::size_t a = 0; a < answers.size(); ++a) {
        const double order = 0.5 * std::log2(std::abs(*(errors[a].rbegin() + 2) / errors[a].back()));
        std::printf("%-42s order %.2f, errors", answers[a].name.c_str(), order);
        for (const double error : errors[a]) std::printf(" %+.1e", error);
        std::printf(" at 10, 20, ... %d\n", finest);
        EXPECT_NEAR(order, 2.0, fourth) << answers[a].name;
    }
}

/// `what` printed with `value`.
[[nodiscard]] inline std::string named(const char* what, double value) {
    std::array<char, 64> text;
    std::snprintf(text.data(), text.size(), what, value);
    return text.data();
}

[[nodiscard]] inline VectorX only(double value) {
    return VectorX::Constant(1, value);
}

}    // namespace stylet::rod
