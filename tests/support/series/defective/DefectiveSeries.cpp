// SPDX-License-Identifier: Apache-2.0
#include "tests/support/series/defective/DefectiveSeries.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <cmath>

namespace test {

SyntheticSeries tiltedSeries(double shiftMm)
{
    SyntheticSeries series;
    series.step.y = shiftMm;
    const double rowMm = series.spacing.y;
    series.stored = [rowMm, shiftMm](const glm::ivec3& index) {
        return 3 * index.x
            + int(std::lround(20.0 * (rowMm * double(index.y) + shiftMm * double(index.z))));
    };
    return series;
}

SyntheticSeries seriesAtHeights(const std::vector<double>& heightsMm)
{
    SyntheticSeries series;
    series.size.z = int(heightsMm.size());
    for (const double height : heightsMm)
        series.positions.emplace_back(series.origin.x, series.origin.y, height);
    series.stored = [heightsMm](const glm::ivec3& index) {
        return 3 * index.x + int(std::lround(20.0 * heightsMm[std::size_t(index.z)]));
    };
    return series;
}

void addDoubles(const SyntheticSeries& series, const QString& folder, int stored)
{
    SyntheticSeries more = series;
    more.size.z = 4;
    more.origin = series.position(2);
    more.fileName = [](int k) { return QStringLiteral("double%1").arg(k); };
    more.stored = [stored](const glm::ivec3&) { return stored; };
    more.adjust = [](DcmDataset& set, int k) {
        set.putAndInsertString(DCM_SOPInstanceUID, QByteArray::number(700 + k).constData());
        set.putAndInsertString(DCM_InstanceNumber, "99");
    };
    writeSeries(more, folder);
}

} // namespace test
