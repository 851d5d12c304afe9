// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace core {

/// The surface of least bending through points above a plane (seed B §6.5):
/// f(x) = a + b·x + Σ w_i U(|x − x_i|), U(r) = r² log r. Its bits depend on the points alone: the
/// logarithm is a series, and the solver adds in one order.
class ThinPlateSpline {
public:
    /// @param points (u, v, height), three or more that do not lie in a line, no two at one (u, v);
    /// cost ∝ n³: 20 ms for 300. Errors: InvalidField (argument 1: why there is none).
    [[nodiscard]] static Result<ThinPlateSpline> through(std::span<const glm::dvec3> points);

    /// Any thread; cost ∝ n.
    [[nodiscard]] double at(const glm::dvec2& place) const;

private:
    glm::dvec2 m_middle{0.0};
    double m_scale = 1.0; ///< places are taken in these units, from the middle
    std::vector<glm::dvec2> m_places;
    std::vector<double> m_weights; ///< of each, then a and b
};

/// A function of space that is 0 on a body's surface and positive within (Turk and O'Brien's
/// variational interpolation): f(x) = a + b·x + Σ w_i |x − x_i|³.
class VariationalBody {
public:
    struct Point {
        glm::dvec3 place{0.0};
        double value = 0.0;
    };
    /// @param points four or more that do not lie in a plane, no two at one place. Errors:
    /// InvalidField.
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

/// The natural logarithm of a positive normal number, by + − × ÷ alone.
[[nodiscard]] double logarithmOf(double value);

} // namespace core
