// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace core {

/// The surface of least bending through points above a plane (seed B §6.5): f(x) = a + b·x + Σ w_i
/// U(|x − x_i|), U(r) = r² log r. The result is the same bit by bit on every machine: the logarithm
/// is a series, and the solver adds in a fixed order.
class ThinPlateSpline {
public:
    /// @param points (u, v, height), at least three that are not collinear, and no two at the same
    /// (u, v). Cost ∝ n³: 20 ms for 300 points. Errors: InvalidField (argument 1: why there is
    /// none).
    [[nodiscard]] static Result<ThinPlateSpline> through(std::span<const glm::dvec3> points);

    /// Any thread; cost ∝ n.
    [[nodiscard]] double at(const glm::dvec2& place) const;

private:
    glm::dvec2 m_middle{0.0};
    double m_scale = 1.0; ///< unit of places, which are relative to the middle
    std::vector<glm::dvec2> m_places;
    std::vector<double> m_weights; ///< one per place, then a and b
};

/// A function of space that is 0 on the surface of a body and positive inside it (variational
/// interpolation by Turk and O'Brien): f(x) = a + b·x + Σ w_i |x − x_i|³.
class VariationalBody {
public:
    struct Point {
        glm::dvec3 place{0.0};
        double value = 0.0;
        /// How much the function may deviate from the value in favour of less bending; 0: not at
        /// all.
        double giveMm3 = 0.0;
    };
    /// @param points at least four that are not coplanar, and no two at the same place
    /// Errors: InvalidField.
    [[nodiscard]] static Result<VariationalBody> through(std::span<const Point> points);

    struct Value {
        double value = 0.0;
        glm::dvec3 rise{0.0}; ///< per mm
    };
    [[nodiscard]] Value at(const glm::dvec3& place) const;

private:
    glm::dvec3 m_middle{0.0};
    double m_scale = 1.0;
    std::vector<glm::dvec3> m_places;
    std::vector<double> m_weights;
};

/// The natural logarithm of a positive normal number, computed by + − × ÷ only.
[[nodiscard]] double logarithmOf(double value);

} // namespace core
