// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/LaserCut.h"

#include <optional>
#include <vector>

namespace core {

struct DrillStroke;
struct LaserStroke;
struct PenSample;

/// Makes the samples of a stroke of drill or laser from what the pen reports, piece by piece as it
/// comes; how it is cut into pieces does not matter.
///
/// By time (DrillStroke::byTime, and always in mode Rate): the path is looked at 120 times a
/// second, counted from its first sample, straight in between; places are rounded to quarters of an
/// element and pressures to 1/1024, and all that follows is made of these. So a device that reports
/// the same path 30 or 250 times a second cuts the same. Two samples of one time are a corner.
/// Else samples are the corners of the path, as a recipe has them.
///
/// Either way points are then no farther apart than a quarter of the mask, at least half an
/// element. In mode Rate each point adds what its time is worth.
class DrillPathSampler {
public:
    DrillPathSampler(const DrillStroke& stroke, const DrillCut& cut);
    DrillPathSampler(const LaserStroke& stroke, const LaserCut& cut);

    [[nodiscard]] std::vector<DrillSample> add(const std::vector<PenSample>& samples);
    /// The pen is lifted: what is left since the last look. Once, at the end.
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
    std::int64_t m_fullDepth = 0; ///< mm16, or mm16 a second
    std::int64_t m_grid = 1; ///< mm16
    std::int64_t m_spacing = 1; ///< mm16
    std::optional<Point> m_last; ///< that was reported
    Point m_seen; ///< where it was looked at last, rounded
    std::int64_t m_nextLook = 0;
    std::vector<DrillSample> m_path;
};

/// What a device reports may be nonsense: samples that are no finite numbers within reach are left
/// out, pressures end at 0 and 1, and time never falls.
/// @param notBefore the time of the sample before
[[nodiscard]] std::vector<PenSample> soundSamples(
    const std::vector<PenSample>& samples, double notBefore);

/// The whole path of a stroke.
[[nodiscard]] std::vector<DrillSample> drillPath(const DrillStroke& stroke, const DrillCut& cut);
[[nodiscard]] std::vector<DrillSample> laserPath(const LaserStroke& stroke, const LaserCut& cut);

} // namespace core
