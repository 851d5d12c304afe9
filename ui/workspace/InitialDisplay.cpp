// SPDX-License-Identifier: Apache-2.0
#include "ui/workspace/InitialDisplay.h"

#include "core/volume/SurfaceThreshold.h"
#include "gpu/scene/WindowMapping.h"
#include "ui/settings/TransferPresets.h"

#include <QObject>

#include <algorithm>
#include <numeric>

namespace ui {

namespace {

/// From where tissue begins to what nearly nothing exceeds.
core::WindowLevel mipWindow(const core::Volume& volume)
{
    const double low =
        volume.unit == QLatin1String("HU") ? 0.0 : core::otsuThreshold(volume.histogram);
    const double high =
        std::max(quantile(volume.histogram, 0.9995), low + gpu::leastWindowWidth(volume.encoding));
    return {0.5 * (low + high), high - low};
}

/// From what a path through air alone would give to what one through the object alone would.
core::WindowLevel xrayWindow(const core::Volume& volume)
{
    const core::Histogram& histogram = volume.histogram;
    const double parted = core::otsuThreshold(histogram);
    const double binWidth = (histogram.maximum - histogram.minimum)
        / double(std::max<std::size_t>(histogram.counts.size(), 1));
    glm::dvec2 sum(0.0);
    glm::dvec2 count(1e-9);
    for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin) {
        const double value = histogram.minimum + (double(bin) + 0.5) * binWidth;
        const int side = value < parted ? 0 : 1;
        sum[side] += value * histogram.counts[bin];
        count[side] += histogram.counts[bin];
    }
    const double low = sum[0] / count[0];
    const double high = std::max(sum[1] / count[1], low + gpu::leastWindowWidth(volume.encoding));
    return {0.5 * (low + high), high - low};
}

} // namespace

Workspace::VolumeDisplay initialVolumeDisplay(const core::Volume& volume)
{
    Workspace::VolumeDisplay display;
    display.mipWindow = mipWindow(volume);
    display.xrayWindow = xrayWindow(volume);
    display.surfaceThreshold = core::usualSurfaceThreshold(volume);
    display.transferFunction = transferPresets(volume).front().function;
    return display;
}

glm::dvec3 initialCrosshairLps(const core::VolumeGeometry& geometry)
{
    return geometry.toWorld(glm::dvec3(geometry.size / 2));
}

std::vector<WindowPreset> windowPresets(const core::Volume& volume)
{
    if (volume.unit == QLatin1String("HU")) {
        return {{QObject::tr("Soft tissue"), {40.0, 400.0}},
            {QObject::tr("Lung"), {-600.0, 1500.0}}, {QObject::tr("Liver"), {90.0, 150.0}},
            {QObject::tr("Bone"), {480.0, 2500.0}}, {QObject::tr("Brain"), {40.0, 80.0}},
            {QObject::tr("Mediastinum"), {50.0, 350.0}}, {QObject::tr("Angio"), {300.0, 600.0}},
            {QObject::tr("Stroke"), {32.0, 12.0}},
            {QObject::tr("As stored"), volume.defaultWindow}};
    }
    const double range = std::max(
        volume.maximum - volume.minimum, std::min(gpu::leastWindowWidth(volume.encoding), 1e-6));
    const auto share = [&](double part) {
        return core::WindowLevel{volume.minimum + 0.5 * part * range, part * range};
    };
    return {{QObject::tr("As stored"), volume.defaultWindow},
        {QObject::tr("Full range"), share(1.0)}, {QObject::tr("Lower half"), share(0.5)},
        {QObject::tr("Lower quarter"), share(0.25)}};
}

} // namespace ui
