// SPDX-License-Identifier: Apache-2.0
// Sums of Eigen's packets, threads and cache blocks would differ between machines.
#define EIGEN_DONT_VECTORIZE
#define EIGEN_DONT_PARALLELIZE
#include "core/refine/tools/ThinPlateSpline.h"

#include <eigen3/Eigen/LU>

#include <algorithm>
#include <bit>
#include <cmath>

namespace core {

namespace {

using Matrix = Eigen::MatrixXd;
using Column = Eigen::VectorXd;

/// What is left over may be this share of the greatest value.
constexpr double mostError = 1e-9;
/// Less is as good as none: points in a line, or twice.
constexpr double leastPivot = 1e-14;

/// U(r) of r².
double thinPlate(double squared)
{
    return squared > 0.0 ? 0.5 * squared * logarithmOf(squared) : 0.0;
}

/// Middle and half of the extent.
template <typename Place> double extentOf(const std::vector<Place>& places, Place& middle)
{
    Place least = places.front();
    Place most = places.front();
    for (const Place& place : places) {
        least = glm::min(least, place);
        most = glm::max(most, place);
    }
    middle = 0.5 * (least + most);
    double extent = 0.0;
    for (int axis = 0; axis < Place::length(); ++axis)
        extent = std::max(extent, 0.5 * (most[axis] - least[axis]));
    return extent > 0.0 ? extent : 1.0;
}

/// Weights of kernels and of 1, x, y …; empty: there are none.
/// @param gives by place: what is left over there, per weight; empty: nothing anywhere
template <typename Place, typename Kernel>
std::vector<double> weightsThrough(const std::vector<Place>& places,
    const std::vector<double>& values, const Kernel& kernel, const std::vector<double>& gives = {})
{
    constexpr int polynomial = 1 + Place::length();
    // By columns, so the cache decides nothing: no block is as wide as what it could hold.
    Eigen::setCpuCacheSizes(32 * 1024, 256 * 1024, 2 * 1024 * 1024);
    const auto count = Eigen::Index(places.size());
    Matrix matrix = Matrix::Zero(count + polynomial, count + polynomial);
    Column wanted = Column::Zero(count + polynomial);
    double greatest = 0.0;
    for (Eigen::Index i = 0; i < count; ++i) {
        const Place& place = places[std::size_t(i)];
        for (Eigen::Index j = 0; j < i; ++j) {
            const Place way = place - places[std::size_t(j)];
            matrix(i, j) = matrix(j, i) = kernel(glm::dot(way, way));
        }
        if (!gives.empty())
            matrix(i, i) = gives[std::size_t(i)];
        matrix(i, count) = matrix(count, i) = 1.0;
        for (int axis = 0; axis < Place::length(); ++axis)
            matrix(i, count + 1 + axis) = matrix(count + 1 + axis, i) = place[axis];
        wanted(i) = values[std::size_t(i)];
        greatest = std::max(greatest, std::abs(values[std::size_t(i)]));
    }
    const Eigen::PartialPivLU<Matrix> solver(matrix);
    const Column pivots = solver.matrixLU().diagonal().cwiseAbs();
    if (!(pivots.minCoeff() > leastPivot * pivots.maxCoeff()))
        return {};
    Column weights = solver.solve(wanted);
    // Once more for what rounding left.
    weights += solver.solve(wanted - matrix * weights);
    const double error = (matrix * weights - wanted).cwiseAbs().maxCoeff();
    if (!(error <= mostError * std::max(greatest, 1e-3)))
        return {};
    return {weights.data(), weights.data() + weights.size()};
}

tl::unexpected<Error> noneThrough()
{
    return failure(ErrorCode::InvalidField, QStringLiteral("contours"),
        Clause::saying("no surface runs through these points"));
}

} // namespace

double logarithmOf(double value)
{
    constexpr double ln2High = 0.693147180369123816490;
    constexpr double ln2Low = 1.90821492927058770002e-10;
    const auto bits = std::bit_cast<std::uint64_t>(value);
    int exponent = int((bits >> 52) & 0x7FF) - 1023;
    double mantissa = std::bit_cast<double>((bits & 0x000FFFFFFFFFFFFFULL) | 0x3FF0000000000000ULL);
    if (mantissa > 1.4142135623730951) {
        mantissa *= 0.5;
        ++exponent;
    }
    const double share = (mantissa - 1.0) / (mantissa + 1.0);
    const double squared = share * share;
    // 2 artanh: the terms fall off by more than thirty each.
    double sum = 0.0;
    for (int term = 23; term >= 1; term -= 2)
        sum = sum * squared + 1.0 / double(term);
    return double(exponent) * ln2High + (2.0 * share * sum + double(exponent) * ln2Low);
}

Result<ThinPlateSpline> ThinPlateSpline::through(std::span<const glm::dvec3> points)
{
    if (points.size() < 3)
        return noneThrough();
    ThinPlateSpline spline;
    std::vector<double> heights;
    for (const glm::dvec3& point : points) {
        spline.m_places.emplace_back(point.x, point.y);
        heights.push_back(point.z);
    }
    spline.m_scale = extentOf(spline.m_places, spline.m_middle);
    for (glm::dvec2& place : spline.m_places)
        place = (place - spline.m_middle) / spline.m_scale;
    spline.m_weights = weightsThrough(spline.m_places, heights, thinPlate);
    if (spline.m_weights.empty())
        return noneThrough();
    return spline;
}

double ThinPlateSpline::at(const glm::dvec2& place) const
{
    const glm::dvec2 here = (place - m_middle) / m_scale;
    double sum = 0.0;
    for (std::size_t i = 0; i < m_places.size(); ++i) {
        const glm::dvec2 way = here - m_places[i];
        sum += m_weights[i] * thinPlate(glm::dot(way, way));
    }
    const double* plane = m_weights.data() + m_places.size();
    return sum + plane[0] + plane[1] * here.x + plane[2] * here.y;
}

Result<VariationalBody> VariationalBody::through(std::span<const Point> points)
{
    if (points.size() < 4)
        return noneThrough();
    VariationalBody body;
    std::vector<double> values;
    std::vector<double> gives;
    for (const Point& point : points) {
        body.m_places.push_back(point.place);
        values.push_back(point.value);
        gives.push_back(point.giveMm3);
    }
    body.m_scale = extentOf(body.m_places, body.m_middle);
    for (glm::dvec3& place : body.m_places)
        place = (place - body.m_middle) / body.m_scale;
    for (double& give : gives)
        give /= body.m_scale * body.m_scale * body.m_scale;
    body.m_weights = weightsThrough(
        body.m_places, values, [](double squared) { return squared * std::sqrt(squared); }, gives);
    if (body.m_weights.empty())
        return noneThrough();
    return body;
}

VariationalBody::Value VariationalBody::at(const glm::dvec3& place) const
{
    const glm::dvec3 here = (place - m_middle) / m_scale;
    const double* plane = m_weights.data() + m_places.size();
    const glm::dvec3 slope(plane[1], plane[2], plane[3]);
    double value = plane[0] + glm::dot(slope, here);
    glm::dvec3 rise = slope;
    for (std::size_t i = 0; i < m_places.size(); ++i) {
        const glm::dvec3 way = here - m_places[i];
        const double squared = glm::dot(way, way);
        const double distance = std::sqrt(squared);
        value += m_weights[i] * squared * distance;
        rise += 3.0 * m_weights[i] * distance * way;
    }
    return {.value = value, .rise = rise / m_scale};
}

} // namespace core
