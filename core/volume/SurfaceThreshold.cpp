// SPDX-License-Identifier: Apache-2.0
#include "core/volume/SurfaceThreshold.h"

namespace core {

double usualSurfaceThreshold(const Volume& volume)
{
    constexpr double skinOverAirHu = -350.0;
    if (volume.unit == QLatin1String("HU"))
        return skinOverAirHu;
    // Anatomy starts well below the brightest tissue.
    return volume.minimum + 0.5 * (otsuThreshold(volume.histogram) - volume.minimum);
}

double otsuThreshold(const Histogram& histogram)
{
    const std::size_t bins = histogram.counts.size();
    if (bins < 2)
        return 0.5 * (histogram.minimum + histogram.maximum);
    double total = 0.0;
    double sum = 0.0;
    for (std::size_t bin = 0; bin < bins; ++bin) {
        total += histogram.counts[bin];
        sum += double(bin) * histogram.counts[bin];
    }
    double below = 0.0;
    double sumBelow = 0.0;
    double best = -1.0;
    std::size_t bestBin = bins / 2;
    for (std::size_t bin = 0; bin + 1 < bins; ++bin) {
        below += histogram.counts[bin];
        sumBelow += double(bin) * histogram.counts[bin];
        if (below == 0.0 || below == total)
            continue;
        const double difference = sumBelow / below - (sum - sumBelow) / (total - below);
        const double between = below * (total - below) * difference * difference;
        if (between > best) {
            best = between;
            bestBin = bin;
        }
    }
    const double binWidth = (histogram.maximum - histogram.minimum) / double(bins);
    return histogram.minimum + double(bestBin + 1) * binWidth;
}

} // namespace core
