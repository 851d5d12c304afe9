// SPDX-License-Identifier: Apache-2.0
#include "ui/settings/TransferPresets.h"

#include "core/volume/SurfaceThreshold.h"

#include <QObject>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace ui {

double quantile(const core::Histogram& histogram, double share)
{
    double total = 0.0;
    for (const std::uint32_t count : histogram.counts)
        total += count;
    double below = 0.0;
    for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin) {
        below += histogram.counts[bin];
        if (below >= share * total) {
            const double width = histogram.maximum - histogram.minimum;
            return histogram.minimum + width * double(bin + 1) / double(histogram.counts.size());
        }
    }
    return histogram.maximum;
}

double quantileAbove(const core::Histogram& histogram, double from, double share)
{
    core::Histogram above = histogram;
    const double width = (histogram.maximum - histogram.minimum)
        / double(std::max<std::size_t>(histogram.counts.size(), 1));
    for (std::size_t bin = 0; bin < above.counts.size(); ++bin) {
        if (histogram.minimum + (double(bin) + 0.5) * width < from)
            above.counts[bin] = 0;
    }
    const bool nothing = std::all_of(
        above.counts.begin(), above.counts.end(), [](std::uint32_t count) { return count == 0; });
    return nothing ? std::max(from, histogram.maximum) : quantile(above, share);
}

std::vector<TransferPreset> transferPresets(const core::Volume& volume)
{
    if (volume.unit == QLatin1String("HU")) {
        return {
            // Skin and soft tissue are a haze that a quarter of a metre of it does not close;
            // contrast and bone are bright and dense.
            {QObject::tr("Standard"),
                {{{-400.0, 0x6b4a38, 0.0}, {-150.0, 0xc9a184, 0.001}, {20.0, 0xc58a6e, 0.0025},
                    {90.0, 0xcf8f70, 0.005}, {150.0, 0xdca27c, 0.03}, {220.0, 0xe3c08e, 0.12},
                    {450.0, 0xf3e3c4, 0.45}, {1200.0, 0xffffff, 0.9}}}},
            {QObject::tr("Bone"),
                {{{150.0, 0x8a4b32, 0.0}, {250.0, 0xd9a066, 0.05}, {600.0, 0xf2e4c4, 0.35},
                    {1800.0, 0xffffff, 0.8}}}},
            {QObject::tr("Skin"),
                {{{-500.0, 0xc98f6b, 0.0}, {-250.0, 0xe0ac85, 0.12}, {60.0, 0xd98a72, 0.2},
                    {300.0, 0xf2e4c4, 0.5}}}},
            {QObject::tr("Vessels"),
                {{{90.0, 0x7a1512, 0.0}, {160.0, 0xc8342a, 0.06}, {320.0, 0xf08a5c, 0.25},
                    {700.0, 0xfff1dc, 0.12}}}},
            {QObject::tr("Soft tissue"),
                {{{-80.0, 0xd9b36a, 0.0}, {0.0, 0xd08a6a, 0.02}, {60.0, 0xc65a4c, 0.06},
                    {250.0, 0xf2e4c4, 0.3}}}},
        };
    }
    // Air, which half of the voxels of a study are, and the few brightest voxels say nothing of how
    // bright tissue is: of a vessel, or of an artefact, they are several times as bright.
    const core::Histogram& histogram = volume.histogram;
    const double air = core::usualSurfaceThreshold(volume);
    const double tissue = core::otsuThreshold(histogram);
    // A constant volume has no range, and its value may be so great that less is nothing.
    const double least =
        1e-6 * std::max({volume.maximum - volume.minimum, std::abs(volume.maximum), 1e-6});
    const auto among = [&histogram, tissue](
                           double share) { return quantileAbove(histogram, tissue, share); };
    const auto ramp = [least](std::vector<gpu::TransferFunction::Point> points) {
        for (std::size_t i = 1; i < points.size(); ++i)
            points[i].value = std::max(points[i].value, points[i - 1].value + least);
        return gpu::TransferFunction{std::move(points)};
    };
    return {
        {QObject::tr("Tissue"),
            ramp({{air, 0x3a2a24, 0.0}, {tissue, 0x8a5f4c, 0.015}, {among(0.5), 0xcf9f80, 0.06},
                {among(0.9), 0xead0b4, 0.18}, {among(0.995), 0xffffff, 0.5}})},
        {QObject::tr("Bright structures"),
            ramp({{among(0.8), 0x7a3a2a, 0.0}, {among(0.93), 0xe0a070, 0.15},
                {among(0.998), 0xffffff, 0.6}})},
    };
}

} // namespace ui
