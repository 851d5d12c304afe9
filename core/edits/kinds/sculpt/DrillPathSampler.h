// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/LaserCut.h"

#include <optional>
#include <vector>

namespace core {

struct DrillStroke;
struct LaserStroke;
struct PenSample;

/// Makes the samples of a drill or laser stroke from the reports of the pen, piece by piece as they
/// come; the division into pieces does not matter.
///
/// By time (DrillStroke::byTime, and always in mode Rate): the path is sampled 120 times a second,
/// counted from its first sample, with straight lines in between. Places are rounded to quarters of
/// an element and pressures to 1/1024, and everything else is computed from these. So devices that
/// report the same path 30 or 250 times a second make the same cut. Two samples at the same time
/// are a corner. Otherwise the samples are the corners of the path, as in a recipe.
///
/// In both cases, points are then at most a quarter of the mask apart, but not closer than half an
/// element. In mode Rate each point adds the depth for its share of the time.
class DrillPathSampler {
public:
    DrillPathSampler(const DrillStroke& stroke, const DrillCut& cut);
    DrillPathSampler(const LaserStroke& stroke, const LaserCut& cut);

    [[nodiscard]] std::vector<DrillSample> add(const std::vector<PenSample>& samples);
    /// To be called once, when the pen is lifted: returns what is left since the last sample.
    [[nodiscard]] std::vector<DrillSample> finish();

private:
    struct Point {
        std::int64_t x = 0; ///< mm16
        std::int64_t y = 0;
        std::int64_t pressure = 0; ///< 0 … 65535
        std::int64_t time = 0; ///< 1/30000 s
    };
    void begin(const Point& first);
    void follow(const Point& from, const Point& to);
    void lookAt(const Point& point);
    void addLine(const Point& from, const Point& to, std::int64_t lasted);
    void put(const DrillSample& sample);
    [[nodiscard]] Point rounded(const Point& point) const;
    [[nodiscard]] std::int64_t depthAt(std::int64_t pressure) const;

    bool m_byTime = false;
    bool m_rate = false;
    int m_exponent = 1;
    std::int64_t m_fullDepth = 0; ///< mm16, or mm16 per second
    std::int64_t m_grid = 1; ///< mm16
    std::int64_t m_spacing = 1; ///< mm16
    std::optional<Point> m_last; ///< the last one reported
    Point m_seen; ///< the last sampled place, rounded
    std::int64_t m_nextLook = 0;
    std::vector<DrillSample> m_path;
};

/// Removes invalid reports of a device: samples that are not finite or too far away are left out,
/// pressures are clamped to 0 … 1, and time never decreases.
/// @param notBefore the time of the previous sample
[[nodiscard]] std::vector<PenSample> soundSamples(
    const std::vector<PenSample>& samples, double notBefore);

/// The whole path of a stroke.
[[nodiscard]] std::vector<DrillSample> drillPath(const DrillStroke& stroke, const DrillCut& cut);
[[nodiscard]] std::vector<DrillSample> laserPath(const LaserStroke& stroke, const LaserCut& cut);

} // namespace core
