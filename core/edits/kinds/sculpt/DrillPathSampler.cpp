// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/sculpt/DrillPathSampler.h"

#include "core/edits/engine/CutFrames.h"
#include "core/edits/fields/Quantum.h"
#include "core/edits/kinds/parts/PenSample.h"
#include "core/edits/kinds/sculpt/DrillStroke.h"
#include "core/edits/kinds/sculpt/LaserStroke.h"
#include "core/edits/kinds/sculpt/ToolMask.h"
#include "core/edits/kinds/sculpt/ToolMasks.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace core {

namespace {

constexpr std::int64_t perSecond = 30000; ///< what times are counted in
constexpr std::int64_t betweenLooks = perSecond / 120;
constexpr std::int64_t fullPressure = 65535;
/// Beyond this the mask cannot reach the volume, and coordinates would leave their range.
constexpr double farMm = 8000.0;
/// Amounts are joined up to here, far from what 32 bits hold.
constexpr std::int32_t largeAmount = 1 << 30;

std::int64_t roundedTo(std::int64_t value, std::int64_t grid)
{
    const std::int64_t moved = value + grid / 2;
    return (moved >= 0 ? moved / grid : -((-moved + grid - 1) / grid)) * grid;
}

/// a + (b − a)·part / whole, to the nearest.
std::int64_t between(std::int64_t a, std::int64_t b, std::int64_t part, std::int64_t whole)
{
    const std::int64_t scaled = (b - a) * part;
    return a + (scaled >= 0 ? (scaled + whole / 2) / whole : -((-scaled + whole / 2) / whole));
}

std::int64_t pointSpacing(const ToolMask& mask, std::int64_t pitch)
{
    if (isRound(mask))
        return std::max<std::int64_t>(mm16(mask.radiusMm) / 4, pitch / 2);
    if (mask.polygonMm)
        return 2 * pitch; // it may have thin parts anywhere
    const double thinnest =
        mask.kind == ToolMask::Kind::Square ? mask.widthMm : std::min(mask.widthMm, mask.heightMm);
    return std::max<std::int64_t>(mm16(thinnest / 8.0), pitch / 2);
}

} // namespace

DrillPathSampler::DrillPathSampler(const DrillStroke& stroke, const DrillCut& cut)
    : m_byTime(stroke.byTime || cut.mode == DrillMode::Rate)
    , m_rate(cut.mode == DrillMode::Rate)
    , m_exponent(stroke.pressureExponent)
    , m_fullDepth(mm16(stroke.depthMm))
    , m_grid(std::max(cut.frame.pitch / 4, 1))
    , m_spacing(pointSpacing(stroke.mask, cut.frame.pitch))
{
}

DrillPathSampler::DrillPathSampler(const LaserStroke& stroke, const LaserCut& cut)
    : m_byTime(stroke.byTime || cut.mode == DrillMode::Rate)
    , m_rate(cut.mode == DrillMode::Rate)
    , m_exponent(stroke.pressureExponent)
    , m_fullDepth(mm16(stroke.depthMm))
    , m_grid(std::max(cut.frame.pitch / 4, 1))
    , m_spacing(pointSpacing(stroke.mask, cut.frame.pitch))
{
}

std::vector<DrillSample> DrillPathSampler::add(const std::vector<PenSample>& samples)
{
    for (const PenSample& sample : samples) {
        if (!(std::abs(sample.xMm) < farMm && std::abs(sample.yMm) < farMm)
            || std::isnan(sample.pressure))
            continue;
        const Point to{.x = mm16(sample.xMm),
            .y = mm16(sample.yMm),
            .pressure = std::llround(std::clamp(sample.pressure, 0.0, 1.0) * fullPressure),
            .time = std::llround(sample.tSeconds * quantum::perSecond)
                * (perSecond / std::int64_t(quantum::perSecond))};
        if (!m_byTime)
            addLine(m_last.value_or(to), to, 0);
        else if (m_last)
            follow(*m_last, to);
        else
            begin(to);
        m_last = to;
    }
    return std::exchange(m_path, {});
}

std::vector<DrillSample> DrillPathSampler::finish()
{
    if (m_byTime && m_last && m_last->time > m_seen.time)
        lookAt(*m_last);
    return std::exchange(m_path, {});
}

void DrillPathSampler::begin(const Point& first)
{
    m_seen = rounded(first);
    m_nextLook = first.time + betweenLooks;
    if (!m_rate)
        addLine(m_seen, m_seen, 0);
}

void DrillPathSampler::follow(const Point& from, const Point& to)
{
    if (to.time <= from.time) {
        if (to.x != from.x || to.y != from.y || to.pressure != from.pressure)
            lookAt(to);
        return;
    }
    for (; m_nextLook <= to.time; m_nextLook += betweenLooks) {
        const std::int64_t part = m_nextLook - from.time;
        const std::int64_t whole = to.time - from.time;
        lookAt({between(from.x, to.x, part, whole), between(from.y, to.y, part, whole),
            between(from.pressure, to.pressure, part, whole), m_nextLook});
    }
}

DrillPathSampler::Point DrillPathSampler::rounded(const Point& point) const
{
    const std::int64_t steps = (point.pressure + 32) >> 6;
    return {roundedTo(point.x, m_grid), roundedTo(point.y, m_grid), steps * fullPressure / 1024,
        point.time};
}

void DrillPathSampler::lookAt(const Point& point)
{
    const Point seen = rounded(point);
    addLine(m_seen, seen, std::max<std::int64_t>(seen.time - m_seen.time, 0));
    m_seen = seen;
}

void DrillPathSampler::addLine(const Point& from, const Point& to, std::int64_t lasted)
{
    const std::int64_t dx = to.x - from.x;
    const std::int64_t dy = to.y - from.y;
    const auto length = std::int64_t(std::sqrt(double(dx * dx + dy * dy)));
    const std::int64_t pieces = std::max<std::int64_t>(1, (length + m_spacing - 1) / m_spacing);
    const std::int64_t amount =
        depthAt((from.pressure + to.pressure) / 2) * std::int64_t(256) * lasted / perSecond;
    for (std::int64_t piece = 1; piece <= pieces; ++piece) {
        const std::int64_t depth = m_rate
            ? amount * piece / pieces - amount * (piece - 1) / pieces
            : depthAt(from.pressure + (to.pressure - from.pressure) * piece / pieces);
        put({.x = std::int32_t(from.x + dx * piece / pieces),
            .y = std::int32_t(from.y + dy * piece / pieces),
            .depth = std::int32_t(std::min<std::int64_t>(depth, largeAmount))});
    }
}

void DrillPathSampler::put(const DrillSample& sample)
{
    if (m_rate && sample.depth == 0)
        return;
    if (m_byTime && !m_path.empty() && m_path.back().x == sample.x && m_path.back().y == sample.y
        && (!m_rate || m_path.back().depth < largeAmount - sample.depth)) {
        std::int32_t& depth = m_path.back().depth;
        depth = m_rate ? depth + sample.depth : std::max(depth, sample.depth);
        return;
    }
    m_path.push_back(sample);
}

std::int64_t DrillPathSampler::depthAt(std::int64_t pressure) const
{
    std::int64_t factor = pressure;
    for (int power = 1; power < m_exponent; ++power)
        factor = factor * pressure / fullPressure;
    return m_fullDepth * factor / fullPressure;
}

std::vector<PenSample> soundSamples(const std::vector<PenSample>& samples, double notBefore)
{
    std::vector<PenSample> sound;
    for (PenSample sample : samples) {
        const bool within =
            std::abs(sample.xMm) <= quantum::reachMm && std::abs(sample.yMm) <= quantum::reachMm;
        if (!within || std::isnan(sample.pressure) || !std::isfinite(sample.tSeconds))
            continue;
        sample.pressure = std::clamp(sample.pressure, 0.0, 1.0);
        sample.tSeconds = notBefore = std::max(sample.tSeconds, notBefore);
        sound.push_back(sample);
    }
    return sound;
}

namespace {

std::vector<DrillSample> wholePath(DrillPathSampler sampler, const std::vector<PenSample>& samples)
{
    std::vector<DrillSample> path = sampler.add(samples);
    const std::vector<DrillSample> rest = sampler.finish();
    path.insert(path.end(), rest.begin(), rest.end());
    return path;
}

} // namespace

std::vector<DrillSample> drillPath(const DrillStroke& stroke, const DrillCut& cut)
{
    return wholePath(DrillPathSampler(stroke, cut), stroke.samples);
}

std::vector<DrillSample> laserPath(const LaserStroke& stroke, const LaserCut& cut)
{
    return wholePath(DrillPathSampler(stroke, cut), stroke.samples);
}

} // namespace core
