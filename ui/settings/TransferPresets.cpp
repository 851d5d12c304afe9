// SPDX-License-Identifier: Apache-2.0
#include "ui/settings/TransferPresets.h"

#include <QObject>

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

std::vector<TransferPreset> transferPresets(const core::Volume& volume)
{
    if (volume.unit == QLatin1String("HU")) {
        return {
            // Skin faint, soft tissue warm, contrast and bone bright and dense.
            {QObject::tr("Standard"),
                {{{-400.0, 0x6b3b2a, 0.0}, {-150.0, 0xc98f6a, 0.004}, {20.0, 0xb5654c, 0.012},
                    {90.0, 0xc76a54, 0.03}, {220.0, 0xe3c08e, 0.12}, {450.0, 0xf3e3c4, 0.45},
                    {1200.0, 0xffffff, 0.9}}}},
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
    // Half of the voxels of a study are air around the patient; tissue starts beyond them.
    const double low = quantile(volume.histogram, 0.55);
    const double high = quantile(volume.histogram, 0.999);
    const auto at = [low, high](double share) { return low + (high - low) * share; };
    return {
        {QObject::tr("Tissue"),
            {{{at(0.0), 0x3a2a24, 0.0}, {at(0.25), 0x9a6a55, 0.03}, {at(0.6), 0xd9b090, 0.15},
                {at(1.0), 0xffffff, 0.5}}}},
        {QObject::tr("Bright structures"),
            {{{at(0.55), 0x7a3a2a, 0.0}, {at(0.75), 0xe0a070, 0.15}, {at(1.0), 0xffffff, 0.6}}}},
    };
}

} // namespace ui
